// Layers beside the surface: atoms, critical points, integral lines, protecting spheres, and the
// section of the mixed complex.

import * as THREE from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import * as palette from './palette.js';

const threeColour = ([r, g, b]) => new THREE.Color().setRGB(r / 255, g / 255, b / 255);

// By index of the critical point: minimum, saddle, maximum.
const pointColours = [palette.red, palette.blue, palette.green];

// Balls lit as the surface is: from the eye, and from above right.
function ballMaterial(more) {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: /* glsl */ `
      in vec3 tint;
      out vec3 vNormal; out vec3 vColour;
      void main() {
        vNormal = normalMatrix * normal;
        vColour = tint;
        gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      in vec3 vNormal; in vec3 vColour;
      uniform float opacity;
      out vec4 result;
      void main() {
        vec3 n = normalize(vNormal);
        const vec3 key = normalize(vec3(0.45, 0.6, 0.75));
        float light = 0.34 + 0.55 * max(dot(n, key), 0.0) + 0.2 * max(n.z, 0.0);
        float rim = 1.0 - max(n.z, 0.0);
        result = vec4(vColour * light, mix(opacity, 1.0, opacity < 1.0 ? 0.55 * rim * rim : 0.0));
      }`,
    uniforms: { opacity: { value: 1 } },
    ...more,
  });
}

// balls: [x, y, z, radius, colour]
function ballMesh(balls, detail, material) {
  const geometry = new THREE.IcosahedronGeometry(1, detail);
  const tints = new Uint8Array(3 * balls.length);
  const mesh = new THREE.InstancedMesh(geometry, material, balls.length);
  const matrix = new THREE.Matrix4();
  balls.forEach(([x, y, z, radius, colour], i) => {
    mesh.setMatrixAt(i, matrix.makeScale(radius, radius, radius).setPosition(x, y, z));
    tints.set(colour.map(Math.round), 3 * i);
  });
  geometry.setAttribute('tint', new THREE.InstancedBufferAttribute(tints, 3, true));
  mesh.frustumCulled = false;
  return mesh;
}

// A third of the van der Waals radius, as in ball-and-stick drawings.
const atomShare = 0.33;

export function atomLayer(scene) {
  const radii = scene.page.array('atoms.radius');
  const balls = scene.complex.atoms.map(([x, y, z], i) =>
    [x, y, z, atomShare * radii[i], scene.elementColour(i)]);
  return ballMesh(balls, balls.length > 3000 ? 1 : balls.length > 600 ? 2 : 3, ballMaterial());
}

export function sphereLayer(points) {
  const balls = points.map(({ position, radius, index }) =>
    [...position, radius, pointColours[index]]);
  const material = ballMaterial({ transparent: true, depthWrite: false });
  material.uniforms.opacity.value = 0.3;
  const mesh = ballMesh(balls, 3, material);
  mesh.renderOrder = 4;
  return mesh;
}

