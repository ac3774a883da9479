// Graphs beside the picture: a field along a line at the current time, the history of its ends, and stored
// histories.

hawser.Curves = class {
  // models: [{model, label, colour}], first that of the picture.
  constructor(models) {
    this.models = models;
    this.range = new hawser.Graph();
    this.ends = new hawser.Graph();
    this.stored = new hawser.Graph();
    this.kept = [];
    this.keep = hawser.make("button", {type: "button", onclick: () => this.keepCurve()}, "Keep this curve");
    this.drop = hawser.make("button", {type: "button", onclick: () => this.dropCurves()}, "Remove kept curves");
    const bar = hawser.make("div", {class: "bar"}, this.keep, this.drop);
    this.element = hawser.make("div", {class: "graphs"}, bar, this.range.element, this.ends.element, ...this.choice(), this.stored.element);
  }

  get main() {
    return this.models[0].model;
  }

  unit(field) {
    return field.unit && field.unit !== "1" ? `${field.label} [${field.unit}]` : field.label;
  }

  // Selects a line and a field; null: none.
  async choose(line, field) {
    this.line = line;
    this.field = field;
    this.kept = [];
    for (const graph of [this.range, this.ends]) graph.element.hidden = !line || !field;
    this.keep.parentNode.hidden = !line || !field;
    if (!line || !field) return;
    this.arcs = await Promise.all(this.models.map(async ({model}) => (await model.block("arc")).values));
    this.envelope = field.statistics ? (await this.main.block(`statistics/${field.name}`)) : null;
    await this.showEnds();
  }

  // The same line and field in another model; null if missing.
  same(model) {
    const line = model.header.lines.find((other) => other.name === this.line.name);
    const field = model.field(this.field.name);
    return line && field ? {line, field} : null;
  }

  curve(k, output) {
    const {model, label, colour} = this.models[k];
    const found = this.same(model);
    const values = found && model.scalars(found.field, output);
    if (!values) return null;
    const part = (array) => array.subarray(found.line.first, found.line.first + found.line.nodes);
    return {label, colour, x: part(this.arcs[k]), y: Float32Array.from(part(values), (v) => v / found.field.factor), wide: 2};
  }

  // Updates the range graph to outputs of the models.
  at(outputs, words) {
    if (!this.line || !this.field || !this.arcs) return;
    const now = this.models.map((_, k) => this.curve(k, outputs[Math.min(k, outputs.length - 1)])).filter((curve) => curve);
    now.forEach((curve) => {
      curve.label = this.models.length > 1 ? curve.label : words;
    });
    [this.outputs, this.words] = [outputs, words];
    this.now = now;
    const curves = [...now, ...this.kept];
    if (this.envelope && this.models.length === 1) {
      const n = this.main.header.nodes;
      OF_RUN.forEach((label, row) => {
        const y = this.envelope.values.subarray(row * n + this.line.first, row * n + this.line.first + this.line.nodes);
        curves.push({label, colour: ["#5b6770", "#7a5a2e", "#8a3324"][row], dashed: row !== 1, x: now[0] ? now[0].x : [],
                     y: Float32Array.from(y, (v) => v / this.field.factor), wide: 1});
      });
    }
    this.range.show({title: `${this.line.name}, ${words}`, x: this.main.header.arcLength, y: this.unit(this.field), curves});
  }

  keepCurve() {
    for (const curve of this.now || []) {
      const label = this.models.length > 1 ? `${curve.label}, ${this.words}` : this.words;
      this.kept.push({...curve, label, dashed: true, colour: CURVE_COLOURS[(this.kept.length + 1) % CURVE_COLOURS.length], wide: 1.5});
    }
  }

  dropCurves() {
    this.kept = [];
    if (this.outputs) this.at(this.outputs, this.words);
  }

  async showEnds() {
    const curves = [];
    const line = this.line;
    for (const [k, {model, label}] of this.models.entries()) {
      const found = this.same(model);
      if (!found || model.outputs < 2) continue;
      const ends = await model.ends(found.field, found.line);
      ["end A", "end B"].forEach((name, row) => {
        curves.push({label: this.models.length > 1 ? `${name} in run ${label}` : name, colour: CURVE_COLOURS[row], dashed: k > 0, x: model.header.times,
                     y: Float32Array.from(ends[row], (v) => v / found.field.factor)});
      });
    }
    if (line !== this.line) return;
    this.ends.show({title: `Ends of ${this.line.name}`, x: this.main.header.modes ? "mode" : "time [s]", y: this.unit(this.field), curves});
  }

  // Name of column c of a history, with its unit.
  words({labels, units}, c) {
    return units[c] && units[c] !== "1" ? `${labels[c]} [${units[c]}]` : labels[c];
  }

  // List of the histories in the results.
  choice() {
    const {histories, storedHistories} = this.main.header;
    this.stored.element.hidden = true;
    if (!histories.length || !storedHistories) return [];
    const select = hawser.make("select", {onchange: () => this.showStored(select.value)}, hawser.make("option", {value: ""}, "none"));
    histories.forEach((history, h) => {
      const group = hawser.make("optgroup", {label: history.name});
      history.columns.forEach((_, c) => group.append(hawser.make("option", {value: `${h} ${c}`}, `${history.name}: ${this.words(history, c)}`)));
      select.append(group);
    });
    return [hawser.make("div", {class: "bar"}, hawser.make("label", {}, "History ", select))];
  }

  async showStored(value) {
    if (!value) {
      this.stored.element.hidden = true;
      return;
    }
    const [h, c] = value.split(" ").map(Number);
    const curves = [];
    const chosen = this.main.header.histories[h];
    for (const {model, label, colour} of this.models) {
      const history = model.header.histories.find((other) => other.name === chosen.name);
      const column = history ? history.columns.indexOf(chosen.columns[c]) : -1;
      if (column < 0) continue;
      const block = await model.block(`series/${history.key}`);
      const row = (k) => block.values.subarray(k * block.columns, (k + 1) * block.columns);
      curves.push({label: this.models.length > 1 ? label : chosen.labels[c], colour, x: row(0), y: Float32Array.from(row(column + 1), (v) => v / history.factors[column])});
    }
    this.stored.show({title: chosen.name, x: "time [s]", y: this.words(chosen, c), curves});
  }
};

// Values of a field at both ends of a line at every output.
hawser.Model.prototype.ends = async function (field, line) {
  if (this.header.served) {
    const block = await this.block(`ends/${field.name}/${this.header.lines.indexOf(line)}`);
    return [block.values.subarray(0, block.columns), block.values.subarray(block.columns)];
  }
  const found = [new Float32Array(this.outputs), new Float32Array(this.outputs)];
  for (let output = 0; output < this.outputs; output++) {
    await this.ready([`field/${field.name}`], [output]);
    const values = this.scalars(field, output);
    found[0][output] = values[line.first];
    found[1][output] = values[line.first + line.nodes - 1];
  }
  return found;
};
