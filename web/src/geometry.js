// Buffers to draw from a frame: three vertices a triangle, with normals that are smooth within a film. With `apart`, every
// film is there once for each of its bubbles, which moves away with it.

const air = 0;

// The films to draw: triangle, the region whose copy it is (-1: of both), regions behind and in front.
function sidesToDraw(frame, apart) {
  const sides = [];
  const count = frame.pair.length;
  for (let t = 0; t < count; ++t) {
    if (frame.solid?.[t]) continue;
    const [behind, front] = frame.pairs[frame.pair[t]];
    if (!apart) {
      sides.push(t, -1, behind, front);
      continue;
    }
    if (behind !== air) sides.push(t, behind, behind, behind);
    if (front !== air) sides.push(t, front, front, front);
  }
  return sides;
}

// Pairs of regions without their order, which differs from triangle to triangle of a film: number and sign by pair.
function unorderedPairs(pairs) {
  const numbers = new Map();
  return pairs.map(([behind, front]) => {
    const key = `${Math.min(behind, front)},${Math.max(behind, front)}`;
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return {number: numbers.get(key), sign: behind < front ? 1 : -1};
  });
}

// Normals by (vertex, film): the sum of the area vectors of the film's triangles there, on its lower region's far side.
function filmNormals(frame) {
  const {positions: x, triangles, pair} = frame;
  const slots = new Uint32Array(triangles.length);
  const numbers = new Map();
  const pairCount = frame.pairs.length;
  const unordered = unorderedPairs(frame.pairs);
  const sums = [];
  for (let t = 0; t < pair.length; ++t) {
    const [a, b, c] = [3 * triangles[3 * t], 3 * triangles[3 * t + 1], 3 * triangles[3 * t + 2]];
    const ux = x[b] - x[a], uy = x[b + 1] - x[a + 1], uz = x[b + 2] - x[a + 2];
    const vx = x[c] - x[a], vy = x[c + 1] - x[a + 1], vz = x[c + 2] - x[a + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const {number, sign} = unordered[pair[t]];
    for (let k = 0; k < 3; ++k) {
      const key = triangles[3 * t + k] * pairCount + number;
      let slot = numbers.get(key);
      if (slot === undefined) {
        slot = numbers.size;
        numbers.set(key, slot);
        sums.push(0, 0, 0);
      }
      sums[3 * slot] += sign * nx;
      sums[3 * slot + 1] += sign * ny;
      sums[3 * slot + 2] += sign * nz;
      slots[3 * t + k] = slot;
    }
  }
  return {slots, sums};
}

function shiftOf(frame, region, middle) {
  const bubble = frame.bubbles.get(region);
  return bubble ? bubble.centre.map((c, k) => c - middle[k]) : [0, 0, 0];
}

export function middleOf(frame) {
  return frame.box[0].map((low, k) => (low + frame.box[1][k]) / 2);
}

export function filmBuffers(frame, apart) {
  const sides = sidesToDraw(frame, apart);
  const {slots, sums} = filmNormals(frame);
  const count = sides.length / 4;
  const buffers = {
    count, position: new Float32Array(9 * count), normal: new Float32Array(9 * count),
    regions: new Float32Array(6 * count), shift: new Float32Array(9 * count), triangle: new Uint32Array(count),
  };
  const middle = middleOf(frame);
  const shifts = new Map();
  for (let s = 0; s < count; ++s) {
    const t = sides[4 * s], region = sides[4 * s + 1];
    buffers.triangle[s] = t;
    let shift = shifts.get(region);
    if (!shift) shifts.set(region, shift = apart ? shiftOf(frame, region, middle) : [0, 0, 0]);
    for (let k = 0; k < 3; ++k) {
      const v = 3 * frame.triangles[3 * t + k], n = 3 * slots[3 * t + k], to = 9 * s + 3 * k;
      for (let i = 0; i < 3; ++i) {
        buffers.position[to + i] = frame.positions[v + i];
        buffers.normal[to + i] = sums[n + i];
        buffers.shift[to + i] = shift[i];
      }
      buffers.regions[6 * s + 2 * k] = sides[4 * s + 2];
      buffers.regions[6 * s + 2 * k + 1] = sides[4 * s + 3];
    }
  }
  return buffers;
}

// The value at every drawn corner; NaN, where there is none, as a number that the shader knows.
export const nothing = -1e30;

export function fieldBuffer(frame, buffers, field) {
  const values = new Float32Array(3 * buffers.count);
  for (let s = 0; s < buffers.count; ++s)
    for (let k = 0; k < 3; ++k) {
      const t = buffers.triangle[s];
      const value = field.values[field.on === 'vertices' ? frame.triangles[3 * t + k] : t];
      values[3 * s + k] = Number.isNaN(value) ? nothing : value;
    }
  return values;
}

// Bubbles at each border, found by its triangles.
function bubblesAtBorders(frame) {
  const count = frame.positions.length / 3;
  const keyOf = (a, b) => Math.min(a, b) * count + Math.max(a, b);
  const at = new Map();
  for (let e = 0; e < frame.borders.length; e += 2) at.set(keyOf(frame.borders[e], frame.borders[e + 1]), new Set());
  for (let t = 0; t < frame.pair.length; ++t)
    for (let k = 0; k < 3; ++k) {
      const regions = at.get(keyOf(frame.triangles[3 * t + k], frame.triangles[3 * t + (k + 1) % 3]));
      if (regions) for (const region of frame.pairs[frame.pair[t]]) if (region !== air) regions.add(region);
    }
  return [...at.values()];
}

// One cylinder an edge: from, to, shift.
export function borderBuffers(frame, apart) {
  const from = [], to = [], shift = [];
  const middle = middleOf(frame);
  const regions = apart ? bubblesAtBorders(frame) : null;
  const end = v => [frame.positions[3 * v], frame.positions[3 * v + 1], frame.positions[3 * v + 2]];
  for (let e = 0; e < frame.borders.length; e += 2) {
    const a = end(frame.borders[e]), b = end(frame.borders[e + 1]);
    const shifts = apart ? [...regions[e / 2]].map(region => shiftOf(frame, region, middle)) : [[0, 0, 0]];
    for (const moved of shifts) {
      from.push(...a);
      to.push(...b);
      shift.push(...moved);
    }
  }
  return {count: from.length / 3, from: new Float32Array(from), to: new Float32Array(to), shift: new Float32Array(shift)};
}
