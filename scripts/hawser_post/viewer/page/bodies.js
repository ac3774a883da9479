// Volumes, which move with their bodies, and a cross for each body.

const MOST_EDGES = 30000;  // triangles of a mesh whose edges are drawn

hawser.Bodies = class {
  constructor(model) {
    this.model = model;
    this.root = new THREE.Group();
    this.groups = model.header.bodies.map(() => new THREE.Group());
    for (const group of this.groups) this.root.add(group);
    this.volumes = [];
    this.material = new THREE.MeshLambertMaterial({color: 0xb4bec8, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1,
                                                   polygonOffsetUnits: 1});
    this.edge = new THREE.LineBasicMaterial({color: 0x5b6873});
  }

  async load(size) {
    for (const volume of this.model.header.volumes) {
      const vertices = await this.model.block(`volume/${volume.key}/vertices`, Float32Array);
      const triangles = await this.model.block(`volume/${volume.key}/triangles`, Uint32Array);
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(vertices.values, 3));
      geometry.setIndex(new THREE.BufferAttribute(triangles.values, 1));
      const flat = triangles.rows <= MOST_EDGES;
      // Few large faces have a normal each.
      const shown = flat ? geometry.toNonIndexed() : geometry;
      shown.computeVertexNormals();
      const mesh = new THREE.Mesh(shown, this.material);
      if (flat) mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), this.edge));
      geometry.computeBoundingSphere();
      this.volumes.push({mesh, name: volume.name, middle: geometry.boundingSphere.center.clone(), body: volume.body});
      (volume.body >= 0 ? this.groups[volume.body] : this.root).add(mesh);
    }
    for (const group of this.groups) {
      const cross = new THREE.AxesHelper(0.03 * size);
      cross.material.depthTest = false;
      group.add(cross);
    }
  }

  // Poses between two outputs: position and rotation (w, x, y, z) of each body.
  move(a, b, share) {
    const q = new THREE.Quaternion();
    this.groups.forEach((group, k) => {
      const o = 7 * k;
      group.position.set(...[0, 1, 2].map((c) => a[o + c] + share * (b[o + c] - a[o + c])));
      group.quaternion.set(a[o + 4], a[o + 5], a[o + 6], a[o + 3]);
      if (share > 0) group.quaternion.slerp(q.set(b[o + 4], b[o + 5], b[o + 6], b[o + 3]), share);
    });
    this.root.updateMatrixWorld(true);
  }

  show(volumes) {
    for (const {mesh} of this.volumes) mesh.visible = volumes;
  }

  // Where the name of a volume stands.
  middle(volume, target) {
    return target.copy(volume.middle).applyMatrix4(volume.mesh.matrixWorld);
  }
};
