// The surface: triangles with corners of their own, in the order of their birth, so that a part of
// the sweep is a part of the array, and each triangle can have its own colours.
//
// Colours are decided by fragment. On a scale the value is interpolated and then looked up. Else a
// triangle has a colour by corner, and the sign of a function between each two corners, linear on
// the triangle, says on whose side a fragment lies: so a wall between two cells may cross it.

import * as THREE from 'three';
import { scaleColours } from './palette.js';

const vertexShader = /* glsl */ `
uniform highp sampler2D colours;
uniform int perRow;
uniform vec4 plane;
in vec3 along;
out vec3 vNormal;
out vec3 vPlace;
flat out vec3 vColour0;
flat out vec3 vColour1;
flat out vec3 vColour2;
out vec3 vAlong;
out vec3 vCorner;
out float vBeyond;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vPlace = place.xyz;
  vNormal = normalMatrix * normal;
  // Corners of triangles lie one after the other; in which of the three this is tells the wires.
  int t = gl_VertexID / 3, k = gl_VertexID % 3;
  vCorner = vec3(k == 0, k == 1, k == 2);
  ivec2 texel = ivec2(3 * (t % perRow), t / perRow);
  vec4 first = texelFetch(colours, texel, 0);
  vColour0 = first.rgb;
  vColour1 = texelFetch(colours, texel + ivec2(1, 0), 0).rgb;
  vColour2 = texelFetch(colours, texel + ivec2(2, 0), 0).rgb;
  vAlong = along;
  vBeyond = dot(position, plane.xyz) - plane.w;
  bool isHidden = first.a == 0.0;
  gl_Position = isHidden ? vec4(0.0, 0.0, 2.0, 1.0) : projectionMatrix * place;
}`;

const fragmentShader = /* glsl */ `
in vec3 vNormal;
in vec3 vPlace;
flat in vec3 vColour0;
flat in vec3 vColour1;
flat in vec3 vColour2;
in vec3 vAlong;
in vec3 vCorner;
in float vBeyond;
uniform vec3 scale[6];
uniform float opacity;
uniform vec3 inside;
uniform vec3 wireColour;
out vec4 result;

vec3 colourHere() {
#ifdef SCALE
  float at = clamp(vAlong.x, 0.0, 1.0) * 5.0;
  int i = min(int(at), 4);
  return mix(scale[i], scale[i + 1], at - float(i));
#else
  // By corner how far outside of its part this is. vAlong: below 0 on the side of the first of the
  // corners 0 and 1, 1 and 2, 2 and 0.
  vec3 off = max(vAlong, -vAlong.zxy);
  if (off.x <= off.y && off.x <= off.z) return vColour0;
  return off.y <= off.z ? vColour1 : vColour2;
#endif
}

void main() {
#ifdef CUT
  if (vBeyond > 0.0) discard;
#endif
#if defined(WIRE) || defined(WIRE_ONLY)
  vec3 width = fwidth(vCorner);
  vec3 off = smoothstep(vec3(0.0), width * 1.1, vCorner);
  float wire = 1.0 - min(off.x, min(off.y, off.z));
#endif
#ifdef WIRE_ONLY
  if (wire < 0.35) discard;
#endif
#ifdef FLAT
  vec3 n = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
#else
  vec3 n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
#endif
  vec3 toEye = normalize(-vPlace);
  const vec3 key = normalize(vec3(0.45, 0.6, 0.75));
  float light = 0.4 + 0.46 * max(dot(n, key), 0.0) + 0.22 * max(dot(n, toEye), 0.0);
  float shine = 0.16 * pow(max(dot(n, normalize(key + toEye)), 0.0), 28.0);
  vec3 colour = colourHere();
  vec3 base = gl_FrontFacing ? colour : mix(colour, inside, 0.75);
#ifdef WIRE
  base = mix(base, wireColour, 0.55 * wire);
#endif
#ifdef WIRE_ONLY
  result = vec4(base * (0.6 + 0.4 * light), opacity);
#else
  result = vec4(base * light + shine, opacity);
#endif
}`;

