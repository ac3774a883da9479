// Buttons, lists and sliders, each with a name, and the sentence that describes the picture.

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];
const OF_RUN = ["minimum of the run", "mean of the run", "maximum of the run"];
const SIZES = [1, 2, 5, 10, 20, 50];
const SHOWN = {names: "Names", volumes: "Volumes", sea: "Sea", bed: "Bed", parts: "Links, masses, joints", touchdowns: "Touchdown points", forces: "Contact forces", bedForces: "Bed forces", notes: "Notes"};

hawser.labelled = function (words, control) {
  return hawser.make("label", {}, `${words} `, control);
};

hawser.choice = function (words, options, chosen, changed) {
  const select = hawser.make("select", {onchange: () => changed(select.value)});
  for (const [value, name] of options) select.append(hawser.make("option", {value, selected: String(value) === String(chosen)}, name));
  return {select, element: hawser.labelled(words, select)};
};

hawser.Controls = class {
  constructor(view) {
    this.view = view;
    const {scene, model} = view;
    this.time = this.timeBar();
    this.status = hawser.make("p", {class: "status", role: "status"});
    this.element = hawser.make("div", {class: "controls"}, this.time, this.lookBar(), this.viewBar(), this.showBar(), this.status);
    const keys = "Arrow keys rotate the model, with Shift they move it, plus and minus zoom, Home shows the whole model, space plays, a click selects a line";
    scene.canvas.setAttribute("aria-label", `Model in three dimensions of ${model.header.title}. ${keys}`);
    scene.canvas.title = keys;
    scene.canvas.addEventListener("keydown", (event) => {
      if (event.key === " ") view.play(!view.player.playing);
      else if (!scene.camera.key(event)) return;
      event.preventDefault();
    });
  }

  timeBar() {
    const {player, model} = this.view;
    const step = (by) => {
      this.view.play(false);
      player.show(player.output + by);
    };
    this.play = hawser.make("button", {type: "button", class: "play", onclick: () => this.view.play(!player.playing)}, "Play");
    const back = hawser.make("button", {type: "button", "aria-label": "Previous output", onclick: () => step(-1)}, "◀");
    const on = hawser.make("button", {type: "button", "aria-label": "Next output", onclick: () => step(1)}, "▶");
    this.slider = hawser.make("input", {type: "range", min: 0, max: model.outputs - 1, step: 1, value: 0,
                                        "aria-label": model.header.modes ? "Mode" : "Time",
                                        oninput: () => {
                                          if (player.playing) this.view.play(false);
                                          player.show(Number(this.slider.value));
                                        }});
    this.clock = hawser.make("span", {class: "clock"});
    const speed = hawser.choice("Speed", SPEEDS.map((s) => [s, `${s} ×`]), 1, (value) => {
      player.speed = Number(value);
      this.view.speedChosen = true;
    });
    this.speed = speed.select;
    const bar = hawser.make("div", {class: "bar"}, this.play, back, on, this.slider, this.clock, speed.element);
    bar.hidden = model.outputs < 2;
    return bar;
  }

  lookBar() {
    const {view} = this;
    const {scene, model} = view;
    const coloured = model.header.fields.length > 0;
    const fields = [["", "nothing"], ...model.header.fields.map((field) => [field.name, field.unit ? `${field.label} [${field.unit}]` : field.label])];
    const field = hawser.choice("Colour by", fields, view.field ? view.field.name : "", (name) => view.paint(name));
    const map = hawser.choice("Colours", model.header.maps.map((m) => [m.name, m.label]), scene.colours.chosen.name, (name) => scene.paintWith(name));
    const values = hawser.choice("Values", [["", "at the time shown"], ...OF_RUN.map((label) => [label, label])], "", (label) => view.values(label));
    this.values = values.select;
    values.element.hidden = !view.field || !view.field.statistics;
    this.low = hawser.make("input", {type: "number", step: "any", onchange: () => view.limit()});
    this.high = hawser.make("input", {type: "number", step: "any", onchange: () => view.limit()});
    const whole = hawser.make("button", {type: "button", onclick: () => view.limit(true)}, "Whole range of colours");
    const lines = model.header.lines.map((line, k) => [k, line.name]);
    const line = hawser.choice("Line", [[-1, "none"], ...lines], view.chosen, (k) => view.choose(Number(k)));
    this.lineList = line.select;
    this.fieldList = field.select;
    this.mapList = map.select;
    const colours = [field.element, values.element, map.element, hawser.labelled("from", this.low), hawser.labelled("to", this.high), whole];
    return hawser.make("div", {class: "bar"}, ...(coloured ? colours : []), line.element);
  }

  viewBar() {
    const {view} = this;
    const {scene, model} = view;
    const looks = [["space", "in space"], ["plan", "from above"], ["x", "from the side, x to the right"], ["y", "from the side, y to the right"]];
    if (model.header.across) looks.push(["lines", "from the side, along the lines"]);
    const look = hawser.choice("View", looks, "space", (name) => view.look(name));
    this.lookList = look.select;
    const size = hawser.choice("Diameter", SIZES.map((s) => [s, s === 1 ? "true" : `${s} times`]), 1, (value) => {
      for (const lines of [scene.lines, ...(scene.others || [])]) lines.uniforms.enlarged.value = Number(value);
      scene.redraw();
    });
    this.cutAt = hawser.make("input", {type: "range", min: 0, max: 1, step: 0.005, value: 0.5, "aria-label": "Position of the cut", disabled: true,
                                       oninput: () => view.cut(cut.select.value, Number(this.cutAt.value))});
    const cut = hawser.choice("Cut", [["none", "none"], ["plan", "level (plan)"], ["elevation", "upright (elevation)"]], "none",
                              (kind) => view.cut(kind, Number(this.cutAt.value)));
    const fit = hawser.make("button", {type: "button", onclick: () => scene.camera.fit()}, "Show all");
    const now = hawser.make("button", {type: "button", onclick: () => view.fitNow()}, "Show lines");
    const parts = this.parts();
    const part = hawser.choice("Show", [["", "a part"], ...parts.map(({name}, k) => [k, name])], "", (k) => {
      if (k !== "") view.fitNow(scene.boxOf(parts[k]));
    });
    const near = hawser.make("button", {type: "button", "aria-label": "Nearer", onclick: () => scene.camera.zoom(1.25)}, "+");
    this.part = part.select;
    const far = hawser.make("button", {type: "button", "aria-label": "Farther", onclick: () => scene.camera.zoom(0.8)}, "−");
    const still = hawser.make("button", {type: "button", onclick: () => view.save()}, "Save picture");
    return hawser.make("div", {class: "bar"}, look.element, fit, now, ...(parts.length ? [part.element] : []), near, far, size.element, cut.element, this.cutAt, still);
  }

  // Parts for close views: bodies, volumes and ends of lines.
  parts() {
    const {header} = this.view.model;
    const bodies = header.bodies.map((name, body) => ({name, body}));
    const volumes = header.volumes.map(({name}, volume) => ({name, volume})).filter(({name}) => !header.bodies.includes(name));
    const ends = header.lines.flatMap(({name, first, nodes}) => [{name: `${name}, end A`, node: first}, {name: `${name}, end B`, node: first + nodes - 1}]);
    return [...bodies, ...volumes, ...ends];
  }

  showBar() {
    const {scene} = this.view;
    const boxes = Object.entries(SHOWN).filter(([name]) => this.there(name)).map(([name, words]) => {
      const box = hawser.make("input", {type: "checkbox", checked: scene.shown[name], onchange: () => {
        scene.shown[name] = box.checked;
        scene.forget = true;
        this.view.player.show(this.view.player.output);
      }});
      return hawser.make("label", {}, box, ` ${words}`);
    });
    return hawser.make("div", {class: "bar"}, ...boxes);
  }

  // Whether the model has what a box would hide.
  there(name) {
    const {model} = this.view;
    const {header} = model;
    const has = {volumes: header.volumes.length, sea: header.sea, bed: header.bed, touchdowns: header.touchdowns.length,
                 forces: model.largestForce("forces") > 0 || (header.contacts && !header.ended), bedForces: model.largestForce("bedForces") > 0, parts: header.links.length + header.points.length, notes: header.notes.length};
    return name === "names" || Boolean(has[name]);
  }

  // Limits of the colours in the displayed unit.
  limits(low, high) {
    const short = (value) => (Math.abs(value) <= 1e-4 * (high - low) ? 0 : Number(value.toPrecision(5)));
    [this.low.value, this.high.value] = [short(low), short(high)];
  }

  show(output, words) {
    this.slider.value = output;
    this.slider.setAttribute("aria-valuetext", words);
    this.clock.textContent = words;
    this.play.textContent = this.view.player.playing ? "Pause" : "Play";
  }
};
