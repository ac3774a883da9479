// All lines in one draw call. A line is a band that faces the viewer and is shaded as a tube: two vertices
// per node, whose neighbours are read from the same buffer.

const LEAST_WIDTH = 2.2;       // pixels
const SELECTED_WIDTH = 6;
const OVER_WIDTH = 5;  // of lines of another model: dashes with a white edge over those of the first
const DASH = 18;  // pixels, minimum length of a dash with its gap
const SHORT = 3;  // pixels: elements are joined up to this length

const LINE_VERTEX = `
attribute vec3 before, after;
attribute float side, radius, scalar, number, arc;
uniform float pixel, perspective, enlarged, leastWidth, selectedWidth, selected, over;
varying float value, across, along;
#include <clipping_planes_pars_vertex>
void main() {
  vec3 at = position + modelMatrix[3].xyz;
  vec3 toEye = perspective > 0.5 ? cameraPosition - at : vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]);
  vec3 outward = side * normalize(cross(after - before, toEye) + vec3(1e-12));
  float depth = perspective > 0.5 ? max(-(viewMatrix * vec4(at, 1.0)).z, 0.0) : 1.0;
  float width = abs(number - selected) < 0.5 ? selectedWidth : leastWidth;
  float half_width = max(radius * enlarged, 0.5 * width * pixel * depth);
  vec4 mvPosition = viewMatrix * vec4(at + half_width * outward, 1.0);
  // Nearer to the viewer by one width, at the same position in the picture.
  if (perspective > 0.5) mvPosition.xyz *= 1.0 - over * min(2.0 * half_width / max(depth, 1e-6), 0.5);
  else mvPosition.z += over * 2.0 * half_width;
  gl_Position = projectionMatrix * mvPosition;
  across = side;
  along = arc;
  value = scalar;
  #include <clipping_planes_vertex>
}`;

// The colour at mid-width is that of the legend; it is darker towards the sides.
const LINE_FRAGMENT = `
uniform sampler2D colours;
uniform vec3 single, noNumber;
uniform float low, high, coloured, steps, over, dash;
varying float value, across, along;
#include <clipping_planes_pars_fragment>
void main() {
  #include <clipping_planes_fragment>
  if (over > 0.5 && fract(along / dash) > 0.6) discard;
  float share = high > low ? clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
  vec3 colour = texture2D(colours, vec2((share * (steps - 1.0) + 0.5) / steps, 0.5)).rgb;
  if (value > 1e37) colour = noNumber;
  if (coloured < 0.5) colour = single;
  if (over > 0.5 && abs(across) > 0.6) colour = vec3(1.8);  // white where the side is shaded
  float faces = sqrt(max(0.0, 1.0 - across * across));
  gl_FragColor = vec4(colour * (0.55 + 0.45 * smoothstep(0.0, 0.75, faces)), 1.0);
}`;

const HIDDEN = 3e38;  // represents NaN

