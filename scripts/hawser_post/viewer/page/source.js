// Sources of header and blocks: the page itself, or the server.

const MOST_KEPT = 400e6;  // bytes of time-dependent blocks that are kept

hawser.EmbeddedSource = class {
  constructor(id) {
    this.id = id;
    this.texts = new Map();
    for (const script of document.querySelectorAll(`script[data-of="${id}"]`)) this.texts.set(script.dataset.block, script);
  }

  async header() {
    return JSON.parse(document.getElementById(`${this.id}-header`).textContent);
  }

  async bytes(name) {
    const script = this.texts.get(name);
    if (!script) throw new Error(`there is no block '${name}'`);
    return hawser.bytesOfBase64(script.textContent);
  }
};

hawser.ServedSource = class {
  constructor(base) {
    this.base = base;
    this.stamp = "";
  }

  async header() {
    const answer = await fetch(`${this.base}header`);
    if (!answer.ok) throw new Error(await answer.text());
    const header = await answer.json();
    this.stamp = header.stamp || "";
    return header;
  }

  async bytes(name) {
    const path = name.split("/").map(encodeURIComponent).join("/");
    const answer = await fetch(`${this.base}block/${path}?of=${encodeURIComponent(this.stamp)}`);
    if (!answer.ok) throw new Error(await answer.text());
    return new Uint8Array(await answer.arrayBuffer());
  }
};

// The model: its header and the contents of its blocks. Time-dependent blocks are loaded on request.
hawser.Model = class {
  constructor(source, header) {
    this.source = source;
    this.header = header;
    this.loaded = new Map();
    this.pending = new Map();
    this.kept = 0;
  }

  static async of(source) {
    return new hawser.Model(source, await source.header());
  }

  get outputs() {
    return this.header.times.length;
  }

  // A block, read once.
  async block(name, Kind) {
    if (this.loaded.has(name)) return this.loaded.get(name);
    if (!this.pending.has(name)) {
      const reading = (async () => hawser.unpacked(await this.source.bytes(name), Kind))();
      this.pending.set(name, reading);
      reading.then((block) => this.keep(name, block), () => {}).finally(() => this.pending.delete(name));
    }
    return this.pending.get(name);
  }

  // Removes the oldest blocks for new ones.
  keep(name, block) {
    this.loaded.set(name, block);
    this.kept += block.values.byteLength;
    for (const [old, what] of this.loaded) {
      if (this.kept <= MOST_KEPT || old === name) break;
      if (!/\/\d+$/.test(old)) continue;
      this.loaded.delete(old);
      this.kept -= what.values.byteLength;
    }
  }

  // Discards the last part of a run in progress, which may grow.
  forget(output) {
    const part = Math.floor(output / this.header.perBlock);
    for (const [name, block] of [...this.loaded]) {
      const found = /\/(\d+)$/.exec(name);
      if (found && Number(found[1]) >= part && !name.startsWith("volume/")) {
        this.loaded.delete(name);
        this.kept -= block.values.byteLength;
      }
    }
  }

  nameAt(what, output) {
    return `${what}/${Math.floor(output / this.header.perBlock)}`;
  }

  // Values at an output; null if not loaded.
  at(what, output) {
    const block = this.loaded.get(this.nameAt(what, output));
    if (!block) return null;
    const row = output % this.header.perBlock;
    if (row >= block.rows) return null;
    return block.values.subarray(row * block.columns, (row + 1) * block.columns);
  }

  // Waits until all of `names` are loaded at these outputs.
  async ready(names, outputs) {
    const names_of_blocks = new Set();
    for (const what of names) for (const output of outputs) names_of_blocks.add(this.nameAt(what, output));
    await Promise.all([...names_of_blocks].map((name) => this.block(name, Float32Array)));
  }

  field(name) {
    return this.header.fields.find((field) => field.name === name);
  }

  // The largest force of a kind in the run, N.
  largestForce(kind) {
    const {contacts, fields} = this.header;
    if (kind === "forces") return contacts ? contacts.largest : 0;
    return Math.max(0, ...fields.filter((field) => field.vector).map((field) => field.high));
  }

  // Scalars of a field at an output, of vectors their size.
  scalars(field, output) {
    const values = this.at(`field/${field.name}`, output);
    if (!values || !field.vector) return values;
    const n = this.header.nodes;
    const sizes = new Float32Array(n);
    for (let i = 0; i < n; i++) sizes[i] = Math.hypot(values[i], values[n + i], values[2 * n + i]);
    return sizes;
  }
};
