// Shaders of films and Plateau borders. Every position is moved by `explode` times its shift; what is beyond the plane
// (xyz: its normal, w: how far along it) is cut away.

const common = `
uniform vec4 plane;
uniform float explode;
`;

const filmVertex = `
${common}
attribute vec2 regions;
attribute vec3 shift;
attribute float value;
varying vec3 vWorld, vNormal3;
varying vec2 vRegions;
varying float vValue;
void main() {
  vec3 moved = position + explode * shift;
  vWorld = moved;
  vNormal3 = normal;
  vRegions = regions;
  vValue = value;
  gl_Position = projectionMatrix * viewMatrix * vec4(moved, 1.0);
}`;

const filmStart = `
precision highp float;
${common}
uniform float picked;
varying vec3 vWorld, vNormal3;
varying vec2 vRegions;
varying float vValue;
bool anyPicked() { return picked >= 0.0; }
bool isPicked() { return picked >= 0.0 && (abs(vRegions.x - picked) < 0.5 || abs(vRegions.y - picked) < 0.5); }
vec3 towardsEye(out vec3 n) {
  vec3 view = normalize(cameraPosition - vWorld);
  n = dot(vNormal3, vNormal3) > 0.0 ? normalize(vNormal3) : view;
  if (dot(n, view) < 0.0) n = -n;
  return view;
}`;

// Reflection alone, added up: a film lets nearly all light through. Interference of the two sides, three wavelengths, and
// a room of soft lights that is mirrored.
const glassFragment = `
${filmStart}
uniform float strength;
uniform vec2 heights;
vec3 room(vec3 d) {
  vec3 light = mix(vec3(0.05, 0.07, 0.12), vec3(0.35, 0.45, 0.62), smoothstep(-0.5, 1.0, d.y));
  light += vec3(1.0, 0.93, 0.82) * 2.4 * smoothstep(0.80, 0.90, d.y) * smoothstep(0.62, 0.50, abs(d.x));
  light += vec3(1.0, 0.95, 0.88) * 1.9 * smoothstep(0.46, 0.36, abs(d.x + 0.62)) * smoothstep(0.36, 0.26, abs(d.y - 0.30)) * smoothstep(0.0, 0.2, d.z);
  light += vec3(0.55, 0.72, 1.0) * 1.1 * smoothstep(0.30, 0.18, abs(d.x - 0.74)) * smoothstep(0.60, 0.40, abs(d.y + 0.1));
  return light;
}
void main() {
  if (dot(vWorld, plane.xyz) > plane.w) discard;
  vec3 n;
  vec3 view = towardsEye(n);
  float facing = clamp(dot(n, view), 0.0, 1.0);
  float height = clamp((vWorld.y - heights.x) / max(heights.y - heights.x, 1e-30), 0.0, 1.0);
  vec3 q = (vWorld - vec3(heights.x)) / max(heights.y - heights.x, 1e-30) * 5.0;
  float swirl = sin(q.x * 1.7 + 1.6 * sin(q.y * 1.3 + q.z)) * cos(q.z * 1.9 + 1.2 * sin(q.x - q.y));
  float thickness = 620.0 - 330.0 * height + 70.0 * swirl;
  float inside = sqrt(1.0 - (1.0 - facing * facing) / (1.33 * 1.33));
  vec3 wave = vec3(0.5) - 0.5 * cos(12.566371 * 1.33 * thickness * inside / vec3(640.0, 540.0, 455.0));
  wave = mix(wave, vec3(dot(wave, vec3(0.3, 0.5, 0.2))), 0.22);
  float fresnel = 0.045 + 0.955 * pow(1.0 - facing, 4.0);
  vec3 colour = wave * fresnel * room(reflect(-view, n)) * 2.6;
  colour += wave * (0.07 + 0.20 * pow(1.0 - facing, 2.0));
  if (isPicked()) colour = colour + vec3(0.14, 0.10, 0.03) * (0.4 + 1.4 * (1.0 - facing)) / max(strength, 0.3);
  else if (anyPicked()) colour *= 0.6;
  gl_FragColor = vec4(colour * strength, 1.0);
}`;

const fieldFragment = `
${filmStart}
uniform sampler2D map;
uniform vec2 range;
uniform float opacity;
uniform bool byBubble;
vec3 hue(float region) {
  float h = fract(region * 0.61803399 + 0.07), s = 0.50 + 0.22 * fract(region * 0.754877), v = 0.74 + 0.22 * fract(region * 0.569840);
  return v * mix(vec3(1.0), clamp(abs(fract(h + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0), s);
}
void main() {
  if (dot(vWorld, plane.xyz) > plane.w) discard;
  vec3 n;
  vec3 view = towardsEye(n);
#ifdef FLIP_SIDED
  bool fromFront = !gl_FrontFacing;
#else
  bool fromFront = gl_FrontFacing;
#endif
  float behind = fromFront ? vRegions.x : vRegions.y, front = fromFront ? vRegions.y : vRegions.x;
  vec3 colour = vec3(0.42, 0.45, 0.50);
  if (byBubble) colour = hue(behind > 0.5 ? behind : front);
  else if (vValue > -1e29) colour = texture2D(map, vec2(clamp((vValue - range.x) / (range.y - range.x), 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
  float light = 0.58 + 0.42 * max(dot(n, normalize(view + vec3(0.35, 0.55, 0.15))), 0.0);
  colour *= light;
  float edge = pow(1.0 - clamp(dot(n, view), 0.0, 1.0), 3.0);
  colour += 0.16 * edge;
  if (isPicked()) colour = mix(colour, vec3(1.0, 0.9, 0.66), 0.12 + 0.75 * edge);
  else if (anyPicked()) colour = mix(colour, vec3(0.16, 0.19, 0.25), 0.45);
  gl_FragColor = vec4(colour, opacity);
}`;

const borderVertex = `
${common}
uniform float radius;
attribute vec3 from, to, shift;
varying vec3 vWorld, vNormal3;
void main() {
  vec3 along = to - from;
  float length3 = length(along);
  vec3 axis = length3 > 0.0 ? along / length3 : vec3(0.0, 1.0, 0.0);
  vec3 side = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 out3 = side * position.x + cross(axis, side) * position.z;
  vec3 moved = from + along * position.y + axis * (position.y - 0.5) * radius + radius * out3 + explode * shift;
  // Towards the eye, out of the crease of the films.
  moved += radius * normalize(cameraPosition - moved);
  vWorld = moved;
  vNormal3 = out3;
  gl_Position = projectionMatrix * viewMatrix * vec4(moved, 1.0);
}`;

const borderFragment = `
precision highp float;
${common}
uniform vec3 tint;
varying vec3 vWorld, vNormal3;
void main() {
  if (dot(vWorld, plane.xyz) > plane.w) discard;
  vec3 view = normalize(cameraPosition - vWorld), n = normalize(vNormal3);
  float light = 0.35 + 0.65 * max(dot(n, normalize(view + vec3(0.2, 0.6, 0.1))), 0.0);
  float shine = pow(max(dot(n, normalize(view + vec3(0.3, 0.9, 0.2))), 0.0), 24.0);
  gl_FragColor = vec4(tint * light + 0.45 * shine, 1.0);
}`;

export {borderFragment, borderVertex, fieldFragment, filmVertex, glassFragment};
