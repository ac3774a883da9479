// Colours of values, from the maps in the header.

hawser.NO_NUMBER = [150, 150, 150];  // colour of NaN

hawser.Colours = class {
  constructor(maps) {
    this.maps = maps.map((map) => {
      const bytes = new Uint8Array(map.colours.length / 2);
      for (let i = 0; i < bytes.length; i++) bytes[i] = parseInt(map.colours.substr(2 * i, 2), 16);
      return {...map, bytes, steps: bytes.length / 3};
    });
    this.chosen = this.maps[0];
    this.low = 0;
    this.high = 1;
  }

  choose(name) {
    this.chosen = this.maps.find((map) => map.name === name) || this.maps[0];
  }

  // Position of a value in the range, 0 to 1.
  share(value) {
    return this.high > this.low ? Math.min(1, Math.max(0, (value - this.low) / (this.high - this.low))) : 0.5;
  }

  // [r, g, b], 0 to 255, interpolated in the map.
  at(share) {
    if (!(share >= 0)) return hawser.NO_NUMBER;
    const {bytes, steps} = this.chosen;
    const x = share * (steps - 1);
    const k = Math.min(steps - 2, Math.floor(x));
    return [0, 1, 2].map((c) => Math.round(bytes[3 * k + c] + (x - k) * (bytes[3 * k + 3 + c] - bytes[3 * k + c])));
  }

  of(value) {
    return this.at(Number.isFinite(value) ? this.share(value) : NaN);
  }

  // Texture with the colours of the map in a row.
  texture() {
    const {bytes, steps} = this.chosen;
    const texture = new THREE.DataTexture(bytes, steps, 1, THREE.RGBFormat, THREE.UnsignedByteType);
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }
};

// Readable number with at most four digits; values negligible relative to `scale` are 0.
hawser.number = function (value, scale = 0) {
  if (!Number.isFinite(value)) return "no number";
  if (Math.abs(value) <= 1e-6 * scale) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(2).replace(/\.?0+e/, "e");
  return String(Number(value.toPrecision(4)));
};

// Round numbers between two values, about `count` of them.
hawser.ticks = function (low, high, count) {
  if (!(high > low)) return [low];
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
};
