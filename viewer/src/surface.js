// The surface: triangles with corners of their own, in the order of their birth, so that a part of
// the sweep is a part of the array, and each triangle can have its own colour.

import * as THREE from 'three';

const vertexShader = /* glsl */ `
in vec3 colour;
uniform vec4 plane;
out vec3 vNormal;
out vec3 vPlace;
out vec3 vColour;
out vec3 vCorner;
out float vBeyond;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vPlace = place.xyz;
  vNormal = normalMatrix * normal;
  vColour = colour;
  // Corners of triangles lie one after the other; in which of the three this is tells the wires.
  int k = gl_VertexID % 3;
  vCorner = vec3(k == 0, k == 1, k == 2);
  vBeyond = dot(position, plane.xyz) - plane.w;
  gl_Position = projectionMatrix * place;
}`;

const fragmentShader = /* glsl */ `
in vec3 vNormal;
in vec3 vPlace;
in vec3 vColour;
in vec3 vCorner;
in float vBeyond;
uniform float opacity;
uniform vec3 inside;
uniform vec3 wireColour;
out vec4 result;
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
  vec3 base = gl_FrontFacing ? vColour : mix(vColour, inside, 0.75);
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
    const count = mesh.triangleCount;
    this.order = order ?? Uint32Array.from({ length: count }, (_, t) => t);
    const position = new Float32Array(9 * count);
    const normal = new Int8Array(12 * count);
    this.colours = new Uint8Array(9 * count);
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
    this.colourAttribute = new THREE.BufferAttribute(this.colours, 3, true);
    this.geometry.setAttribute('colour', this.colourAttribute);

    this.uniforms = {
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
    const defines = {};
    if (style === 'flat') defines.FLAT = 1;
    if (style === 'wire') defines.WIRE_ONLY = 1;
    else if (edges) defines.WIRE = 1;
    if (cut) defines.CUT = 1;
    const isVeiled = seeThrough && style !== 'wire';
    for (const part of [this.body, this.veil]) {
      if (JSON.stringify(part.material.defines ?? {}) !== JSON.stringify(defines)) {
        part.material.defines = { ...defines };
        part.material.needsUpdate = true;
      }
    }
    if (this.material.transparent !== isVeiled) {
      this.material.transparent = isVeiled;
      this.material.needsUpdate = true;
    }
    this.uniforms.opacity.value = isVeiled ? 0.45 : 1;
    this.veil.visible = isVeiled;
  }

  paint(colouring) {
    colouring.paint(this.colours, this.order);
    this.colourAttribute.needsUpdate = true;
  }

  // Shows the first triangles of the order only.
  show(triangles) {
    this.geometry.setDrawRange(0, 3 * triangles);
  }

  dispose() {
    this.geometry.dispose();
    this.body.material.dispose();
    this.veil.material.dispose();
  }
}
