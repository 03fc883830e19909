// A mesh of the page: corners, positions about a centre, and what follows from them alone.

import { readFrontCode } from './front_code.js';

// The least and the greatest of many numbers.
export function extent(numbers) {
  let low = Infinity, high = -Infinity;
  for (const x of numbers) {
    low = Math.min(low, x);
    high = Math.max(high, x);
  }
  return { low, high };
}

export class Mesh {
  // centre: what to take off all positions, so that single precision is enough for them.
  constructor(page, name, centre) {
    const { triangles, vertices, grid } = page.about[name];
    this.triangleCount = triangles;
    this.vertexCount = vertices;
    const code = readFrontCode(page.array(`${name}.cases`), page.array(`${name}.references`),
      triangles, vertices);
    this.corners = code.corners;
    this.parents = code.parents;
    this.positions = new Float32Array(3 * vertices);
    const at = new Int32Array(vertices);
    for (let k = 0; k < 3; ++k) {
      const off = page.array(`${name}.${'xyz'[k]}`);
      const origin = grid.origin[k] - centre[k];
      for (let v = 0; v < vertices; ++v) {
        const [p, q, r] = [code.predictors[3 * v], code.predictors[3 * v + 1], code.predictors[3 * v + 2]];
        at[v] = off[v] + (v === 0 ? 0 : at[p] + at[q] - at[r]);
        this.positions[3 * v + k] = origin + grid.step * at[v];
      }
    }
  }

  // Numbers written as differences from the triangle each was laid against.
  addParents(off) {
    const values = new Uint32Array(off.length);
    for (let t = 0; t < off.length; ++t) {
      values[t] = off[t] + (t === 0 ? 0 : values[this.parents[t]]);
    }
    return values;
  }

  // Reaches of the mesh: the box, the ball about its middle, some of the vertices, and the angle
  // about y from which it is seen the widest.
  bounds() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.positions.length; ++i) {
      const k = i % 3, x = this.positions[i];
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
    const middle = low.map((x, k) => (x + high[k]) / 2);
    let radius = 0;
    for (let i = 0; i < this.positions.length; i += 3) {
      radius = Math.max(radius, Math.hypot(this.positions[i] - middle[0],
        this.positions[i + 1] - middle[1], this.positions[i + 2] - middle[2]));
    }
    const each = 3 * Math.ceil(this.vertexCount / 20000);
    const sample = [];
    let xx = 0, xz = 0, zz = 0;
    for (let i = 0; i < this.positions.length; i += each) {
      const [x, y, z] = this.positions.subarray(i, i + 3);
      sample.push(x, y, z);
      xx += (x - middle[0]) ** 2;
      xz += (x - middle[0]) * (z - middle[2]);
      zz += (z - middle[2]) ** 2;
    }
    // The long axis of what lies beside the y axis is seen across.
    const widest = -Math.atan2(2 * xz, xx - zz) / 2;
    return { low, high, middle, radius: radius || 1, widest, sample };
  }

  // Unit normals by vertex, each triangle weighing as its area.
  vertexNormals() {
    const { positions: p, corners } = this;
    const normals = new Float32Array(p.length);
    for (let i = 0; i < corners.length; i += 3) {
      const a = 3 * corners[i], b = 3 * corners[i + 1], c = 3 * corners[i + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      for (const v of [a, b, c]) {
        normals[v] += nx;
        normals[v + 1] += ny;
        normals[v + 2] += nz;
      }
    }
    for (let v = 0; v < normals.length; v += 3) {
      const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
      for (let k = 0; k < 3; ++k) normals[v + k] /= length;
    }
    return normals;
  }

  // The smallest angle of each triangle, degrees; where rounding to the grid brings one below the
  // mesh's own least, that.
  smallestAngles(least = 0) {
    const angles = new Float32Array(this.triangleCount);
    for (let t = 0; t < angles.length; ++t) {
      const sides = this.#squaredSides(t);
      const cosine = (sides[1] + sides[2] - sides[0]) / (2 * Math.sqrt(sides[1] * sides[2]));
      const angle = Number.isFinite(cosine) ? Math.acos(Math.min(1, cosine)) * 180 / Math.PI : 0;
      angles[t] = Math.max(least, angle);
    }
    return angles;
  }

  // How many triangles have an angle above 90 degrees.
  obtuseTriangles() {
    let count = 0;
    for (let t = 0; t < this.triangleCount; ++t) {
      const [short, middle, long] = this.#squaredSides(t);
      count += long > short + middle;
    }
    return count;
  }

  // Ascending.
  #squaredSides(t) {
    const { positions: p, corners } = this;
    const [a, b, c] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
    const side = (u, v) => (p[u] - p[v]) ** 2 + (p[u + 1] - p[v + 1]) ** 2 + (p[u + 2] - p[v + 2]) ** 2;
    return [side(a, b), side(b, c), side(c, a)].sort((x, y) => x - y);
  }

  // The connected component of each triangle, numbered as they come.
  components() {
    const parent = new Uint32Array(this.vertexCount).map((_, v) => v);
    const root = (v) => {
      while (parent[v] !== v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (let i = 0; i < this.corners.length; i += 3) {
      const a = root(this.corners[i]);
      parent[root(this.corners[i + 1])] = a;
      parent[root(this.corners[i + 2])] = a;
    }
    const number = new Map();
    return new Uint32Array(this.triangleCount).map((_, t) => {
      const r = root(this.corners[3 * t]);
      if (!number.has(r)) number.set(r, number.size);
      return number.get(r);
    });
  }

  // By component its triangles and the volume on their inner side, below 0 for the walls of a void.
  enclosed(components) {
    const list = [], { corners, positions: p } = this;
    for (let t = 0; t < components.length; ++t) {
      const [a, b, c] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
      // From a corner of the component, so that a small one far away is not lost in rounding.
      const of = (list[components[t]] ??= { triangles: 0, volume: 0, from: a });
      const x = (v, k) => p[v + k] - p[of.from + k];
      const det = x(a, 0) * (x(b, 1) * x(c, 2) - x(b, 2) * x(c, 1)) +
        x(a, 1) * (x(b, 2) * x(c, 0) - x(b, 0) * x(c, 2)) +
        x(a, 2) * (x(b, 0) * x(c, 1) - x(b, 1) * x(c, 0));
      ++of.triangles;
      of.volume += det / 6;
    }
    return list;
  }

  // Edges with a triangle on each side: two vertices and both triangles to an edge. An edge with
  // any other number of triangles is left out.
  edges() {
    const { corners, vertexCount } = this;
    const half = corners.length;
    const end = (h) => corners[h % 3 === 2 ? h - 2 : h + 1];
    const first = new Uint32Array(vertexCount + 1);
    for (let h = 0; h < half; ++h) ++first[Math.min(corners[h], end(h)) + 1];
    for (let v = 0; v < vertexCount; ++v) first[v + 1] += first[v];
    const next = first.slice(), listed = new Uint32Array(half);
    for (let h = 0; h < half; ++h) listed[next[Math.min(corners[h], end(h))]++] = h;
    const edges = new Uint32Array(2 * half);
    let count = 0;
    for (let v = 0; v < vertexCount; ++v) {
      for (let i = first[v]; i < first[v + 1]; ++i) {
        const h = listed[i];
        if (corners[h] !== v) continue;
        for (let j = first[v]; j < first[v + 1]; ++j) {
          const g = listed[j];
          if (end(g) !== v || corners[g] !== end(h)) continue;
          edges.set([v, end(h), (h / 3) | 0, (g / 3) | 0], count);
          count += 4;
          break;
        }
      }
    }
    return edges.subarray(0, count);
  }
}
