// Assembles the viewer.

const GRAPH_EVERY = 1000;  // ms

hawser.View = class {
  constructor(root, model, others) {
    this.root = root;
    this.model = model;
    this.others = others || [];
    this.chosen = model.header.lines.length ? 0 : -1;
    this.picture = hawser.make("div", {class: "picture"});
    root.append(this.picture);
    this.scene = new hawser.Scene(this.picture, model);
    this.field = model.field("effective_tension") || model.header.fields[0];
    this.scene.field = this.field;
    this.player = new hawser.Player(this.scene, (output) => this.show(output));
    this.player.ended = () => this.play(false);
    this.player.failed = (error) => this.fail(error);
    this.controls = new hawser.Controls(this);
    this.curves = new hawser.Curves([{model, label: model.header.label || model.header.title}, ...this.others]);
    this.side = hawser.make("div", {class: "side"}, this.curves.element, this.notes());
    root.append(this.controls.element, this.side);
    this.graphAt = 0;
    this.clicks();
  }

  async load() {
    await this.scene.load();
    this.scene.others = [];
    for (const other of this.others) {
      other.lines = await this.scene.addLines(other.model, other.colour);
      // Each model has an origin of its own.
      other.lines.mesh.position.fromArray([0, 1, 2].map((c) => other.model.header.centre[c] - this.model.header.centre[c]));
      this.scene.others.push(other.lines);
    }
    this.limit(true);
    const {header} = this.model;
    this.scene.wait("Reading the first picture ...");
    this.scene.resize();
    this.scene.camera.fit();  // the controls have determined its size
    await this.player.show(header.served && !header.ended ? this.model.outputs - 1 : 0);  // for a run in progress the latest
    // Volumes may be many; the first picture does not wait for them.
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    await this.scene.bodies.load(this.scene.camera.size);
    await this.player.show(this.player.output);
    await this.choose(this.chosen);
    this.pace();
  }

  // A run of minutes is played in about a quarter of a minute.
  pace() {
    if (this.speedChosen) return;
    const {times} = this.model.header;
    const speed = SPEEDS.filter((s) => s <= Math.max(1, (times[times.length - 1] - times[0]) / 15)).pop();
    this.player.speed = speed;
    this.controls.speed.value = String(speed);
  }

  notes() {
    const {notes, missing} = this.model.header;
    const list = hawser.make("ol", {class: "notes", "aria-label": "Notes and warnings"});
    for (const note of notes) {
      const item = hawser.make("li", {class: note.kind}, note.text);
      const at = new THREE.Vector3();
      if ([note.node, note.volume, note.body].some((place) => place !== undefined)) {
        item.append(" ", hawser.make("button", {type: "button", "aria-label": `Show the place of note ${list.children.length + 1}`,
                                                onclick: () => this.scene.camera.centre(this.scene.placeOfNote(note, at))}, "Show"));
      }
      list.append(item);
    }
    const rest = hawser.make("ul", {class: "missing"}, ...missing.map((words) => hawser.make("li", {}, words)));
    return hawser.make("div", {}, ...(notes.length ? [list] : []), ...(missing.length ? [rest] : []));
  }

  when(output) {
    const time = this.model.header.times[output];
    return this.model.header.modes ? `mode ${output}` : `t = ${time.toFixed(2)} s`;
  }

  // Updates the controls to output `output`; other models show the output nearest in time.
  show(output) {
    const time = this.model.header.times[output];
    const outputs = [output];
    for (const other of this.others) {
      const {times} = other.model.header;
      const k = times.reduce((best, t, i) => (Math.abs(t - time) < Math.abs(times[best] - time) ? i : best), 0);
      outputs.push(k);
      const names = ["position", ...(this.field && other.model.field(this.field.name) ? [`field/${this.field.name}`] : [])];
      other.model.ready(names, [k]).then(() => {
        const x = other.model.at("position", k);
        other.lines.move(x, x, 0);
        this.curves.at(outputs, this.when(output));
        this.scene.redraw();
      }).catch((error) => this.fail(error));
    }
    this.controls.show(output, this.when(output));
    // During animation the graph is updated less often than the picture.
    if (!this.player.playing || performance.now() - this.graphAt > GRAPH_EVERY) {
      this.curves.at(outputs, this.when(output));
      this.graphAt = performance.now();
    }
    this.describe();
  }

  // Description of the picture.
  describe() {
    const {field, scene, model} = this;
    const line = model.header.lines[this.chosen];
    const parts = [this.when(this.player.output)];
    if (field) {
      const unit = field.unit && field.unit !== "1" ? ` ${field.unit}` : "";
      const [low, high] = [scene.colours.low / field.factor, scene.colours.high / field.factor];
      const range = `${hawser.number(low, 100 * (high - low))} to ${hawser.number(high, 100 * (high - low))}${unit}`;
      parts.push(`lines coloured by ${field.label}${scene.ofRun ? ` (${scene.ofRun.label})` : ""}, ${range}; grey where the value is undefined`);
    }
    if (line) parts.push(`chosen: ${line.name}`);
    if (scene.cuts.kind !== "none") parts.push(scene.cuts.describe(model.header.centre));
    this.controls.status.textContent = this.player.playing ? "Playing." : `${parts.join("; ")}.`;
  }

  fail(error) {
    this.controls.status.textContent = `Not shown: ${error.message || error}.`;
  }

  play(on) {
    this.player.play(on);
    this.scene.refine(this.player.playing);
    this.controls.play.textContent = this.player.playing ? "Pause" : "Play";
    this.describe();
  }

  async paint(name) {
    this.field = this.model.field(name) || null;
    this.controls.fieldList.value = this.field ? name : "";
    this.scene.field = this.field;
    this.limit(true);
    await this.values(this.scene.ofRun ? this.scene.ofRun.label : "");
    await this.choose(this.chosen);
  }

  // Selects the colours: current values (""), or the least, mean or largest value of the run at each node.
  async values(label) {
    const {scene, field, controls} = this;
    const row = field && field.statistics ? OF_RUN.indexOf(label) : -1;
    controls.values.parentNode.hidden = !field || !field.statistics;
    controls.values.value = row < 0 ? "" : label;
    const n = this.model.header.nodes;
    const block = row < 0 ? null : await this.model.block(`statistics/${field.name}`);
    scene.ofRun = block && {label, values: block.values.subarray(row * n, (row + 1) * n)};
    await this.player.show(this.player.output);
  }

  // Limits of the colours: the whole range, or the numbers entered.
  limit(whole) {
    const {field, scene, controls} = this;
    if (!field) return scene.redraw();
    this.whole = whole;
    if (whole) {
      const signed = field.low < 0 && field.high > 0 && scene.colours.chosen.signed;
      const most = Math.max(-field.low, field.high);
      [scene.colours.low, scene.colours.high] = signed ? [-most, most] : [field.low, field.high];
      controls.limits(scene.colours.low / field.factor, scene.colours.high / field.factor);
    } else {
      const [low, high] = [Number(controls.low.value), Number(controls.high.value)];
      if (high > low) [scene.colours.low, scene.colours.high] = [low * field.factor, high * field.factor];
    }
    this.describe();
    return scene.redraw();
  }

  async choose(k) {
    this.chosen = k;
    this.scene.selected = k;
    this.controls.lineList.value = String(k);
    await this.curves.choose(this.model.header.lines[k] || null, this.field);
    this.show(this.player.output);
    this.scene.redraw();
  }

  // Fits the current lines, or a part, into the picture from the current direction.
  fitNow(box = this.scene.boxNow()) {
    const {camera} = this.scene;
    camera.direction = camera.from();
    camera.fit(box.min, box.max);
  }

  look(name) {
    this.controls.lookList.value = name;
    const across = {x: [1, 0], y: [0, 1], lines: this.model.header.across}[name];
    this.scene.camera.look(across ? "elevation" : name, across);
    this.cut(this.scene.cuts.kind, Number(this.controls.cutAt.value));
  }

  cut(kind, share) {
    this.scene.cuts.set(kind, share);
    this.controls.cutAt.disabled = kind === "none";
    this.controls.cutAt.setAttribute("aria-valuetext", this.scene.cuts.describe(this.model.header.centre));
    this.scene.redraw();
    this.describe();
  }

  async save() {
    const png = await this.scene.still();
    const link = hawser.make("a", {href: URL.createObjectURL(png), download: `${this.model.header.title} ${this.when(this.player.output)}.png`});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  // A click without rotation selects a line.
  clicks() {
    const {canvas} = this.scene;
    let from = null;
    canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      canvas.focus({preventScroll: true});
    });
    canvas.addEventListener("pointerup", (event) => {
      if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4) return;
      const box = canvas.getBoundingClientRect();
      const node = this.scene.nodeAt(event.clientX - box.left, event.clientY - box.top);
      const k = this.model.header.lines.findIndex((line) => node >= line.first && node < line.first + line.nodes);
      if (k >= 0) this.choose(k);
    });
  }
};

// Starts the viewer in an element; shows a message if it fails.
hawser.start = async function (root) {
  try {
    const began = performance.now();
    const source = (name) => (root.dataset.base ? new hawser.ServedSource(name) : new hawser.EmbeddedSource(name));
    const model = await hawser.Model.of(source(root.dataset.base || root.id));
    const others = [];
    for (const name of (root.dataset.others || "").split(" ").filter((n) => n)) {
      const other = await hawser.Model.of(source(name));
      others.push({model: other, label: other.header.label || other.header.title, colour: "#b3470f"});
    }
    root.textContent = "";
    const view = new hawser.View(root, model, others);
    await view.load();
    view.ready = true;
    view.began = began;
    window.hawserView = view;
    if (model.header.served) document.title = `${model.header.title} - hawser view`;
    if (hawser.follow) hawser.follow(view, root);
  } catch (error) {
    root.textContent = `The model is not shown in three dimensions: ${error.message || error}.`;
    root.classList.add("failed");
    window.hawserFailed = String(error.stack || error);
  }
};

window.hawserParts = hawser;
for (const root of document.querySelectorAll(".hawser-view")) hawser.start(root);
if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", hawser.figures);
else hawser.figures();
