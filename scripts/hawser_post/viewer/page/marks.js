// Touchdown points, forces at points of contact and of the bed at nodes as arrows, buoys, weights and joints.

const MOST_ARROWS = 300;  // of each kind; the largest are drawn
const SMALLEST_ARROW = 0.02;  // fraction of the largest force of the run below which arrows are not drawn
const LONGEST_ARROW = 80;  // pixels at the centre of the picture
const ARROW_COLOURS = {forces: 0xa31515, bedForces: 0x6b4410};
const POINT_COLOURS = {buoy: 0xe8912d, weight: 0x3a3f46, joint: 0x3a3f46};
const TOUCHDOWN = 11;          // pixels across
const LEAST_POINT = {buoy: 5, weight: 5, joint: 3.5};  // radius, pixels

// A white disc with a dark rim, visible on lines of every colour.
hawser.disc = function () {
  const picture = document.createElement("canvas");
  picture.width = picture.height = 64;
  const pen = picture.getContext("2d");
  pen.beginPath();
  pen.arc(32, 32, 25, 0, 2 * Math.PI);
  [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = ["white", "#16202b", 12];
  pen.fill();
  pen.stroke();
  return new THREE.CanvasTexture(picture);
};

hawser.Marks = class {
  constructor(model) {
    this.model = model;
    this.root = new THREE.Group();
    this.arrows = Object.keys(ARROW_COLOURS).map((kind) => this.arrowsOf(kind));
    this.addTouchdowns(model.header.touchdowns.length * 2);
    this.addPoints();
  }

  addTouchdowns(count) {
    const geometry = new THREE.BufferGeometry();
    this.points = new Float32Array(3 * Math.max(1, count));
    geometry.setAttribute("position", new THREE.BufferAttribute(this.points, 3));
    const paint = {map: hawser.disc(), size: TOUCHDOWN, sizeAttenuation: false, depthTest: false, alphaTest: 0.5};
    this.touchdowns = new THREE.Points(geometry, new THREE.PointsMaterial(paint));
    this.touchdowns.frustumCulled = false;
    this.touchdowns.visible = count > 0;
    this.root.add(this.touchdowns);
  }

  // Arrows of the forces of one kind: their drawings, and those of an output.
  arrowsOf(kind) {
    // Forces between bodies act inside the other body: they are visible through it, as touchdown points are through the bed.
    const paint = new THREE.MeshBasicMaterial({color: ARROW_COLOURS[kind], depthTest: kind !== "forces"});
    const shaft = new THREE.CylinderBufferGeometry(0.018, 0.018, 0.75, 6).translate(0, 0.375, 0);
    const head = new THREE.ConeBufferGeometry(0.06, 0.25, 8).translate(0, 0.875, 0);
    const meshes = [shaft, head].map((geometry) => {
      const mesh = new THREE.InstancedMesh(geometry, paint, MOST_ARROWS);
      mesh.frustumCulled = false;
      mesh.count = 0;
      if (!paint.depthTest) mesh.renderOrder = 1;
      this.root.add(mesh);
      return mesh;
    });
    return {kind, meshes, found: []};
  }

  // Spheres at buoys, weights and joints.
  addPoints() {
    const ball = new THREE.SphereBufferGeometry(1, 12, 8);
    const paints = {};
    this.balls = this.model.header.points.map((point) => {
      const {kind} = point;
      paints[kind] = paints[kind] || new THREE.MeshLambertMaterial({color: POINT_COLOURS[kind]});
      const mesh = new THREE.Mesh(ball, paints[kind]);
      this.root.add(mesh);
      return {...point, mesh};
    });
  }

  // Places the spheres at their nodes, with their size or a minimum in pixels.
  placePoints(lines, camera, visible) {
    for (const {kind, node, radius, mesh} of this.balls) {
      mesh.visible = visible;
      lines.position(node, mesh.position);
      mesh.scale.setScalar(Math.max(radius, LEAST_POINT[kind] * camera.pixelAt(mesh.position)));
    }
  }

  // Touchdown points at an output: six numbers per line, from end A and from end B.
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

  // Blocks needed for the arrows shown.
  blocks(shown) {
    const names = shown.bedForces ? this.model.header.fields.filter((field) => field.vector).map((field) => `field/${field.name}`) : [];
    if (shown.forces && this.model.largestForce("forces") > 0) names.push("contact/place", "contact/force");
    return names;
  }

  // Forces of a kind at an output, with their nodes or places.
  forcesAt(kind, output) {
    const {model} = this;
    const found = [];
    const add = (values, where) => {
      const n = values.length / 3;
      for (let i = 0; i < n; i++) {
        const force = [values[i], values[n + i], values[2 * n + i]];
        found.push({size: Math.hypot(...force), force, ...where(i, n)});
      }
    };
    if (kind === "forces") {
      const [places, forces] = ["place", "force"].map((what) => model.at(`contact/${what}`, output));
      if (places && forces) add(forces, (i, n) => ({at: [places[i], places[n + i], places[2 * n + i]]}));
      return found;
    }
    for (const field of model.header.fields.filter(({vector}) => vector)) {
      const values = model.at(`field/${field.name}`, output);
      if (values) add(values, (i) => ({node: i}));
    }
    return found;
  }

  // Selects the largest forces at an output.
  push(output) {
    for (const arrows of this.arrows) {
      const least = SMALLEST_ARROW * this.model.largestForce(arrows.kind);
      const found = this.forcesAt(arrows.kind, output).filter(({size}) => size > least);
      found.sort((a, b) => b.size - a.size);
      found.length = Math.min(found.length, MOST_ARROWS);
      arrows.found = found;
    }
  }

  // Places the arrows; `pixel`: length of a pixel at the centre of the picture.
  place(lines, pixel, shown) {
    const up = new THREE.Vector3(0, 1, 0);
    const [at, way, turn, scale, matrix] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3(), new THREE.Matrix4()];
    for (const {kind, meshes, found} of this.arrows) {
      const largest = this.model.largestForce(kind);
      for (const mesh of meshes) mesh.visible = shown[kind];
      if (!shown[kind]) continue;
      found.forEach((arrow, k) => {
        const {size, force} = arrow;
        turn.setFromUnitVectors(up, way.fromArray(force).normalize());
        scale.setScalar(LONGEST_ARROW * pixel * size / largest);
        matrix.compose(arrow.at ? at.fromArray(arrow.at) : lines.position(arrow.node, at), turn, scale);
        for (const mesh of meshes) mesh.setMatrixAt(k, matrix);
      });
      for (const mesh of meshes) {
        mesh.count = found.length;
        mesh.instanceMatrix.needsUpdate = true;
      }
    }
  }
};