export class Surface {
  // order: triangles as they are to lie in the arrays, or nothing for as they come.
  constructor(mesh, normals, order) {
    this.mesh = mesh;
    this.switches = {};
    this.compiled = '';
    const count = mesh.triangleCount;
    this.order = order ?? Uint32Array.from({ length: count }, (_, t) => t);
    const position = new Float32Array(9 * count);
    const normal = new Int8Array(12 * count);
    for (let i = 0; i < count; ++i) {
      const t = this.order[i];
      for (let k = 0; k < 3; ++k) {
        const v = 3 * mesh.corners[3 * t + k];
        const at = 9 * i + 3 * k, to = 12 * i + 4 * k;
        for (let axis = 0; axis < 3; ++axis) {
          position[at + axis] = mesh.positions[v + axis];
          normal[to + axis] = Math.round(127 * normals[v + axis]);
        }
      }
    }
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    // Four to a corner for the alignment that graphics hardware likes.
    const normals4 = new THREE.InterleavedBuffer(normal, 4);
    this.geometry.setAttribute('normal', new THREE.InterleavedBufferAttribute(normals4, 3, 0, true));
    this.along = new THREE.InterleavedBuffer(new Int16Array(12 * count), 4);
    this.geometry.setAttribute('along', new THREE.InterleavedBufferAttribute(this.along, 3, 0, true));
    const perRow = Math.max(512, Math.ceil(count / 4096)); // every graphics card has a row of 2048
    const rows = Math.max(1, Math.ceil(count / perRow)); // a frame may have no triangles
    this.colours = new THREE.DataTexture(new Uint8Array(12 * perRow * rows).fill(255), 3 * perRow,
      rows);

    this.uniforms = {
      colours: { value: this.colours },
      perRow: { value: perRow },
      scale: { value: scaleColours.map((colour) => new THREE.Vector3(...colour.map((x) => x / 255))) },
      plane: { value: new THREE.Vector4() },
      opacity: { value: 1 },
      inside: { value: new THREE.Color(0.45, 0.44, 0.46) },
      wireColour: { value: new THREE.Color(0.08, 0.09, 0.12) },
    };
    const material = (more) => new THREE.ShaderMaterial({
      glslVersion: THREE.GLSL3, vertexShader, fragmentShader, uniforms: this.uniforms,
      side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2,
      ...more,
    });
    this.material = material({});
    this.body = new THREE.Mesh(this.geometry, this.material);
    this.body.renderOrder = 2;
    // Seen through, only the nearest sheet shows: this fills the depths first.
    this.veil = new THREE.Mesh(this.geometry, material({ colorWrite: false, transparent: true }));
    this.veil.renderOrder = 1;
    this.veil.visible = false;
    this.group = new THREE.Group();
    this.group.add(this.veil, this.body);
    for (const part of [this.body, this.veil]) part.frustumCulled = false;
  }

  // style: smooth, flat or wire; edges: whether the triangles' sides are drawn on the first two.
  set({ style, edges, seeThrough, cut }) {
    this.switches = { FLAT: style === 'flat', WIRE_ONLY: style === 'wire',
      WIRE: edges && style !== 'wire', CUT: cut };
    const isVeiled = seeThrough && style !== 'wire';
    this.#compile();
    if (this.material.transparent !== isVeiled) {
      this.material.transparent = isVeiled;
      this.material.needsUpdate = true;
    }
    this.uniforms.opacity.value = isVeiled ? 0.45 : 1;
    this.veil.visible = isVeiled;
  }

  // The shader has what is switched on, and no more.
  #compile() {
    const names = Object.keys(this.switches).filter((name) => this.switches[name]);
    if (this.isOnScale) names.push('SCALE');
    if (names.join() === this.compiled) return;
    this.compiled = names.join();
    for (const { material } of [this.body, this.veil]) {
      material.defines = Object.fromEntries(names.map((name) => [name, 1]));
      material.needsUpdate = true;
    }
  }

  // colouring: has `values`, by vertex from 0 to 1, to show on the scale; or `colours`, which writes
  // three colours of a triangle and may write the functions between its corners.
  paint(colouring) {
    this.isOnScale = Boolean(colouring.values);
    if (this.isOnScale) this.#paintValues(colouring.values());
    else this.#paintColours(colouring.colours());
    this.#compile();
  }

  #paintValues(values) {
    const { array } = this.along;
    for (let i = 0; i < this.order.length; ++i) {
      for (let k = 0; k < 3; ++k) {
        array[12 * i + 4 * k] = 32767 * values[this.mesh.corners[3 * this.order[i] + k]];
      }
    }
    this.along.needsUpdate = true;
  }

  #paintColours(coloursOf) {
    const { array } = this.along, texels = this.colours.image.data;
    const three = [null, null, null], between = new Float64Array(9);
    array.fill(0);
    for (let i = 0; i < this.order.length; ++i) {
      const isParted = coloursOf(this.order[i], three, between);
      for (let k = 0; k < 3; ++k) {
        for (let c = 0; c < 3; ++c) texels[12 * i + 4 * k + c] = three[k][c];
      }
      if (isParted) writeSigns(between, array, 12 * i);
    }
    this.along.needsUpdate = true;
    this.colours.needsUpdate = true;
  }

  // isHidden(t): whether a triangle is left out.
  hide(isHidden) {
    const texels = this.colours.image.data;
    this.order.forEach((t, i) => { texels[12 * i + 3] = isHidden(t) ? 0 : 255; });
    this.colours.needsUpdate = true;
  }

  // Shows the first triangles of the order only.
  show(triangles) {
    this.geometry.setDrawRange(0, 3 * triangles);
  }

  dispose() {
    this.geometry.dispose();
    this.colours.dispose();
    this.body.material.dispose();
    this.veil.material.dispose();
  }
}

// Three functions by their values at three corners, each on a scale of its own: where they are 0 is
// all that counts. between: three values of the first function, and so on.
function writeSigns(between, array, at) {
  for (let f = 0; f < 3; ++f) {
    const values = between.subarray(3 * f, 3 * f + 3);
    const most = Math.max(...values.map(Math.abs)) || 1;
    for (let k = 0; k < 3; ++k) array[at + 4 * k + f] = Math.round((32767 * values[k]) / most);
  }
}
