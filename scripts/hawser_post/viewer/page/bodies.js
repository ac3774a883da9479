// Volumes, which move with their bodies, and a cross for each body.

const MOST_EDGES = 30000;  // triangles of a mesh above which no edges are drawn
const FIXED = 0xb4bec8;                                   // volumes without a body
const TONES = [0xa9bfd3, 0xd0bfa6, 0xafc4b0, 0xc7b7ca];   // volumes of successive bodies
const SMALL = 30;          // pixels: edges of volumes of a smaller radius are not drawn

const FLAT_VERTEX = `
varying vec3 place;
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  place = mvPosition.xyz;
  #include <clipping_planes_vertex>
}`;

// One normal per face, towards the viewer: that of the plane of neighbouring pixels.
const FLAT_FRAGMENT = `
uniform vec3 colour;
varying vec3 place;
#include <clipping_planes_pars_fragment>
void main() {
  #include <clipping_planes_fragment>
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  float sky = 0.5 + 0.5 * dot(normal, viewMatrix[2].xyz);
  gl_FragColor = vec4(colour * (0.5 + 0.35 * sky + 0.35 * max(normal.z, 0.0)), 1.0);
}`;

hawser.Bodies = class {
  constructor(model) {
    this.model = model;
    this.root = new THREE.Group();
    this.groups = model.header.bodies.map(() => new THREE.Group());
    for (const group of this.groups) this.root.add(group);
    this.volumes = [];
    this.paints = new Map();
    this.edge = new THREE.LineBasicMaterial({color: 0x5b6873});
  }

  // Volumes with few large faces (flat) have one normal per face, which the shader computes.
  paint(body, flat) {
    const colour = body >= 0 ? TONES[body % TONES.length] : FIXED, key = `${colour} ${flat}`;
    const paint = {side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1};
    if (!this.paints.has(key))
      this.paints.set(key, flat
        ? new THREE.ShaderMaterial({...paint, vertexShader: FLAT_VERTEX, fragmentShader: FLAT_FRAGMENT, clipping: true,
                                    extensions: {derivatives: true}, uniforms: {colour: {value: new THREE.Color(colour)}}})
        : new THREE.MeshLambertMaterial({...paint, color: colour}));
    return this.paints.get(key);
  }

  async load(size) {
    for (const volume of this.model.header.volumes) {
      const vertices = await this.model.block(`volume/${volume.key}/vertices`, Float32Array);
      const triangles = await this.model.block(`volume/${volume.key}/triangles`, Uint32Array);
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(vertices.values, 3));
      geometry.setIndex(new THREE.BufferAttribute(triangles.values, 1));
      const flat = triangles.rows <= MOST_EDGES;
      const mesh = new THREE.Mesh(geometry, this.paint(volume.body, flat));
      if (flat) mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), this.edge));
      else geometry.computeVertexNormals();
      geometry.computeBoundingSphere();
      const {center, radius} = geometry.boundingSphere;
      this.volumes.push({mesh, name: volume.name, middle: center.clone(), radius, body: volume.body});
      (volume.body >= 0 ? this.groups[volume.body] : this.root).add(mesh);
    }
    this.groups.forEach((group, k) => {
      const radii = this.volumes.filter((volume) => volume.body === k).map((volume) => volume.radius);
      const cross = new THREE.AxesHelper(Math.min(0.03 * size, ...radii.length ? [Math.max(...radii)] : []));
      cross.material.depthTest = false;
      group.add(cross);
    });
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

  show(volumes, camera) {
    const at = new THREE.Vector3();
    for (const volume of this.volumes) {
      volume.mesh.visible = volumes;
      for (const edges of volume.mesh.children) edges.visible = volume.radius > SMALL * camera.pixelAt(this.middle(volume, at));
    }
  }

  // Bounding box of a volume in its current pose. (That of three.js includes edges, which round shapes lack,
  // and becomes NaN.)
  boxOf(volume) {
    volume.mesh.geometry.computeBoundingBox();
    return volume.mesh.geometry.boundingBox.clone().applyMatrix4(volume.mesh.matrixWorld);
  }

  // Position of a volume's name.
  middle(volume, target) {
    return target.copy(volume.middle).applyMatrix4(volume.mesh.matrixWorld);
  }
};
