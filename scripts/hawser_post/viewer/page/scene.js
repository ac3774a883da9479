// The picture at a time between two outputs.

const SKY = 0xf7f9fb;
const NAMED_AT = [0.5, 0.35, 0.65, 0.2, 0.8];  // positions of names along a line, in order of preference
const COARSE = 0.75;  // fraction of the pixels along a side

hawser.Scene = class {
  // box: an element that has a size; it receives the picture and its overlay.
  constructor(box, model) {
    this.model = model;
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    const over = document.createElement("canvas");
    over.className = "over";
    over.setAttribute("aria-hidden", "true");
    box.append(this.canvas, over);
    this.box = box;
    const context = this.canvas.getContext("webgl2", {antialias: !hawser.Scene.slow(), alpha: false}) || this.canvas.getContext("webgl");
    if (!context) throw new Error("the picture in three dimensions needs WebGL, which this browser does not have");
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, context});
    this.renderer.setClearColor(SKY);
    this.renderer.clear();  // otherwise a WebGL canvas is black
    this.space = new THREE.Scene();
    const sky = new THREE.HemisphereLight(0xffffff, 0x9aa4ad, 0.85);
    sky.position.set(0, 0, 1);
    this.space.add(sky);
    this.light = new THREE.DirectionalLight(0xffffff, 0.35);
    this.space.add(this.light);
    this.overlay = new hawser.Overlay(over);
    this.camera = new hawser.Camera(this.canvas, model.header, () => this.redraw());
    this.camera.partAt = (x, y) => {
      const node = this.lines ? this.nodeAt(x, y, 40) : -1;
      return node < 0 ? null : this.lines.position(node, new THREE.Vector3());
    };
    this.cuts = new hawser.Cuts(this.renderer, this.camera);
    this.colours = new hawser.Colours(model.header.maps);
    this.shown = {names: true, volumes: true, sea: true, bed: true, parts: true, touchdowns: true, forces: true, bedForces: false, notes: true};
    this.selected = -1;
    this.drawn = 0;
    this.output = 0;
    this.share = 0;
    this.reading = "Reading the lines ...";  // message before the first picture
    new ResizeObserver(() => this.resize()).observe(box);
  }

  // True if pictures are rendered in software.
  static slow() {
    if (hawser.Scene.isSlow === undefined) hawser.Scene.isSlow = hawser.Scene.software();
    return hawser.Scene.isSlow;
  }

  static software() {
    const trial = document.createElement("canvas").getContext("webgl");
    const info = trial && trial.getExtension("WEBGL_debug_renderer_info");
    const name = info ? trial.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
    if (trial) trial.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software/i.test(name);
  }

  async load() {
    const {model, space} = this;
    this.lines = await hawser.Lines.of(model);
    this.bodies = new hawser.Bodies(model);
    this.sea = new hawser.Sea(model);
    this.marks = new hawser.Marks(model);
    this.wait("Reading the sea and the bed ...");
    await this.sea.load();
    space.add(this.lines.mesh, this.bodies.root, this.sea.root, this.marks.root);
    this.paintWith(this.colours.chosen.name);
  }

  // Shows a message until there is a picture.
  wait(words) {
    this.reading = words;
    this.redraw();
  }

  // Adds the lines of another model in a colour of their own.
  async addLines(model, colour) {
    const lines = await hawser.Lines.of(model, colour);
    this.space.add(lines.mesh);
    return lines;
  }

  paintWith(map) {
    this.colours.choose(map);
    this.lines.uniforms.colours.value = this.colours.texture();
    this.lines.uniforms.steps.value = this.colours.chosen.steps;
    this.redraw();
  }

  // Blocks needed for a picture of the chosen field.
  needs() {
    const {header} = this.model;
    const names = header.lines.length ? ["position"] : [];
    if (this.field) names.push(`field/${this.field.name}`);
    if (header.bodies.length) names.push("pose");
    if (header.touchdowns.length) names.push("touchdown");
    names.push(...this.marks.blocks(this.shown));
    return [...new Set(names)];
  }

  // Shows the state between this output and the next, which must be loaded.
  set(output, share) {
    const {model} = this;
    const next = Math.min(output + 1, model.outputs - 1);
    const pair = (what) => [model.at(what, output), model.at(what, next) || model.at(what, output)];
    const [a, b] = pair("position");
    if (a) this.lines.move(a, b, share);
    if (this.field && this.ofRun) this.lines.paint(this.ofRun.values, this.ofRun.values, 0);
    else if (this.field) {
      const values = model.scalars(this.field, output);
      if (values) this.lines.paint(values, share > 0 ? model.scalars(this.field, next) || values : values, share);
    }
    const poses = pair("pose");
    if (poses[0]) this.bodies.move(...poses, share);
    if (output !== this.output || this.time === undefined || this.forget) {
      this.marks.touch(model.at("touchdown", output));
      this.marks.push(output);
      this.forget = false;
    }
    this.time = model.header.times[output] + share * (model.header.times[next] - model.header.times[output]);
    this.sea.move(this.time);
    this.output = output;
    this.share = share;
    this.redraw();
  }

  resize() {
    const [width, height] = [this.box.clientWidth, this.box.clientHeight];
    if (!width || !height) return;
    this.refine();
    this.overlay.resize(width, height, Math.min(2, window.devicePixelRatio || 1));
    this.camera.resize();
    this.draw();  // at once: a canvas of another size is black
  }

  // Sets the resolution of the picture; it is reduced during animation in software.
  refine(playing = false) {
    const ratio = Math.min(2, window.devicePixelRatio || 1) * (playing && hawser.Scene.slow() ? COARSE : 1);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.box.clientWidth, this.box.clientHeight, false);
  }

  redraw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.draw();
    });
  }

  draw() {
    if (!this.overlay.width) return;
    if (this.time === undefined) {
      this.renderer.clear();
      this.overlay.clear();
      this.overlay.text(this.reading, this.overlay.width / 2, this.overlay.height / 2, {align: "center", size: 14});
      return;
    }
    const {camera} = this.camera;
    for (const lines of [this.lines, ...(this.others || [])]) {
      lines.uniforms.pixel.value = this.camera.pixel();
      lines.uniforms.perspective.value = camera.isPerspectiveCamera ? 1 : 0;
      lines.uniforms.selected.value = this.selected;
      lines.uniforms.dash.value = 2 ** Math.ceil(Math.log2(DASH * this.camera.pixelAtTarget()));
      lines.join(this.camera, this.renderer.getPixelRatio());
    }
    Object.assign(this.lines.uniforms.low, {value: this.colours.low});
    Object.assign(this.lines.uniforms.high, {value: this.colours.high});
    this.lines.uniforms.coloured.value = this.field ? 1 : 0;
    this.bodies.show(this.shown.volumes, this.camera);
    if (this.sea.surface) this.sea.surface.visible = this.shown.sea;
    if (this.sea.bed) this.sea.bed.visible = this.shown.bed;
    this.marks.touchdowns.visible = this.shown.touchdowns && this.marks.shown > 0;
    this.marks.place(this.lines, this.camera.pixelAtTarget(), this.shown);
    this.marks.placePoints(this.lines, this.camera, this.shown.parts);
    this.light.position.copy(camera.position);
    this.renderer.render(this.space, camera);
    this.write();
    if (this.drawn === 0) this.firstAt = performance.now();
    this.drawn += 1;
  }

  // Box of a part: a body with its volumes, a volume, or an end of a line, with the size of a body.
  boxOf({body, volume, node}) {
    const box = new THREE.Box3();
    const add = (one) => box.union(this.bodies.boxOf(one));
    if (volume !== undefined) add(this.bodies.volumes[volume]);
    if (body !== undefined) this.bodies.volumes.filter((one) => one.body === body).forEach(add);
    if (!box.isEmpty()) return box;
    const at = new THREE.Vector3();
    const middle = node === undefined ? this.bodies.groups[body].getWorldPosition(at) : this.lines.position(node, at);
    return box.setFromCenterAndSize(middle, new THREE.Vector3(1, 1, 1).multiplyScalar(0.03 * this.camera.size));
  }

  // Box of the current state: lines, and centres of nearby volumes.
  boxNow() {
    const box = new THREE.Box3();
    const at = new THREE.Vector3();
    for (let i = 0; i < this.model.header.nodes; i++) box.expandByPoint(this.lines.position(i, at));
    if (box.isEmpty()) for (const volume of this.bodies.volumes) box.union(this.bodies.boxOf(volume));
    return box;
  }

  // Screen position of a place in pixels of the page; null behind the camera.
  pixelOf(place) {
    const p = place.clone().project(this.camera.camera);
    return p.z < 1 ? {x: (p.x + 1) / 2 * this.overlay.width, y: (1 - p.y) / 2 * this.overlay.height} : null;
  }

  write() {
    const {overlay} = this;
    overlay.clear();
    if (this.shown.parts) overlay.springs(this.springs());
    const badges = this.shown.notes ? this.badges() : [];
    if (this.shown.names) this.written = overlay.names(this.names(), badges.map(({x, y}) => ({x: x - 9, y: y - 9, w: 18, h: 18})));
    overlay.badges(badges);
    overlay.legend(this.colours, this.field, this.legendWords());
    overlay.scale(this.camera.pixelAtTarget());
    overlay.axes(this.camera.camera);
    const when = this.model.header.modes ? `mode ${this.output}` : `t = ${this.time.toFixed(2)} s`;
    overlay.text(when, overlay.width - 14, 22, {align: "right", bold: true, size: 14});
    let below = 40;
    for (const {kind, found} of this.marks.arrows) {
      if (!this.shown[kind] || !found.length) continue;
      const largest = this.model.largestForce(kind);
      overlay.text(`longest arrow${kind === "forces" ? "" : " of the bed"}: ${hawser.number(largest / 1e3)} kN`, overlay.width - 14, below, {align: "right"});
      below += 16;
    }
  }

  // Describes the values of the colours if they are not those of the current time, and the range of the
  // field.
  legendWords() {
    const {field} = this;
    if (!field) return [];
    const whole = field.statistics ? "over every step" : "over the outputs";
    const [low, high] = [field.low, field.high].map((value) => hawser.number(value / field.factor, (field.high - field.low) / field.factor));
    const unit = field.unit && field.unit !== "1" ? ` ${field.unit}` : "";
    return [...(this.ofRun ? [`colours: ${this.ofRun.label}`] : []), `${low} to ${high}${unit}`, whole];
  }

  names() {
    const [found, at] = [[], new THREE.Vector3()];
    const add = (words, ...places) => found.push({words, places: places.filter((pixel) => pixel)});
    this.model.header.bodies.forEach((name, k) => add(name, this.pixelOf(this.bodies.groups[k].getWorldPosition(at))));
    for (const {name, first, nodes} of this.model.header.lines.slice(0, MOST_NAMES)) {
      add(name, ...NAMED_AT.map((share) => this.pixelOf(this.lines.position(first + Math.floor(share * (nodes - 1)), at))));
    }
    if (this.shown.parts) {
      for (const {name, a, b} of this.springs()) add(name, {x: (a.x + b.x) / 2 + 6, y: (a.y + b.y) / 2});
      for (const {name, node} of this.marks.balls) if (name) add(name, this.pixelOf(this.lines.position(node, at)));
    }
    if (!this.shown.volumes) return found;
    for (const volume of this.bodies.volumes.slice(0, MOST_NAMES)) {
      if (volume.name !== this.model.header.bodies[volume.body]) add(volume.name, this.pixelOf(this.bodies.middle(volume, at)));
    }
    return found;
  }

  // Links on the screen: name and both ends.
  springs() {
    const {lines, bodies} = this;
    const placeOf = (end) => {
      const at = new THREE.Vector3();
      if (end.node !== undefined) return lines.position(end.node, at);
      return end.body === undefined ? at.fromArray(end.place) : bodies.groups[end.body].localToWorld(at.fromArray(end.at));
    };
    return this.model.header.links.map(({name, ends}) => {
      const [a, b] = ends.map((end) => this.pixelOf(placeOf(end)));
      return {name, a, b};
    }).filter(({a, b}) => a && b);
  }

  // Place of a note; null if it names no part of the model.
  placeOfNote(note, at) {
    if (note.node !== undefined) return this.lines.position(note.node, at);
    if (note.volume !== undefined && this.bodies.volumes[note.volume]) return this.bodies.middle(this.bodies.volumes[note.volume], at);
    return note.body === undefined ? null : this.bodies.groups[note.body].getWorldPosition(at);
  }

  badges() {
    const [found, at] = [[], new THREE.Vector3()];
    this.model.header.notes.forEach((note, k) => {
      const there = this.placeOfNote(note, at);
      const place = there && this.pixelOf(there);
      if (!place) return;
      // Beside the place, so that it stays visible; in rows of four if there are many.
      const badge = {x: place.x + 26, y: place.y - 26};
      for (let n = 1; found.some((b) => Math.hypot(b.x - badge.x, b.y - badge.y) < 19); n++) {
        badge.x = place.x + 26 + 20 * (n % 4);
        badge.y = place.y - 26 - 20 * Math.floor(n / 4);
      }
      found.push({number: k + 1, warning: note.kind === "warning", place, ...badge});
    });
    return found;
  }

  // Node nearest to a pixel within `reach` pixels; -1: none.
  nodeAt(x, y, reach = 12) {
    let [best, found] = [reach * reach, -1];
    const at = new THREE.Vector3();
    const matrix = new THREE.Matrix4().multiplyMatrices(this.camera.camera.projectionMatrix, this.camera.camera.matrixWorldInverse);
    const [w, h] = [this.overlay.width / 2, this.overlay.height / 2];
    let previous = null;
    for (const line of this.model.header.lines) {
      previous = null;
      for (let i = line.first; i < line.first + line.nodes; i++) {
        this.lines.position(i, at).applyMatrix4(matrix);
        const p = at.z < 1 ? [(at.x + 1) * w, (1 - at.y) * h] : null;
        const near = hawser.nearest(p, previous, x, y);
        if (near.distance < best) [best, found] = [near.distance, near.first ? i : i - 1];
        previous = p;
      }
    }
    return found;
  }

  // The picture with its overlay as PNG.
  async still() {
    this.draw();
    const whole = document.createElement("canvas");
    [whole.width, whole.height] = [this.canvas.width, this.canvas.height];
    const pen = whole.getContext("2d");
    pen.drawImage(this.canvas, 0, 0);
    pen.drawImage(this.overlay.canvas, 0, 0, whole.width, whole.height);
    return new Promise((done) => whole.toBlob(done, "image/png"));
  }
};

// Squared distance of a pixel from the segment p-q, and whether p is nearer than q.
hawser.nearest = function (p, q, x, y) {
  if (!p) return {distance: Infinity, first: true};
  if (!q) return {distance: (p[0] - x) ** 2 + (p[1] - y) ** 2, first: true};
  const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
  const share = Math.min(1, Math.max(0, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy || 1)));
  return {distance: (p[0] + share * dx - x) ** 2 + (p[1] + share * dy - y) ** 2, first: share < 0.5};
};
