// The three-dimensional view: films, Plateau borders, camera, cut and explosion. Draws when something has changed, and with
// fewer pixels where drawing is slow.
import {
  AddEquation, BackSide, BufferAttribute, BufferGeometry, CustomBlending, CylinderGeometry, DataTexture, DoubleSide,
  FrontSide, InstancedBufferAttribute, InstancedBufferGeometry, LinearFilter, Mesh, OneFactor, PerspectiveCamera,
  RGBAFormat, Scene, ShaderMaterial, SRGBColorSpace, Vector2, Vector3, Vector4, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {colourMaps} from './colours.js';
import {borderBuffers, fieldBuffer, filmBuffers, middleOf} from './geometry.js';
import {hitsAlong} from './picking.js';
import {borderFragment, borderVertex, fieldFragment, filmVertex, glassFragment} from './shaders.js';

const slowMilliseconds = 70, quickMilliseconds = 22;
const far = 1e30;

function mapTexture(bytes) {
  const texture = new DataTexture(bytes, 256, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

// From the middle to the vertex that is farthest.
function reachOf(frame) {
  const middle = middleOf(frame), {positions} = frame;
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i] - middle[0], positions[i + 1] - middle[1], positions[i + 2] - middle[2]];
    squared = Math.max(squared, x * x + y * y + z * z);
  }
  return Math.sqrt(squared) || 1;
}

