// The sweep run through again: which triangles there are at a step, where the front is, and what
// has been done.

import { FrontLines } from './layers.js';
import { operationNames } from './scene.js';

export class Sweep {
  constructor(scene) {
    this.scene = scene;
    this.steps = scene.page.about.sweep.steps;
    this.step = this.steps;
    this.done = operationNames.map((_, kind) => {
      const sums = scene.page.array(`sweep.done.${kind}`);
      for (let i = 1; i < sums.length; ++i) sums[i] += sums[i - 1];
      return sums;
    });
  }

  // Edges whose triangles were born at different steps, by the first birth. Made when first asked
  // for, for it takes a while.
  #prepare() {
    if (this.front) return;
    const { mesh, birth } = this.scene;
    const all = mesh.edges();
    const count = new Uint32Array(this.steps + 2), change = new Int32Array(this.steps + 2);
    const from = (i) => Math.min(birth[all[i + 2]], birth[all[i + 3]]);
    const to = (i) => Math.max(birth[all[i + 2]], birth[all[i + 3]]);
    for (let i = 0; i < all.length; i += 4) {
      if (from(i) === to(i)) continue;
      ++count[from(i) + 1];
      ++change[from(i)];
      --change[to(i)];
    }
    for (let s = 0; s <= this.steps; ++s) count[s + 1] += count[s];
    const total = count[this.steps + 1];
    this.ends = new Uint32Array(2 * total);
    this.until = new Uint32Array(total);
    this.beside = new Uint32Array(total); // a triangle of the edge
    const next = count.slice();
    for (let i = 0; i < all.length; i += 4) {
      if (from(i) === to(i)) continue;
      const at = next[from(i)]++;
      this.ends.set([all[i], all[i + 1]], 2 * at);
      this.until[at] = to(i);
      this.beside[at] = all[i + 2];
    }
    this.firstOf = count;
    let most = 0, now = 0;
    for (const c of change) most = Math.max(most, now += c);
    this.front = new FrontLines(most);
  }

  get frontObject() {
    this.#prepare();
    return this.front.object;
  }

  // Everything that was born before `step`.
  go(step) {
    this.step = Math.max(0, Math.min(this.steps, Math.round(step)));
    if (this.step === this.steps && !this.front) return;
    this.#prepare();
    const p = this.scene.mesh.positions, { array } = this.front;
    const last = this.firstOf[this.step];
    let n = 0;
    for (let e = 0; e < last; ++e) {
      if (this.until[e] < this.step || this.scene.isHidden(this.beside[e])) continue;
      for (let k = 0; k < 2; ++k) {
        const v = 3 * this.ends[2 * e + k], at = 6 * n + 3 * k;
        array[at] = p[v];
        array[at + 1] = p[v + 1];
        array[at + 2] = p[v + 2];
      }
      ++n;
    }
    this.frontEdges = n;
    this.front.set(n);
  }

  // How far the sweep has come: the function's value where the last triangle was laid.
  level() {
    const { mesh } = this.scene, p = mesh.positions;
    const t = this.scene.order()[this.triangles() - 1];
    if (t === undefined) return NaN;
    let lowest = Infinity;
    for (let k = 0; k < 3; ++k) {
      const v = 3 * mesh.corners[3 * t + k];
      lowest = Math.min(lowest, this.scene.functionValue(p[v], p[v + 1], p[v + 2]));
    }
    return lowest;
  }

  // How often each operation was done by now, and in all.
  counts() {
    return this.done.map((sums) =>
      ({ now: this.step === 0 ? 0 : sums[this.step - 1], all: sums[this.steps - 1] ?? 0 }));
  }

  triangles() {
    return this.scene.birthCounts()[this.step];
  }
}
