// What the page shows, from the arrays it carries: the mesh, what is known of its vertices and
// triangles, and everything in coordinates about one centre.

import { extent, Mesh } from './mesh.js';
import { MixedComplex } from './mixed_complex.js';
import * as palette from './palette.js';

export const operationNames = ['creation', 'creep', 'wing', 'bridge', 'seal'];

function runningSums(numbers) {
  const sums = new Int32Array(numbers.length);
  let last = 0;
  for (let i = 0; i < numbers.length; ++i) sums[i] = last += numbers[i];
  return sums;
}

export class Scene {
  constructor(page) {
    this.page = page;
    const { about } = page;
    this.operationNames = operationNames;
    this.centre = about.mesh.grid.origin;
    this.mesh = new Mesh(page, 'mesh', this.centre);
    this.bounds = this.mesh.bounds();
    if (page.has('atoms.balls')) this.complex = new MixedComplex(page, this.centre);
    if (page.has('mesh.cell')) this.cells = runningSums(page.array('mesh.cell'));
    if (page.has('mesh.birth')) {
      this.birth = this.mesh.addParents(page.array('mesh.birth'));
      this.operation = page.array('mesh.operation');
      this.seam = page.array('mesh.seam');
    }
    if (page.has('critical.index')) this.points = this.#criticalPoints();
    this.isSimplified = false;
    this.isHidden = () => false; // by triangle
  }

  #criticalPoints() {
    const numbers = this.page.array('critical.points'), index = this.page.array('critical.index');
    const survives = this.page.array('critical.survives');
    return Array.from(index, (kind, i) => {
      const [x, y, z, value, scale, radius] = numbers.subarray(6 * i, 6 * i + 6);
      const position = [x, y, z].map((a, k) => a - this.centre[k]);
      return { position, value, scale, radius, index: kind, survives: survives[i] === 1 };
    });
  }

  // Normals by vertex: the skin's own where the mesh is on it, else the triangles'.
  normals() {
    if (!this.cells || this.page.about.kind !== 'molecule') return this.mesh.vertexNormals();
    const p = this.mesh.positions, normals = new Float32Array(p.length);
    for (let v = 0; v < this.mesh.vertexCount; ++v) {
      this.complex.normal(this.cells[v], p[3 * v], p[3 * v + 1], p[3 * v + 2], normals, 3 * v);
    }
    return normals;
  }

  // Triangles by birth.
  order() {
    if (!this.birth) return null;
    if (this.byBirth) return this.byBirth;
    const steps = this.page.about.sweep.steps;
    const first = this.birthCounts();
    const order = new Uint32Array(this.mesh.triangleCount), next = first.slice(0, steps);
    for (let t = 0; t < order.length; ++t) order[next[this.birth[t]]++] = t;
    this.byBirth = order;
    return order;
  }

  // By step how many triangles were there before it; one more entry at the end.
  birthCounts() {
    if (this.counts) return this.counts;
    this.counts = new Uint32Array(this.page.about.sweep.steps + 1);
    for (const step of this.birth) ++this.counts[step + 1];
    for (let i = 1; i < this.counts.length; ++i) this.counts[i] += this.counts[i - 1];
    return this.counts;
  }

  functionValue(x, y, z) {
    const f = this.page.about.function;
    const p = [x, y, z].map((a, k) => a + this.centre[k]);
    if (f.kind === 'height') return f.direction.reduce((sum, d, k) => sum + d * p[k], 0);
    return f.origin.reduce((sum, o, k) => sum + (p[k] - o) ** 2, 0);
  }

  // By vertex, in double precision, for they may be large and differ little.
  functionValues() {
    const p = this.mesh.positions;
    return Float64Array.from({ length: this.mesh.vertexCount }, (_, v) =>
      this.functionValue(p[3 * v], p[3 * v + 1], p[3 * v + 2]));
  }

  functionRange() {
    return (this.range ??= extent(this.functionValues()));
  }

  // The components of the mesh: by triangle its number; by number a name, triangles and, of a closed
  // mesh, the volume enclosed. Outer surfaces come first, then the walls of voids, the largest first.
  components() {
    return (this.sorted ??= sortedComponents(this.mesh, this.page.about.closed));
  }

  // Of the file, as far as it tells: { chain, residue, number, name }.
  label(atom) {
    if (!this.page.has('atoms.labels')) return null;
    this.labels ??= this.page.array('atoms.labels').split('\0');
    const [chain, residue, number, name] = this.labels.slice(4 * atom, 4 * atom + 4);
    return { chain, residue, number, name };
  }

  elementName(atom) {
    this.elementOf ??= this.page.array('atoms.element');
    return this.page.about.elements[this.elementOf[atom]] || '';
  }

  elementColour(atom) {
    return palette.elements[this.elementName(atom).toUpperCase()] ?? palette.otherElement;
  }

  elementsPresent() {
    const found = new Map();
    this.complex.atoms.forEach((_, i) => {
      const name = this.elementName(i) || 'unknown';
      if (!found.has(name)) found.set(name, { name, colour: this.elementColour(i), count: 0 });
      ++found.get(name).count;
    });
    return [...found.values()].sort((a, b) => b.count - a.count);
  }

  // By region its extrema, those that took the place of cancelled ones if the complex is shown
  // simplified, as one text.
  #regionNames() {
    const heirs = this.page.array('critical.heir');
    const last = (i) => {
      if (this.isSimplified) while (heirs[i] !== i) i = heirs[i];
      return i;
    };
    const maxima = this.page.array('regions.maximum');
    return Array.from(this.page.array('regions.minimum'), (m, i) => `${last(m)} ${last(maxima[i])}`);
  }

  regionCount() {
    return new Set(this.#regionNames()).size;
  }

  regionColours() {
    const number = new Map();
    return this.#regionNames().map((name) => {
      if (!number.has(name)) number.set(name, number.size);
      return palette.categorical(number.get(name));
    });
  }
}

function sortedComponents(mesh, isClosed) {
  const ofTriangle = mesh.components(), list = mesh.enclosed(ofTriangle);
  const order = list.map((_, i) => i);
  // A mesh whose largest component faces inward is inside out: its sides tell no voids.
  const largest = list.reduce((a, b) => (Math.abs(b.volume) > Math.abs(a.volume) ? b : a));
  const isNamed = isClosed && largest.volume >= 0;
  if (isClosed) {
    const isVoid = (i) => Number(isNamed && list[i].volume < 0);
    order.sort((i, j) => isVoid(i) - isVoid(j) ||
      Math.abs(list[j].volume) - Math.abs(list[i].volume));
  }
  const place = new Uint32Array(list.length);
  order.forEach((i, at) => { place[i] = at; });
  const outer = list.filter(({ volume }) => volume >= 0).length;
  const name = (i, at) => {
    if (!isNamed) return `component ${at + 1}`;
    if (list[i].volume < 0) return `void ${at - outer + 1}`;
    return outer === 1 ? 'outside' : `outside ${at + 1}`;
  };
  return { ofTriangle: ofTriangle.map((i) => place[i]),
    list: order.map((i, at) => ({ name: name(i, at), triangles: list[i].triangles,
      volume: isClosed ? Math.abs(list[i].volume) : null })) };
}
