// The mixed complex (section 2.1) from its atoms and simplices: centres, patches, walls, and the
// section with a plane. The formulas are those of skin/patch.h and skin/mixed_complex.h.

export const patchKinds = ['vertex: sphere', 'edge: hyperboloid', 'triangle: hyperboloid',
  'tetrahedron: sphere, hollow'];

// Corners ascend; the first is told by its difference from the simplex before, the others by
// theirs from the corner before.
function simplices(numbers, size) {
  const corners = new Uint32Array(numbers.length);
  let last = 0;
  for (let i = 0; i < numbers.length; i += size) {
    last = corners[i] = last + numbers[i];
    for (let k = 1; k < size; ++k) corners[i + k] = corners[i + k - 1] + numbers[i + k];
  }
  return corners;
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const unit = (a) => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

// Solves a system of one or two equations, given as rows with the right side last, in place.
function solved(rows) {
  const n = rows.length;
  for (let i = 0; i < n; ++i) {
    let pivot = i;
    for (let r = i + 1; r < n; ++r) if (Math.abs(rows[r][i]) > Math.abs(rows[pivot][i])) pivot = r;
    [rows[i], rows[pivot]] = [rows[pivot], rows[i]];
    for (let r = 0; r < n; ++r) {
      if (r === i) continue;
      const factor = rows[r][i] / rows[i][i];
      for (let c = i; c <= n; ++c) rows[r][c] -= factor * rows[i][c];
    }
  }
  return rows.map((row, i) => row[n] / row[i]);
}

// A tetrahedron whose volume is below this share of its edges' product is computed exactly.
const flat = 2 ** -20;

// The edges of a tetrahedron from its first ball, and by edge the power of its end less its own, at
// the first ball. Of numbers, or of whole ones in the place of them.
function arms(places, weights) {
  const [p, ...others] = places, edges = others.map((q) => minus(q, p));
  return { edges, powers: edges.map((e, i) => dot(e, e) + weights[0] - weights[i + 1]) };
}

// What skin/orthocentre.cpp calls a fraction: from the first ball the orthocentre is at
// numerator / (2 volume).
function fraction({ edges: [e, f, g], powers: [p, q, r] }) {
  const [a, b, c] = [cross(f, g), cross(g, e), cross(e, f)];
  return { numerator: a.map((x, k) => p * x + q * b[k] + r * c[k]), volume: dot(e, a) };
}

// The same of balls in whole units: coordinates are multiples of 2^-120, weights of its square.
function exactFraction(balls) {
  const whole = (x, power) => BigInt(Math.round(x * 2 ** power));
  return fraction(arms(balls.map((ball) => Array.from(ball.slice(0, 3), (x) => whole(x, 120))),
    balls.map((ball) => whole(ball[3], 240))));
}

// From the first of four balls to the orthocentre. exactBalls(): where they are in the file.
function toOrthocentre(balls, exactBalls) {
  const quick = arms(balls, balls.map((ball) => ball[3])), { numerator, volume } = fraction(quick);
  const edges = quick.edges.reduce((product, e) => product * Math.hypot(...e), 1);
  if (Math.abs(volume) > flat * edges) return numerator.map((x) => x / (2 * volume));
  const exact = exactFraction(exactBalls());
  return exact.numerator.map((x) => Number((x << 64n) / (2n * exact.volume)) / 2 ** 184);
}

export class MixedComplex {
  constructor(page, centre) {
    const balls = page.array('atoms.balls'); // x, y, z, weight
    this.balls = balls;
    this.atoms = [];
    for (let i = 0; i < balls.length; i += 4) {
      this.atoms.push([balls[i] - centre[0], balls[i + 1] - centre[1], balls[i + 2] - centre[2],
        balls[i + 3]]);
    }
    this.lists = ['vertices', 'edges', 'triangles', 'tetrahedra'].map((name, dimension) =>
      simplices(page.array(`complex.${name}`), dimension + 1));
    // Cells are numbered by dimension, in the order of the lists.
    this.first = [0];
    this.lists.forEach((list, dimension) =>
      this.first.push(this.first[dimension] + list.length / (dimension + 1)));
    this.size = this.first[4];
    this.centres = new Float64Array(3 * this.size);
    this.axes = new Float64Array(3 * this.size);
    for (let cell = 0; cell < this.size; ++cell) this.#place(cell);
  }

  dimension(cell) {
    let d = 3;
    while (cell < this.first[d]) --d;
    return d;
  }

  corners(cell) {
    const d = this.dimension(cell), from = (cell - this.first[d]) * (d + 1);
    return this.lists[d].subarray(from, from + d + 1);
  }

  // The orthocentre, where all corners have equal power, and the patch's axis.
  #place(cell) {
    const corners = Array.from(this.corners(cell)), balls = corners.map((atom) => this.atoms[atom]);
    const [p, ...others] = balls;
    if (balls.length === 4) {
      const off = toOrthocentre(balls, () => this.#exactBalls(corners));
      this.centres.set(off.map((x, k) => p[k] + x), 3 * cell);
      return;
    }
    const spans = others.map((q) => minus(q, p));
    const rows = spans.map((e, i) =>
      [...spans.map((f) => 2 * dot(e, f)), dot(e, e) + p[3] - others[i][3]]);
    const x = solved(rows);
    for (let k = 0; k < 3; ++k) {
      this.centres[3 * cell + k] = spans.reduce((sum, e, i) => sum + x[i] * e[k], p[k]);
    }
    if (spans.length === 1) this.axes.set(unit(spans[0]), 3 * cell);
    if (spans.length === 2) this.axes.set(unit(cross(spans[0], spans[1])), 3 * cell);
  }

  // As the file has them: taking off the centre rounds.
  #exactBalls(atoms) {
    return atoms.map((atom) => this.balls.subarray(4 * atom, 4 * atom + 4));
  }

  // The length scale and the unit normal at a point of the skin in a cell.
  lengthScale(cell, x, y, z) {
    const c = this.centres;
    return Math.hypot(x - c[3 * cell], y - c[3 * cell + 1], z - c[3 * cell + 2]);
  }

  normal(cell, x, y, z, result, at) {
    const c = this.centres, a = this.axes, i = 3 * cell;
    const ux = x - c[i], uy = y - c[i + 1], uz = z - c[i + 2];
    const twice = 2 * (a[i] * ux + a[i + 1] * uy + a[i + 2] * uz);
    const length = Math.hypot(ux, uy, uz) || 1;
    const sign = (cell < this.first[2] ? 1 : -1) / length;
    result[at] = sign * (ux - twice * a[i]);
    result[at + 1] = sign * (uy - twice * a[i + 1]);
    result[at + 2] = sign * (uz - twice * a[i + 2]);
  }

  // G (skin/patch.h), half its gradient, axis and sign of a cell's patch at a point.
  patchAt(cell, x) {
    const centre = this.centres.subarray(3 * cell, 3 * cell + 3);
    const axis = Array.from(this.axes.subarray(3 * cell, 3 * cell + 3));
    const sign = cell < this.first[2] ? 1 : -1;
    const u = minus(x, centre), twice = 2 * dot(axis, u);
    const halfGradient = u.map((a, k) => sign * (a - twice * axis[k]));
    const atom = this.atoms[this.corners(cell)[0]], off = minus(centre, atom);
    const halfWeight = (atom[3] - dot(off, off)) / 2;
    return { value: dot(u, halfGradient) - halfWeight, halfGradient, axis, sign };
  }

  // The corner of a cell's simplex with the least power at a point.
  nearestAtom(cell, x, y, z) {
    let best = 0, least = Infinity;
    for (const atom of this.corners(cell)) {
      const power = this.power(atom, x, y, z);
      if (power < least) [best, least] = [atom, power];
    }
    return best;
  }

  // By cell its walls, four numbers each: a normal out of the cell and an offset.
  walls() {
    if (this.wallLists) return this.wallLists;
    const place = this.lists.map((list, d) => {
      const places = new Map();
      for (let i = 0; i < list.length; i += d + 1) {
        places.set(list.subarray(i, i + d + 1).join(), this.first[d] + i / (d + 1));
      }
      return places;
    });
    const walls = Array.from({ length: this.size }, () => []);
    for (let large = this.first[1]; large < this.size; ++large) {
      const corners = Array.from(this.corners(large));
      for (const atom of corners) {
        const facet = corners.filter((other) => other !== atom);
        const small = place[facet.length - 1].get(facet.join());
        const wall = this.#wall(small, large, facet, atom);
        walls[small].push(...wall);
        walls[large].push(...wall.map((x) => -x));
      }
    }
    this.wallLists = walls;
    return walls;
  }

  // Between the cells of a simplex and of the one it makes with an atom: a normal to the second, and
  // an offset.
  #wall(small, large, facet, atom) {
    const n = this.#across(facet, atom), c = this.centres;
    let offset = 0;
    for (let k = 0; k < 3; ++k) offset += n[k] * (c[3 * small + k] + c[3 * large + k]) / 2;
    return [...n, offset];
  }

  // The wall between two cells, its normal to the second; nothing if they share none.
  wallBetween(one, other) {
    if (one > other) return this.wallBetween(other, one)?.map((x) => -x);
    const facet = Array.from(this.corners(one)), corners = Array.from(this.corners(other));
    const more = corners.filter((atom) => !facet.includes(atom));
    if (more.length !== 1 || corners.length !== facet.length + 1) return null;
    return this.#wall(one, other, facet, more[0]);
  }

  // The power of a point to an atom's ball.
  power(atom, x, y, z) {
    const [px, py, pz, w] = this.atoms[atom];
    return (x - px) ** 2 + (y - py) ** 2 + (z - pz) ** 2 - w;
  }

  // The part of an atom's direction that is orthogonal to a simplex it does not belong to.
  #across(facet, atom) {
    const [p, ...others] = facet.map((i) => this.atoms[i]);
    let v = minus(this.atoms[atom], p);
    if (others.length === 1) {
      const e = unit(minus(others[0], p)), along = dot(v, e);
      v = [v[0] - along * e[0], v[1] - along * e[1], v[2] - along * e[2]];
    } else if (others.length === 2) {
      const n = unit(cross(minus(others[0], p), minus(others[1], p))), up = dot(v, n);
      const isDoubtful = Math.abs(up) <= flat * Math.hypot(...v);
      const side = isDoubtful ? this.#exactSide([...facet, atom]) : Math.sign(up);
      v = [side * n[0], side * n[1], side * n[2]];
    }
    return unit(v);
  }

  // On which side of the plane of three atoms a fourth is.
  #exactSide(atoms) {
    return exactFraction(this.#exactBalls(atoms)).volume < 0n ? -1 : 1;
  }

  // The section with the plane of points origin + s u + t v, |s| and |t| at most `extent`: calls
  // visit(cell, polygon) for each cell that meets it, the polygon as a list of (s, t).
  section(origin, u, v, extent, visit) {
    const walls = this.walls();
    for (let cell = 0; cell < this.size; ++cell) {
      let polygon = [-extent, -extent, extent, -extent, extent, extent, -extent, extent];
      const list = walls[cell];
      for (let i = 0; i < list.length && polygon.length > 0; i += 4) {
        const n = [list[i], list[i + 1], list[i + 2]];
        polygon = clipped(polygon, dot(n, u), dot(n, v), list[i + 3] - dot(n, origin));
      }
      if (polygon.length >= 6) visit(cell, polygon);
    }
  }
}

// The part of a convex polygon with a s + b t <= c.
function clipped(polygon, a, b, c) {
  const result = [];
  const n = polygon.length;
  let s0 = polygon[n - 2], t0 = polygon[n - 1], d0 = a * s0 + b * t0 - c;
  for (let i = 0; i < n; i += 2) {
    const s = polygon[i], t = polygon[i + 1], d = a * s + b * t - c;
    if ((d0 < 0 && d > 0) || (d0 > 0 && d < 0)) {
      const share = d0 / (d0 - d);
      result.push(s0 + share * (s - s0), t0 + share * (t - t0));
    }
    if (d <= 0) result.push(s, t);
    [s0, t0, d0] = [s, t, d];
  }
  return result;
}
