// Touchdown points, and forces of contact as arrows at the nodes they act on.

const MOST_ARROWS = 300;      // the largest
const SMALLEST_ARROW = 0.02;  // of the largest force of the run: smaller ones are not drawn
const LONGEST_ARROW = 80;      // pixels at the middle of the picture

hawser.Marks = class {
  constructor(model) {
    this.model = model;
    this.root = new THREE.Group();
    this.forces = model.header.fields.filter((field) => field.vector);
    this.largest = Math.max(0, ...this.forces.map((field) => field.high));
    this.addPoints(model.header.touchdowns.length * 2);
    this.addArrows();
  }

  addPoints(count) {
    const geometry = new THREE.BufferGeometry();
    this.points = new Float32Array(3 * Math.max(1, count));
    geometry.setAttribute("position", new THREE.BufferAttribute(this.points, 3));
    this.touchdowns = new THREE.Points(geometry, new THREE.PointsMaterial({color: 0xb3261e, size: 9, sizeAttenuation: false, depthTest: false}));
    this.touchdowns.frustumCulled = false;
    this.touchdowns.visible = count > 0;
    this.root.add(this.touchdowns);
  }

  addArrows() {
    const paint = new THREE.MeshBasicMaterial({color: 0xa31515});
    const shaft = new THREE.CylinderBufferGeometry(0.018, 0.018, 0.75, 6).translate(0, 0.375, 0);
    const head = new THREE.ConeBufferGeometry(0.06, 0.25, 8).translate(0, 0.875, 0);
    this.arrows = [shaft, head].map((geometry) => {
      const mesh = new THREE.InstancedMesh(geometry, paint, MOST_ARROWS);
      mesh.frustumCulled = false;
      mesh.count = 0;
      this.root.add(mesh);
      return mesh;
    });
  }

  // Touchdown points at an output: of each line six numbers, seen from its end A and from its end B.
  touch(values) {
    const places = values ? values.length / 3 : 0;
    let count = 0;
    for (let k = 0; k < places; k++) {
      const p = [values[3 * k], values[3 * k + 1], values[3 * k + 2]];
      if (!p.every(Number.isFinite)) continue;
      this.points.set(p, 3 * count);
      count += 1;
    }
    this.touchdowns.geometry.setDrawRange(0, count);
    this.touchdowns.geometry.getAttribute("position").needsUpdate = true;
    this.shown = count;
  }

  // The largest forces at an output.
  push(output) {
    const n = this.model.header.nodes;
    const found = [];
    for (const field of this.forces) {
      const f = this.model.at(`field/${field.name}`, output);
      if (!f) continue;
      for (let i = 0; i < n; i++) {
        const size = Math.hypot(f[i], f[n + i], f[2 * n + i]);
        if (size > SMALLEST_ARROW * this.largest) found.push({node: i, size, force: [f[i], f[n + i], f[2 * n + i]]});
      }
    }
    found.sort((a, b) => b.size - a.size);
    found.length = Math.min(found.length, MOST_ARROWS);
    this.found = found;
  }

  // Their arrows; `pixel` is the length of a pixel in the middle of the picture.
  place(lines, pixel) {
    const up = new THREE.Vector3(0, 1, 0);
    const [at, way, turn, scale, matrix] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3(), new THREE.Matrix4()];
    const found = this.found || [];
    found.forEach(({node, size, force}, k) => {
      const length = LONGEST_ARROW * pixel * size / this.largest;
      turn.setFromUnitVectors(up, way.fromArray(force).normalize());
      scale.setScalar(length);
      matrix.compose(lines.position(node, at), turn, scale);
      for (const mesh of this.arrows) mesh.setMatrixAt(k, matrix);
    });
    for (const mesh of this.arrows) {
      mesh.count = found.length;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
};
