// Camera: perspective, or orthographic from above or from the side.

const FIELD_OF_VIEW = 30;  // deg
const [MARGIN_WIDE, MARGIN_HIGH] = [1.2, 1.3];
const WHEEL = 0.002;  // logarithm of the zoom per unit of wheel motion; a notch of 100 units is about a fifth

hawser.Camera = class {
  constructor(canvas, header, changed) {
    this.canvas = canvas;
    this.low = new THREE.Vector3(...header.low);
    this.high = new THREE.Vector3(...header.high);
    this.size = Math.max(this.high.distanceTo(this.low), 1e-3);
    const make = (camera) => {
      camera.up.set(0, 0, 1);
      const controls = new THREE.OrbitControls(camera, canvas);
      controls.enableKeys = false;  // keys are handled below
      controls.enableZoom = false;  // the wheel is handled below
      controls.addEventListener("change", changed);
      return {camera, controls};
    };
    this.deep = make(new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, this.size / 2000, this.size * 40));
    this.flat = make(new THREE.OrthographicCamera(-1, 1, 1, -1, -this.size * 20, this.size * 40));
    this.flat.controls.enableRotate = false;
    // Without the focus on the picture the wheel scrolls the page.
    canvas.addEventListener("wheel", (event) => {
      if (document.activeElement !== canvas) return;
      event.preventDefault();
      const notches = event.deltaMode === 1 ? 33 * event.deltaY : event.deltaY;  // lines to pixels
      this.zoom(Math.exp(-WHEEL * notches), this.placeUnder(event.offsetX, event.offsetY));
    }, {passive: false});
    this.changed = changed;
    this.look("space");
  }

  // Current direction of view.
  from() {
    return this.now.camera.position.clone().sub(this.now.controls.target).normalize();
  }

  get camera() {
    return this.now.camera;
  }

  // "space", "plan", or an elevation along the horizontal direction `across`.
  look(view, across = [1, 0]) {
    this.view = view;
    this.across = across;
    this.now = view === "space" ? this.deep : this.flat;
    for (const one of [this.deep, this.flat]) one.controls.enabled = one === this.now;
    const direction = {space: [0.55, -0.75, 0.36], plan: [0, -1e-4, 1], elevation: [across[1], -across[0], 0]}[view];
    this.direction = new THREE.Vector3(...direction).normalize();
    this.fit();
  }

  // Fits the whole model, or a box, into the picture.
  fit(low = this.low, high = this.high) {
    const middle = low.clone().add(high).multiplyScalar(0.5);
    const {camera, controls} = this.now;
    const away = Math.max(low.distanceTo(high), 1e-3);
    camera.position.copy(middle).addScaledVector(this.direction, away);
    controls.target.copy(middle);
    camera.lookAt(middle);
    camera.updateMatrixWorld(true);
    const to_view = new THREE.Matrix4().getInverse(camera.matrixWorld);
    const slope = Math.tan(FIELD_OF_VIEW * Math.PI / 360);
    this.half = {wide: 1e-6, high: 1e-6};
    let depth = 1e-3;
    for (let k = 0; k < 8; k++) {
      const p = new THREE.Vector3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z).applyMatrix4(to_view);
      const [x, y] = [Math.abs(p.x) * MARGIN_WIDE, Math.abs(p.y) * MARGIN_HIGH];
      this.half = {wide: Math.max(this.half.wide, x), high: Math.max(this.half.high, y)};
      depth = Math.max(depth, Math.max(x / this.aspect(), y) / slope + p.z + away);
    }
    if (camera === this.deep.camera) camera.position.copy(middle).addScaledVector(this.direction, depth);
    camera.zoom = 1;
    this.resize();
    controls.update();
    camera.updateMatrixWorld(true);
    this.changed();
  }

  aspect() {
    return Math.max(0.1, this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight));
  }

  resize() {
    const aspect = this.aspect();
    this.deep.camera.aspect = aspect;
    this.deep.camera.updateProjectionMatrix();
    const flat = this.flat.camera;
    const high = Math.max(this.half ? this.half.high : 1, this.half ? this.half.wide / aspect : 1);
    [flat.top, flat.bottom, flat.left, flat.right] = [high, -high, -high * aspect, high * aspect];
    flat.updateProjectionMatrix();
  }

  // Width of a pixel [m] at the target; for the perspective camera at depth 1.
  pixel() {
    const {camera} = this.now;
    if (camera === this.deep.camera) return 2 * Math.tan(FIELD_OF_VIEW * Math.PI / 360) / Math.max(1, this.canvas.clientHeight);
    return (camera.top - camera.bottom) / camera.zoom / Math.max(1, this.canvas.clientHeight);
  }

  // Width of a pixel [m] at a place.
  pixelAt(place) {
    const {camera} = this.now;
    return camera === this.deep.camera ? this.pixel() * camera.position.distanceTo(place) : this.pixel();
  }

  pixelAtTarget() {
    return this.pixelAt(this.now.controls.target);
  }

  // Rotates by angles (rad) about the vertical and towards it.
  turn(around, up) {
    const {camera, controls} = this.now;
    if (camera !== this.deep.camera) return this.shift(around * 200, up * 200);
    const from = camera.position.clone().sub(controls.target);
    const place = new THREE.Spherical().setFromVector3(new THREE.Vector3(from.y, from.z, from.x));
    place.theta += around;
    place.phi = Math.min(Math.PI - 0.02, Math.max(0.02, place.phi + up));
    const to = new THREE.Vector3().setFromSpherical(place);
    camera.position.set(to.z, to.x, to.y).add(controls.target);
    controls.update();
    return this.changed();
  }

  // Shifts by pixels.
  shift(right, down) {
    const {camera, controls} = this.now;
    const scale = this.pixelAtTarget();
    const by = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 0).multiplyScalar(right * scale);
    by.addScaledVector(new THREE.Vector3().setFromMatrixColumn(camera.matrix, 1), -down * scale);
    camera.position.add(by);
    controls.target.add(by);
    controls.update();
    this.changed();
  }

  // Place under a pixel: on a part of the model, by partAt(x, y), else at the depth of the target.
  placeUnder(x, y) {
    const part = this.partAt && this.partAt(x, y);
    if (part) return part;
    const {camera, controls} = this.now;
    const depth = controls.target.clone().project(camera).z;
    return new THREE.Vector3(2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight, depth).unproject(camera);
  }

  // Zooms by a factor about a place, which keeps its position on the screen.
  zoom(factor, place = this.now.controls.target.clone()) {
    const {camera, controls} = this.now;
    controls.target.sub(place).divideScalar(factor).add(place);
    if (camera === this.deep.camera) camera.position.sub(place).divideScalar(factor).add(place);
    else {
      camera.zoom *= factor;
      camera.position.copy(controls.target).addScaledVector(this.direction, this.size);
    }
    camera.updateProjectionMatrix();
    controls.update();
    camera.updateMatrixWorld(true);  // the next wheel event may come before the next picture
    this.changed();
  }

  // Centres the picture on a place.
  centre(place) {
    const {camera, controls} = this.now;
    const by = place.clone().sub(controls.target);
    camera.position.add(by);
    controls.target.add(by);
    controls.update();
    this.changed();
  }

  key(event) {
    const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (turns && event.shiftKey) this.shift(40 * turns[0], 40 * turns[1]);
    else if (turns) this.turn(0.1 * turns[0], 0.1 * turns[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(1.25);
    else if (event.key === "-") this.zoom(0.8);
    else if (event.key === "Home") this.fit();
    else return false;
    return true;
  }
};
