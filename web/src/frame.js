// A packed frame (FoamSim/web/frame_pack.h) as arrays.

const kinds = {u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array};

// Numbers stand byte plane by byte plane, the lowest bytes of all of them first.
function fromPlanes(bytes, at, count, Kind) {
  const size = Kind.BYTES_PER_ELEMENT;
  const joined = new Uint8Array(count * size);
  for (let k = 0; k < size; ++k) {
    const plane = at + k * count;
    for (let i = 0, to = k; i < count; ++i, to += size) joined[to] = bytes[plane + i];
  }
  return new Kind(joined.buffer);
}

function sumUp(numbers, components) {
  for (let i = components; i < numbers.length; ++i) numbers[i] += numbers[i - components];
}

function unquantised(steps, low, high) {
  const numbers = new Float32Array(steps.length);
  const scale = (high - low) / 65534;
  for (let i = 0; i < steps.length; ++i) numbers[i] = steps[i] === 65535 ? NaN : low + steps[i] * scale;
  return numbers;
}

function positionsOf(array, box) {
  if (array instanceof Float32Array) return array;
  const positions = new Float32Array(array.length);
  for (let i = 0; i < array.length; ++i) {
    const k = i % 3;
    positions[i] = box[0][k] + (array[i] / 65534) * (box[1][k] - box[0][k]);
  }
  return positions;
}

function bubbleOf([region, volume, area, pressure, faces, x, y, z]) {
  return {region, volume, area, pressure, faces, centre: [x, y, z]};
}

export function bubblesOf(list) {
  return new Map(list.map(entry => [entry[0], bubbleOf(entry)]));
}

export function unpackFrame(bytes) {
  if (new TextDecoder().decode(bytes.subarray(0, 4)) !== 'FSF1') throw new Error('a frame is damaged, or of another version');
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true);
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(8, 8 + length)));
  const arrays = {};
  let at = 8 + length;
  for (const {name, type, count, components, differences} of head.arrays) {
    const numbers = fromPlanes(bytes, at, count * components, kinds[type]);
    if (differences) sumUp(numbers, components);
    arrays[name] = numbers;
    at += numbers.byteLength;
  }
  const fields = new Map();
  for (const field of head.fields) {
    const array = arrays[`field/${field.name}`];
    const values = array instanceof Float32Array ? array : unquantised(array, field.range[0] ?? 0, field.range[1] ?? 0);
    fields.set(field.name, {...field, values});
  }
  return {
    step: head.step, time: head.time, box: head.box, pairs: head.pairs, fields, bubbles: bubblesOf(head.bubbles),
    positions: positionsOf(arrays.positions, head.box), triangles: arrays.triangles, pair: arrays.pair,
    solid: arrays.solid, borders: arrays.borders, bytes: at * 3,
  };
}