hawser.Lines = class {
  static async of(model, single) {
    return new hawser.Lines(model, (await model.block("radius")).values, (await model.block("arc")).values, single);
  }

  // `arcs`: m, of the nodes from end A of their line; `single`: one colour for all instead of values, for
  // dashes over another model.
  constructor(model, radii, arcs, single) {
    this.model = model;
    const {lines} = model.header;
    // Each line has an additional place before its first node and after its last.
    this.places = lines.reduce((sum, line) => sum + line.nodes + 2, 0);
    this.positions = new Float32Array(6 * this.places);
    this.values = new Float32Array(2 * this.places);
    this.radii = new Float32Array(2 * this.places);
    this.placeOf = new Int32Array(model.header.nodes);
    const numbers = new Float32Array(2 * this.places);
    const along = new Float32Array(2 * this.places);
    const sides = Float32Array.from({length: 2 * this.places}, (_, k) => (k % 2 ? 1 : -1));
    this.longest = new Float32Array(lines.length);  // longest element of each line, m
    this.strides = new Int32Array(lines.length).fill(1);
    let place = 0;
    lines.forEach((line, number) => {
      for (let i = 0; i < line.nodes; i++) {
        if (i > 0) this.longest[number] = Math.max(this.longest[number], arcs[line.first + i] - arcs[line.first + i - 1]);
        const k = 2 * (place + 1 + i);
        this.placeOf[line.first + i] = place + 1 + i;
        this.radii.fill(radii[line.first + i], k, k + 2);
        along.fill(arcs[line.first + i], k, k + 2);
      }
      numbers.fill(number, 2 * place, 2 * (place + line.nodes + 2));
      place += line.nodes + 2;
    });
    this.mesh = new THREE.Mesh(this.geometry({number: numbers, side: sides, arc: along}), this.material(single));
    this.mesh.frustumCulled = false;
    this.mesh.visible = lines.length > 0;
  }

  // `fixed`: constant attributes by name.
  geometry(fixed) {
    const geometry = new THREE.BufferGeometry();
    const last = 2 * this.places - 4;  // vertices with neighbours
    const buffer = (values, size) => {
      const found = new THREE.InterleavedBuffer(values, size);
      found.setUsage(THREE.DynamicDrawUsage);
      return found;
    };
    // Vertex k belongs to place 1 + k / 2; all buffers are read from there.
    const of = (data, place) => {
      const found = new THREE.InterleavedBufferAttribute(data, data.stride, 2 * place * data.stride);
      Object.defineProperty(found, "count", {value: last});
      return found;
    };
    this.positionBuffer = buffer(this.positions, 3);
    this.valueBuffer = buffer(this.values, 1);
    ["before", "position", "after"].forEach((name, k) => geometry.setAttribute(name, of(this.positionBuffer, k)));
    geometry.setAttribute("scalar", of(this.valueBuffer, 1));
    for (const [name, values] of Object.entries({radius: this.radii, ...fixed})) {
      geometry.setAttribute(name, of(buffer(values, 1), 1));
    }
    this.faces = new THREE.BufferAttribute(new Uint32Array(6 * this.places), 1);
    geometry.setIndex(this.faces);
    return geometry;
  }

  // Connects nodes with a position; several elements are joined where they are shorter than a pixel or two.
  connect(lost) {
    let count = 0;
    const faces = this.faces.array;
    this.model.header.lines.forEach((line, number) => {
      const first = this.placeOf[line.first];
      const last = first + line.nodes - 1;
      const stride = lost ? 1 : this.strides[number];
      for (let place = first; place < last; place += stride) {
        const next = Math.min(place + stride, last);
        if (lost && (lost[place] || lost[next])) continue;
        const [k, m] = [2 * (place - 1), 2 * (next - 1)];
        faces.set([k, k + 1, m, k + 1, m + 1, m], count);
        count += 6;
      }
    });
    this.mesh.geometry.setDrawRange(0, count);
    this.faces.needsUpdate = true;
  }

  // Joins elements that are short in the current view; `fine`: pixels of the picture per pixel of the page.
  join(camera, fine) {
    const at = new THREE.Vector3();
    let changed = false;
    this.model.header.lines.forEach((line, number) => {
      const pixels = [0, (line.nodes - 1) >> 1, line.nodes - 1].map((i) => camera.pixelAt(this.position(line.first + i, at)));
      const elements = SHORT * Math.min(...pixels) / fine / this.longest[number];
      const stride = elements >= 2 ? 2 ** Math.min(6, Math.floor(Math.log2(elements))) : 1;
      changed = changed || stride !== this.strides[number];
      this.strides[number] = stride;
    });
    if (changed && this.broken === false) this.connect(null);
  }

  material(single) {
    this.uniforms = {
      pixel: {value: 1}, perspective: {value: 1}, enlarged: {value: 1},
      leastWidth: {value: single ? OVER_WIDTH : LEAST_WIDTH}, over: {value: single ? 1 : 0}, dash: {value: 1},
      selectedWidth: {value: SELECTED_WIDTH}, selected: {value: -1}, colours: {value: null}, steps: {value: 256},
      low: {value: 0}, high: {value: 1}, coloured: {value: single ? 0 : 1}, single: {value: new THREE.Color(single || "#444444")},
      noNumber: {value: new THREE.Color(...hawser.NO_NUMBER.map((c) => c / 255))},
    };
    return new THREE.ShaderMaterial({vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT, uniforms: this.uniforms,
                                     side: THREE.DoubleSide, clipping: true});
  }

  // Positions of all nodes (all x, all y, all z) between two outputs.
  move(a, b, share) {
    const n = this.model.header.nodes;
    const {positions, placeOf} = this;
    let broken = false;
    for (let c = 0; c < 3; c++) {
      for (let i = 0; i < n; i++) {
        const x = a[c * n + i] + share * (b[c * n + i] - a[c * n + i]);
        const k = 6 * placeOf[i] + c;
        positions[k] = x;
        positions[k + 3] = x;
        if (x !== x) broken = true;
      }
    }
    for (const line of this.model.header.lines) {
      const first = 6 * placeOf[line.first];
      const last = first + 6 * (line.nodes - 1);
      for (let k = 0; k < 6; k++) {
        positions[first - 6 + k] = 2 * positions[first + k] - positions[first + 6 + k];
        positions[last + 6 + k] = 2 * positions[last + k] - positions[last - 6 + k];
      }
    }
    if (broken || this.broken !== false) this.connect(broken ? this.lost() : null);
    this.broken = broken;
    this.positionBuffer.needsUpdate = true;
  }

  // Places without a position, which are not drawn.
  lost() {
    const {positions} = this;
    const found = new Uint8Array(this.places);
    for (let k = 0; k < positions.length; k++) {
      if (positions[k] === positions[k]) continue;
      positions[k] = 0;
      found[Math.floor(k / 6)] = 1;
    }
    return found;
  }

  paint(a, b, share) {
    const {values, placeOf} = this;
    for (let i = 0; i < a.length; i++) {
      const v = a[i] + share * (b[i] - a[i]);
      values.fill(v === v ? v : HIDDEN, 2 * placeOf[i], 2 * placeOf[i] + 2);
    }
    this.valueBuffer.needsUpdate = true;
  }

  position(node, target) {
    return target.fromArray(this.positions, 6 * this.placeOf[node]);
  }
};
