// What a click on the surface tells: the triangle, its corner nearest to the click, atom and residue.

import * as THREE from 'three';
import { decimals, signed } from './headline.js';
import { patchKinds } from './mixed_complex.js';

const short = (x) => Number(x.toPrecision(4)).toString();
const degrees = 180 / Math.PI;

// The triangle and the corner under a place of the window, from -1 to 1, or nothing.
export function pick(viewer, x, y) {
  const { surface, stage, scene } = viewer;
  const ray = new THREE.Raycaster();
  ray.setFromCamera(new THREE.Vector2(x, y), stage.camera);
  const plane = surface.uniforms.plane.value;
  const isSeen = ({ point, faceIndex }) => !scene.isHidden(surface.order[faceIndex]) &&
    (!viewer.state.cut || point.x * plane.x + point.y * plane.y + point.z * plane.z <= plane.w);
  const hit = ray.intersectObject(surface.body, false).find(isSeen);
  if (!hit) return null;
  const triangle = surface.order[hit.faceIndex];
  const corners = [...scene.mesh.corners.subarray(3 * triangle, 3 * triangle + 3)];
  const far = (v) => hit.point.distanceTo(place(scene, v));
  return { triangle, vertex: corners.reduce((best, v) => (far(v) < far(best) ? v : best)) };
}

function place({ mesh }, v) {
  return new THREE.Vector3(...mesh.positions.subarray(3 * v, 3 * v + 3));
}

// Rows of a table, each a name and what it is, as far as the page knows.
export function facts(scene, { triangle, vertex }) {
  const corners = [...scene.mesh.corners.subarray(3 * triangle, 3 * triangle + 3)];
  const p = corners.map((v) => place(scene, v));
  const sides = [0, 1, 2].map((k) => p[(k + 1) % 3].distanceTo(p[(k + 2) % 3]));
  const angles = [0, 1, 2].map((k) => p[(k + 1) % 3].clone().sub(p[k])
    .angleTo(p[(k + 2) % 3].clone().sub(p[k])) * degrees);
  const rows = [['Triangle', `angles ${angles.map((a) => a.toFixed(1)).join('°, ')}°`]];
  if (scene.operation) {
    const where = scene.seam[triangle] ? ', where two fronts met' : '';
    rows.push(['Laid by', scene.operationNames[scene.operation[triangle]] + where]);
  }
  const at = place(scene, vertex), file = at.toArray().map((x, k) => x + scene.centre[k]);
  const told = (x) => signed(x.toFixed(decimals(3, scene.bounds.radius)));
  rows.push(['Vertex', `at ${file.map(told).join(', ')}`]);
  if (!scene.cells) return rows;
  const { complex, cells } = scene;
  const rho = corners.map((v, k) => complex.lengthScale(cells[v], ...p[k].toArray()));
  const { C, Q, largest_length_scale: largest = Infinity } = scene.page.about;
  if (C) {
    const scale = (...scales) => Math.min(Math.max(...scales), largest);
    const circumradius = sides[0] / (2 * Math.sin(angles[0] / degrees));
    const least = Math.min(...sides.map((side, k) =>
      (Q * side) / (2 * C * scale(rho[(k + 1) % 3], rho[(k + 2) % 3]))));
    rows.push(['[L] (above 1)', short(least)],
      ['[U] (below 1)', short(circumradius / (C * Q * scale(Math.min(...rho))))]);
  }
  const kind = complex.dimension(cells[vertex]);
  rows.push(['ρ', `${short(rho[corners.indexOf(vertex)])} Å`],
    ['Cell', `${patchKinds[kind]}; ${kind === 0 ? 'ball' : 'balls'} ${
      [...complex.corners(cells[vertex])].map((atom) => atom + 1).join(', ')}`]);
  const atom = complex.nearestAtom(cells[vertex], ...at.toArray());
  rows.push(['Nearest ball', `${atom + 1} ${scene.elementName(atom)}`.trim()]);
  const label = scene.label(atom);
  if (label) {
    rows.push(['Its atom', label.name], ['Residue', `${label.residue} ${label.number}`.trim() +
      (label.chain && `, chain ${label.chain}`)]);
  }
  return rows.filter(([, words]) => words !== '');
}

// Such rows in one line: the atom, or all of them where no molecule is known.
export function inOneLine(rows) {
  const atom = rows.filter(([name]) => ['Nearest ball', 'Its atom', 'Residue'].includes(name));
  return (atom.length > 0 ? atom : rows).map((row) => row.join(' ').trim()).join(' · ');
}