// Critical points as discs that never get smaller than a few pixels.
export function pointLayer(points, pixelRatio) {
  const geometry = new THREE.BufferGeometry();
  const place = new Float32Array(points.flatMap(({ position }) => position));
  const tint = new Uint8Array(points.flatMap(({ index }) => pointColours[index]));
  const size = new Float32Array(points.map(({ survives }) => (survives ? 1 : 0.62)));
  geometry.setAttribute('position', new THREE.BufferAttribute(place, 3));
  geometry.setAttribute('tint', new THREE.BufferAttribute(tint, 3, true));
  geometry.setAttribute('size', new THREE.BufferAttribute(size, 1));
  const material = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: /* glsl */ `
      in vec3 tint; in float size;
      uniform float pixelRatio;
      out vec3 vColour;
      void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        // Before the surface they lie on.
        place.xyz *= 1.0 - 0.12 / max(-place.z, 1.0);
        vColour = tint;
        gl_PointSize = size * pixelRatio * clamp(420.0 / -place.z, 10.0, 20.0);
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: /* glsl */ `
      in vec3 vColour;
      out vec4 result;
      void main() {
        vec2 d = 2.0 * gl_PointCoord - 1.0;
        float r = dot(d, d);
        if (r > 1.0) discard;
        vec3 n = vec3(d.x, -d.y, sqrt(1.0 - r));
        float light = 0.62 + 0.45 * max(dot(n, normalize(vec3(0.4, 0.6, 0.7))), 0.0);
        result = vec4(r > 0.78 ? vec3(1.0) : vColour * light, 1.0);
      }`,
    uniforms: { pixelRatio: { value: pixelRatio } },
  });
  const layer = new THREE.Points(geometry, material);
  layer.renderOrder = 3;
  layer.frustumCulled = false;
  return layer;
}

function lineMaterial(colour, width) {
  return new LineMaterial({ color: threeColour(colour), linewidth: width, polygonOffset: true,
    polygonOffsetFactor: -2, polygonOffsetUnits: -4 });
}

// Integral lines: to minima red, to maxima green.
export function lineLayer(page, name, centre) {
  const { grid } = page.about[name];
  const lengths = page.array(`${name}.lengths`), index = page.array(`${name}.index`);
  const axes = ['x', 'y', 'z'].map((axis) => page.array(`${name}.${axis}`));
  const segments = { 0: [], 2: [] };
  const at = [0, 0, 0];
  let i = 0;
  for (let line = 0; line < lengths.length; ++line) {
    let last;
    for (let k = 0; k < lengths[line]; ++k, ++i) {
      for (let axis = 0; axis < 3; ++axis) at[axis] += axes[axis][i];
      const p = at.map((n, axis) => grid.origin[axis] + grid.step * n - centre[axis]);
      if (last) segments[index[line]].push(...last, ...p);
      last = p;
    }
  }
  const group = new THREE.Group();
  for (const [kind, colour] of [[0, palette.red], [2, palette.green]]) {
    if (segments[kind].length === 0) continue;
    const geometry = new LineSegmentsGeometry().setPositions(segments[kind]);
    const lines = new LineSegments2(geometry, lineMaterial(colour, 2.2));
    lines.renderOrder = 3;
    lines.frustumCulled = false;
    group.add(lines);
  }
  return group;
}

// Segments whose number changes: the front of the sweep.
export class FrontLines {
  constructor(most) {
    this.array = new Float32Array(6 * Math.max(most, 1));
    const buffer = new THREE.InstancedInterleavedBuffer(this.array, 6, 1);
    buffer.setUsage(THREE.DynamicDrawUsage);
    this.buffer = buffer;
    this.geometry = new LineSegmentsGeometry();
    this.geometry.setAttribute('instanceStart', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
    this.geometry.setAttribute('instanceEnd', new THREE.InterleavedBufferAttribute(buffer, 3, 3));
    this.object = new LineSegments2(this.geometry, lineMaterial([255, 112, 32], 2.6));
    this.object.renderOrder = 3;
    this.object.frustumCulled = false;
    this.set(0);
  }

  set(count) {
    this.geometry.instanceCount = count;
    this.buffer.needsUpdate = true;
    this.object.visible = count > 0;
  }
}

// The section of the mixed complex with a plane, cell by cell: full colour in the body, faint
// outside, and a dark line where the skin is.
//
// G is quadratic in a cell, so it is told by its value and half gradient at one corner and by the
// patch's axis and sign; centres of flat cells are too far away for single precision.
function sectionMaterial() {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3, side: THREE.DoubleSide, transparent: true,
    vertexShader: /* glsl */ `
      in vec3 tint; in vec4 start; in vec4 halfGradient; in vec4 axis;
      out vec3 vColour; out vec3 vOff; out vec4 vHalfGradient; out vec4 vAxis;
      void main() {
        vColour = tint;
        vOff = position - start.xyz;
        vHalfGradient = vec4(halfGradient.xyz, start.w);
        vAxis = axis;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      in vec3 vColour; in vec3 vOff; in vec4 vHalfGradient; in vec4 vAxis;
      out vec4 result;
      void main() {
        float along = dot(vAxis.xyz, vOff);
        float g = vHalfGradient.w + 2.0 * dot(vHalfGradient.xyz, vOff) +
          vAxis.w * (dot(vOff, vOff) - 2.0 * along * along);
        float skin = 1.0 - smoothstep(0.6, 1.6, abs(g) / max(fwidth(g), 1e-30));
        vec3 colour = mix(vColour, vec3(0.07, 0.08, 0.1), skin);
        result = vec4(colour, g > 0.0 ? max(0.16, skin) : 1.0);
      }`,
  });
}

export class SectionLayer {
  constructor(complex) {
    this.complex = complex;
    this.group = new THREE.Group();
    this.material = sectionMaterial();
    this.lineMaterial = new THREE.LineBasicMaterial({ color: 0x20242c, transparent: true,
      opacity: 0.28 });
    this.counts = [0, 0, 0, 0];
  }

  // normal: unit; offset along it; middle and extent: the square of the plane that is shown.
  update(normal, offset, middle, extent) {
    const n = new THREE.Vector3(...normal);
    const u = new THREE.Vector3(Math.abs(n.x) < 0.9 ? 1 : 0, Math.abs(n.x) < 0.9 ? 0 : 1, 0)
      .cross(n).normalize();
    const v = n.clone().cross(u);
    const m = new THREE.Vector3(...middle);
    const origin = m.addScaledVector(n, offset - m.dot(n));
    const arrays = { position: [], tint: [], start: [], halfGradient: [], axis: [] }, edges = [];
    this.counts = [0, 0, 0, 0];
    const position = (s, t) => [origin.x + s * u.x + t * v.x, origin.y + s * u.y + t * v.y,
      origin.z + s * u.z + t * v.z];
    this.complex.section(origin.toArray(), u.toArray(), v.toArray(), extent, (cell, polygon) => {
      const dimension = this.complex.dimension(cell);
      ++this.counts[dimension];
      const corners = [];
      for (let i = 0; i < polygon.length; i += 2) corners.push(position(polygon[i], polygon[i + 1]));
      const { value, halfGradient, axis, sign } = this.complex.patchAt(cell, corners[0]);
      const colour = palette.kinds[dimension].map((x) => x / 255);
      for (let i = 0; i < corners.length; ++i) {
        edges.push(...corners[i], ...corners[(i + 1) % corners.length]);
        if (i < 2) continue;
        for (const corner of [corners[0], corners[i - 1], corners[i]]) {
          arrays.position.push(...corner);
          arrays.tint.push(...colour);
          arrays.start.push(...corners[0], value);
          arrays.halfGradient.push(...halfGradient, 0);
          arrays.axis.push(...axis, sign);
        }
      }
    });
    this.dispose();
    const fill = new THREE.BufferGeometry();
    for (const [name, numbers] of Object.entries(arrays)) {
      const size = name === 'position' || name === 'tint' ? 3 : 4;
      fill.setAttribute(name, new THREE.Float32BufferAttribute(numbers, size));
    }
    const outline = new THREE.BufferGeometry();
    outline.setAttribute('position', new THREE.Float32BufferAttribute(edges, 3));
    this.group.add(new THREE.Mesh(fill, this.material),
      new THREE.LineSegments(outline, this.lineMaterial));
    for (const part of this.group.children) part.frustumCulled = false;
  }

  dispose() {
    for (const part of this.group.children) part.geometry.dispose();
    this.group.clear();
  }
}
