// Sea surface with waves, and the bed.

const SEA_PLACES = {slow: 30, fast: 72};  // points along a side
const [TROUGH, CREST] = [[0.16, 0.42, 0.62], [0.62, 0.82, 0.95]];  // colours

hawser.Sea = class {
  constructor(model) {
    this.model = model;
    this.root = new THREE.Group();
  }

  async load() {
    const {sea, bed} = this.model.header;
    if (bed) this.addBed((await this.model.block("bed")).values);
    if (sea) this.addSurface(sea, sea.waves ? (await this.model.block("waves")).values : new Float64Array(0));
  }

  // A surface over a grid of points.
  grid(x, y) {
    const positions = new Float32Array(3 * x.length * y.length);
    const faces = [];
    for (let j = 0; j < y.length; j++) {
      for (let i = 0; i < x.length; i++) {
        const k = j * x.length + i;
        positions[3 * k] = x[i];
        positions[3 * k + 1] = y[j];
        if (i + 1 < x.length && j + 1 < y.length) faces.push(k, k + 1, k + x.length, k + 1, k + x.length + 1, k + x.length);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setIndex(faces);
    return geometry;
  }

  // Border of a surface, the only part visible from the side.
  border(geometry, nx, ny, colour) {
    const around = [];
    for (let i = 0; i < nx; i++) around.push(i);
    for (let j = 1; j < ny; j++) around.push(j * nx + nx - 1);
    for (let i = nx - 2; i >= 0; i--) around.push((ny - 1) * nx + i);
    for (let j = ny - 2; j > 0; j--) around.push(j * nx);
    const edge = new THREE.BufferGeometry();
    edge.setAttribute("position", geometry.getAttribute("position"));
    edge.setIndex(around);
    const line = new THREE.LineLoop(edge, new THREE.LineBasicMaterial({color: colour}));
    line.frustumCulled = false;
    return line;
  }

  addBed(values) {
    const [nx, ny] = [values[0], values[1]];
    const x = values.subarray(2, 2 + nx);
    const y = values.subarray(2 + nx, 2 + nx + ny);
    const z = values.subarray(2 + nx + ny);
    const geometry = this.grid(x, y);
    const at = geometry.getAttribute("position");
    const known = Array.from(z, (v) => v === v);
    z.forEach((v, k) => at.setZ(k, v === v ? v : 0));
    const whole = Array.from(geometry.index.array);
    const faces = [];
    for (let i = 0; i < whole.length; i += 3) if (known[whole[i]] && known[whole[i + 1]] && known[whole[i + 2]]) faces.push(...whole.slice(i, i + 3));
    geometry.setIndex(faces);
    geometry.computeVertexNormals();
    const paint = {polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2};
    const plane = nx === 2 && ny === 2;  // needs no lighting
    this.bed = new THREE.Mesh(geometry, plane ? new THREE.MeshBasicMaterial({...paint, color: 0xb5a27d}) : new THREE.MeshLambertMaterial({...paint, color: 0xcdb891}));
    // The bed is transparent from below.
    this.bed.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({color: 0xb5a27d, side: THREE.BackSide, transparent: true, opacity: 0.3, depthWrite: false})));
    if (known.every((k) => k)) this.bed.add(this.border(geometry, nx, ny, 0x8a6d3b));
    this.root.add(this.bed);
  }

  addSurface(sea, waves) {
    const [low, high] = this.model.header.border;
    const most = hawser.Scene.slow() ? SEA_PLACES.slow : SEA_PLACES.fast;
    const cell = Math.max(high[0] - low[0], high[1] - low[1]) / (most - 1);
    const long = [];  // waves that the grid resolves
    for (let k = 0; k + 5 < waves.length; k += 6) if (waves[k + 2] * cell <= Math.PI) long.push(waves.subarray(k, k + 6));
    const count = long.length ? most : 2;
    const places = (a, b) => Float32Array.from({length: count}, (_, k) => a + (b - a) * k / (count - 1));
    const x = places(low[0], high[0]);
    const y = places(low[1], high[1]);
    this.geometry = this.grid(x, y);
    this.geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(3 * count * count).fill(0.6), 3));
    const colour = long.length ? {vertexColors: THREE.VertexColors} : {color: 0x3f8fc4};
    const paint = {...colour, transparent: true, opacity: 0.3, side: THREE.DoubleSide, depthWrite: false};
    this.surface = new THREE.Mesh(this.geometry, new THREE.MeshBasicMaterial(paint));
    this.surface.renderOrder = 2;
    this.components = [];
    const at = this.geometry.getAttribute("position");
    for (const [a, omega, number, dx, dy, phase] of long) {
      const cosine = new Float32Array(at.count);
      const sine = new Float32Array(at.count);
      for (let i = 0; i < at.count; i++) {
        const angle = number * (dx * at.getX(i) + dy * at.getY(i)) + phase;
        cosine[i] = a * Math.cos(angle);
        sine[i] = a * Math.sin(angle);
      }
      this.components.push({amplitude: a, omega, cosine, sine});
    }
    // Standard deviation of the surface; 1 without waves.
    this.height = Math.sqrt(this.components.reduce((sum, one) => sum + one.amplitude ** 2 / 2, 0)) || 1;
    this.surface.frustumCulled = false;
    this.surface.add(this.border(this.geometry, count, count, 0x2f78ad));
    this.root.add(this.surface);
    this.move(this.model.header.times[0]);
  }

  // Updates the waves to a time.
  move(time) {
    if (!this.surface || time === this.time) return;
    if (this.time !== undefined && !this.components.length) return;  // still water
    this.time = time;
    const {sea} = this.model.header;
    const at = this.geometry.getAttribute("position").array;
    const count = at.length / 3;
    const z = new Float32Array(count);
    const part = sea.ramp > 0 ? Math.min(1, Math.max(0, time / sea.ramp)) : 1;
    const ramp = part ** 3 * (10 + part * (6 * part - 15));
    for (const {omega, cosine, sine} of this.components) {
      const c = ramp * Math.cos(omega * time);
      const s = ramp * Math.sin(omega * time);
      for (let i = 0; i < count; i++) z[i] += c * cosine[i] + s * sine[i];
    }
    const colours = this.geometry.getAttribute("color");
    for (let i = 0; i < count; i++) {
      at[3 * i + 2] = sea.level + z[i];
      const share = Math.min(1, Math.max(0, 0.5 + 0.35 * z[i] / this.height));
      for (let c = 0; c < 3; c++) colours.array[3 * i + c] = TROUGH[c] + share * (CREST[c] - TROUGH[c]);
    }
    this.geometry.getAttribute("position").needsUpdate = true;
    colours.needsUpdate = true;
  }
};
