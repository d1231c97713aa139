// What a ray meets: every film along it that the cut leaves, the nearest first, and the bubble behind it (the one before it
// where that is the air).

// Moeller and Trumbore 1997.
function meet(buffers, s, explode, origin, direction) {
  const {position, shift} = buffers, at = 9 * s;
  const p = i => position[at + i] + shift[at + i] * explode;
  const ax = p(0), ay = p(1), az = p(2);
  const ux = p(3) - ax, uy = p(4) - ay, uz = p(5) - az, vx = p(6) - ax, vy = p(7) - ay, vz = p(8) - az;
  const [dx, dy, dz] = direction;
  const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return null;
  const sx = origin[0] - ax, sy = origin[1] - ay, sz = origin[2] - az;
  const a = (sx * px + sy * py + sz * pz) / determinant;
  if (a < 0 || a > 1) return null;
  const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
  const b = (dx * qx + dy * qy + dz * qz) / determinant;
  if (b < 0 || a + b > 1) return null;
  const distance = (vx * qx + vy * qy + vz * qz) / determinant;
  // The determinant's sign: whether the ray comes from in front of the triangle.
  return distance > 0 ? {distance, fromFront: determinant > 0} : null;
}

export function hitsAlong(buffers, origin, direction, explode, plane) {
  const hits = [];
  for (let s = 0; s < buffers.count; ++s) {
    const hit = meet(buffers, s, explode, origin, direction);
    if (!hit) continue;
    const at = origin.map((o, k) => o + hit.distance * direction[k]);
    if (at[0] * plane.x + at[1] * plane.y + at[2] * plane.z > plane.w) continue;
    const behind = buffers.regions[6 * s], front = buffers.regions[6 * s + 1];
    const [beyond, before] = hit.fromFront ? [behind, front] : [front, behind];
    hits.push({distance: hit.distance, triangle: buffers.triangle[s], bubble: beyond > 0 ? beyond : before});
  }
  return hits.sort((a, b) => a.distance - b.distance);
}