export class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, alpha: true, antialias: true, powerPreference: 'high-performance'});
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.setClearColor(0x000000, 0);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.position.set(0.514, 0.342, 0.823);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener('change', () => this.draw());
    this.look = {glass: true, byBubble: false, field: null, opacity: 1, borders: true, explode: 0, cut: null, cutAt: 0.5, picked: -1};
    this.#makeMaterials();
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.#resize();
  }

  #makeMaterials() {
    this.shared = {plane: {value: new Vector4(0, 0, 0, 1)}, explode: {value: 0}, picked: {value: -1}};
    this.maps = {sequential: mapTexture(colourMaps.sequential), diverging: mapTexture(colourMaps.diverging)};
    this.glass = new ShaderMaterial({
      uniforms: {...this.shared, strength: {value: 1}, heights: {value: new Vector2(0, 1)}},
      vertexShader: filmVertex, fragmentShader: glassFragment, side: DoubleSide, depthWrite: false, transparent: true,
      blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneFactor,
    });
    const field = {...this.shared, map: {value: this.maps.sequential}, range: {value: new Vector2(0, 1)}, opacity: {value: 1}, byBubble: {value: false}};
    const coloured = side => new ShaderMaterial({uniforms: field, vertexShader: filmVertex, fragmentShader: fieldFragment, side});
    this.fieldUniforms = field;
    this.backs = coloured(BackSide);
    this.fronts = coloured(FrontSide);
    this.borderMaterial = new ShaderMaterial({
      uniforms: {...this.shared, radius: {value: 0.01}, tint: {value: new Vector3(0.72, 0.84, 0.95)}},
      vertexShader: borderVertex, fragmentShader: borderFragment,
    });
    const mesh = (material, order) => {
      const made = new Mesh(new BufferGeometry(), material);
      made.frustumCulled = false;
      made.renderOrder = order;
      this.scene.add(made);
      return made;
    };
    this.borderMesh = mesh(this.borderMaterial, 0);
    this.glassMesh = mesh(this.glass, 3);
    this.backMesh = mesh(this.backs, 1);
    this.frontMesh = mesh(this.fronts, 2);
  }

  #resize() {
    const width = Math.max(1, this.canvas.clientWidth), height = Math.max(1, this.canvas.clientHeight);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  show(frame) {
    const first = !this.frame;
    this.frame = frame;
    this.#rebuild();
    if (first) this.fit();
    this.draw();
  }

  get apart() {
    return this.look.explode > 0;
  }

  #rebuild() {
    if (!this.frame) return;
    const {apart} = this;
    this.buffers = filmBuffers(this.frame, apart);
    this.built = {frame: this.frame, apart};
    const films = new BufferGeometry();
    films.setAttribute('position', new BufferAttribute(this.buffers.position, 3));
    films.setAttribute('normal', new BufferAttribute(this.buffers.normal, 3));
    films.setAttribute('regions', new BufferAttribute(this.buffers.regions, 2));
    films.setAttribute('shift', new BufferAttribute(this.buffers.shift, 3));
    this.glassMesh.geometry.dispose();
    for (const mesh of [this.glassMesh, this.backMesh, this.frontMesh]) mesh.geometry = films;
    this.#setValues();
    const borders = borderBuffers(this.frame, apart);
    const geometry = new InstancedBufferGeometry();
    const cylinder = new CylinderGeometry(1, 1, 1, 8, 1, true);
    cylinder.translate(0, 0.5, 0);
    geometry.setAttribute('position', cylinder.getAttribute('position'));
    geometry.setIndex(cylinder.getIndex());
    for (const name of ['from', 'to', 'shift']) geometry.setAttribute(name, new InstancedBufferAttribute(borders[name], 3));
    geometry.instanceCount = borders.count;
    this.borderMesh.geometry.dispose();
    this.borderMesh.geometry = geometry;
    this.hasBorders = borders.count > 0;
  }

  #setValues() {
    const field = this.look.field && this.frame.fields.get(this.look.field.name);
    const values = field ? fieldBuffer(this.frame, this.buffers, field) : new Float32Array(3 * this.buffers.count).fill(-far);
    this.glassMesh.geometry.setAttribute('value', new BufferAttribute(values, 1));
    this.valuesOf = this.look.field?.name;
  }

  // `changes`: some of `look`.
  setLook(changes) {
    Object.assign(this.look, changes);
    if (this.frame && this.built.apart !== this.apart) this.#rebuild();
    if (this.frame && this.valuesOf !== this.look.field?.name) this.#setValues();
    this.draw();
  }

  size() {
    if (!this.frame) return 1;
    return Math.hypot(...this.frame.box[0].map((low, k) => this.frame.box[1][k] - low)) || 1;
  }

  fit() {
    if (!this.frame) return;
    const direction = this.camera.position.clone().sub(this.controls.target);
    if (!(direction.length() > 0)) direction.set(0.514, 0.342, 0.823);
    const radius = reachOf(this.frame) * (1 + this.look.explode);
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    const distance = radius / Math.sin(Math.atan(half)) * 1.06;
    this.controls.target.set(...middleOf(this.frame));
    this.camera.position.copy(this.controls.target).addScaledVector(direction.normalize(), distance);
    this.controls.update();
    this.draw();
  }

  turn(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(new Vector3(0, 1, 0), -right);
    const side = new Vector3().crossVectors(offset, new Vector3(0, 1, 0)).normalize();
    const polar = offset.angleTo(new Vector3(0, 1, 0));
    if (polar - up > 0.05 && polar - up < Math.PI - 0.05) offset.applyAxisAngle(side, up);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  plane() {
    if (!this.look.cut || !this.frame) return new Vector4(0, 0, 0, 1);
    const normal = this.look.cut === 'view'
      ? this.camera.position.clone().sub(this.controls.target).normalize()
      : new Vector3(+(this.look.cut === 'x'), +(this.look.cut === 'y'), +(this.look.cut === 'z'));
    const middle = new Vector3(...middleOf(this.frame));
    let reach = 0;
    for (let k = 0; k < 3; ++k) reach += Math.abs(normal.getComponent(k)) * (this.frame.box[1][k] - this.frame.box[0][k]) / 2;
    reach *= 1 + this.look.explode;
    return new Vector4(normal.x, normal.y, normal.z, normal.dot(middle) + (2 * this.look.cutAt - 1) * reach * 1.02);
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.drawNow();
    });
  }

  drawNow() {
    if (!this.frame) return;
    if (this.renderer.getPixelRatio() !== this.ratio) this.renderer.setPixelRatio(this.ratio);
    const {look} = this, size = this.size();
    this.shared.plane.value.copy(this.plane());
    this.shared.explode.value = look.explode;
    this.shared.picked.value = look.picked;
    this.glassMesh.visible = look.glass;
    this.frontMesh.visible = this.backMesh.visible = !look.glass;
    const {field} = look;
    this.fieldUniforms.byBubble.value = look.byBubble;
    if (field) {
      this.fieldUniforms.map.value = this.maps[field.map];
      this.fieldUniforms.range.value.set(field.low, field.high);
    }
    this.fieldUniforms.opacity.value = look.opacity;
    for (const material of [this.backs, this.fronts]) {
      material.transparent = look.opacity < 1;
      material.depthWrite = look.opacity >= 1;
    }
    const bubbles = Math.max(1, this.frame.bubbles.size);
    this.glass.uniforms.strength.value = look.opacity * Math.pow(bubbles, -0.14);
    this.glass.uniforms.heights.value.set(this.frame.box[0][1], this.frame.box[1][1]);
    this.borderMesh.visible = look.borders && this.hasBorders;
    this.borderMaterial.uniforms.radius.value = (look.glass ? 0.0036 : 0.0044) * size / Math.pow(bubbles, 0.12);
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance - 2 * size * (1 + look.explode), distance / 500);
    this.camera.far = distance + 2 * size * (1 + look.explode);
    this.camera.updateProjectionMatrix();
    const begin = performance.now();
    this.renderer.render(this.scene, this.camera);
    this.#adapt(begin);
  }

  // Fewer pixels where a picture takes long, as without a graphics processor; measured while it is turned or played.
  #adapt(begin) {
    const since = begin - (this.lastDrawn ?? 0);
    this.lastDrawn = begin;
    if (since > 400) return;
    this.pace = this.pace === undefined ? since : 0.8 * this.pace + 0.2 * since;
    const most = Math.min(window.devicePixelRatio || 1, 2);
    let ratio = this.ratio;
    if (this.pace > slowMilliseconds) ratio = Math.max(0.6, ratio * 0.8);
    if (this.pace < quickMilliseconds) ratio = Math.min(most, ratio * 1.1);
    if (Math.abs(ratio - this.ratio) < 0.05) return;
    // With the next picture: another size empties the canvas.
    this.ratio = ratio;
    this.pace = undefined;
  }

  // Films below a place of the canvas, in pixels, the nearest first.
  hits(x, y) {
    if (!this.buffers) return [];
    const to = new Vector3((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight, 0.5);
    this.camera.updateMatrixWorld();
    to.unproject(this.camera).sub(this.camera.position).normalize();
    const origin = this.camera.position;
    return hitsAlong(this.buffers, [origin.x, origin.y, origin.z], [to.x, to.y, to.z], this.look.explode, this.plane());
  }
}
