// Decoding of the number blocks of viewer/blocks.py.

hawser.bytesOfBase64 = function (text) {
  const raw = atob(text.trim());
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
};

hawser.inflated = async function (bytes) {
  if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old to read compressed data");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
};

// Cumulative sums along an axis, which undo the differences: 0 between rows, 1 between columns.
hawser.summed = function (k, rows, columns, axis) {
  if (axis === 0) {
    for (let i = columns; i < k.length; i++) k[i] = (k[i] + k[i - columns]) | 0;
    return;
  }
  for (let row = 0; row < rows; row++) {
    const end = (row + 1) * columns;
    for (let i = row * columns + 1; i < end; i++) k[i] = (k[i] + k[i - 1]) | 0;
  }
};

// Values from byte planes: byte 0 of all, byte 1 of all, ...
hawser.joined = function (data, size, count) {
  const bytes = new Uint8Array(size * count);
  for (let plane = 0; plane < size; plane++) {
    for (let i = 0; i < count; i++) bytes[i * size + plane] = data[plane * count + i];
  }
  return bytes.buffer;
};

hawser.steps = function (data, header, Kind) {
  const count = header.rows * header.columns;
  const k = new Int32Array(count);
  for (let plane = 0; plane < header.planes; plane++) {
    const start = plane * count;
    const shift = 8 * plane;
    for (let i = 0; i < count; i++) k[i] |= data[start + i] << shift;
  }
  for (let i = 0; i < count; i++) k[i] = (k[i] >>> 1) ^ -(k[i] & 1);
  for (const axis of [1, 0]) {
    for (let n = 0; n < header.order[axis]; n++) hawser.summed(k, header.rows, header.columns, axis);
  }
  const values = new Kind(count);
  for (let i = 0; i < count; i++) values[i] = k[i] < 0 ? NaN : header.offset + header.step * k[i];
  return values;
};

// {rows, columns, values} from the bytes of a block; `Kind` is the array type for 'steps'.
hawser.unpacked = async function (bytes, Kind = Float32Array) {
  if (bytes.length < 8 || String.fromCharCode(...bytes.subarray(0, 4)) !== "hwb1") throw new Error("a block of data is damaged");
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(8, 8 + length)));
  let data = bytes.subarray(8 + length);
  if (header.deflated) data = await hawser.inflated(data);
  const count = header.rows * header.columns;
  let values;
  if (header.kind === "steps") values = hawser.steps(data, header, Kind);
  else if (header.kind === "float64") values = new Float64Array(hawser.joined(data, 8, count));
  else if (header.kind === "uint32") values = new Uint32Array(hawser.joined(data, 4, count));
  else values = new Float32Array(hawser.joined(data, 4, count));
  return {rows: header.rows, columns: header.columns, values};
};
