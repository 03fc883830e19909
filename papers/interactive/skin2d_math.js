// The skin of discs in the plane (section 2.1): mixed cells, the curve in each, and its mesh.
//
// A disc is {z: [x, y], w}, w its squared radius. A cell has the simplex's orthocentre and weight:
// G = |across|^2 - |along|^2 - w/2 with `along` in the span of the simplex, N half its gradient.

const add = (a, b) => [a[0] + b[0], a[1] + b[1]];
const subtract = (a, b) => [a[0] - b[0], a[1] - b[1]];
const times = (a, s) => [a[0] * s, a[1] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
const norm = (a) => Math.hypot(...a);
const middle = (a, b) => times(add(a, b), 0.5);
const farAway = 1e4; // half the box that unbounded cells are cut to

// Corners of the power cell of disc i, anticlockwise; `beyond` is the disc whose power is less
// beyond the side that leaves the corner, -1 at the box.
export function powerCell(discs, i) {
  const f = farAway;
  let corners = [[-f, -f], [f, -f], [f, f], [-f, f]].map((p) => ({ p, beyond: -1 }));
  discs.forEach((disc, j) => {
    if (j === i || corners.length === 0) return;
    const n = subtract(disc.z, discs[i].z);
    if (norm(n) === 0) {
      if (disc.w > discs[i].w || (disc.w === discs[i].w && j < i)) corners = [];
      return;
    }
    const power = (d) => dot(d.z, d.z) - d.w;
    const offset = (power(disc) - power(discs[i])) / 2;
    const side = corners.map(({ p }) => dot(n, p) - offset);
    const kept = [];
    corners.forEach((corner, k) => {
      const l = (k + 1) % corners.length, next = corners[l];
      const cut = () => add(corner.p, times(subtract(next.p, corner.p), side[k] / (side[k] - side[l])));
      if (side[k] <= 0) kept.push(corner);
      if (side[k] <= 0 && side[l] > 0) kept.push({ p: cut(), beyond: j });
      if (side[k] > 0 && side[l] <= 0) kept.push({ p: cut(), beyond: corner.beyond });
    });
    corners = kept.length > 2 ? kept : [];
  });
  return corners;
}

// Where the span of two discs meets the line of equal power, and the weight there.
function edgeCell(a, b) {
  const d = subtract(b.z, a.z), length = norm(d);
  const t = 0.5 + (a.w - b.w) / (2 * length * length);
  return { kind: 1, centre: add(a.z, times(d, t)), weight: a.w - (t * length) ** 2,
    axis: times(d, 1 / length) };
}

// Each cell is half the sum of a simplex and its power cell.
export function mixedCells(discs) {
  const cells = [], triangles = new Set();
  discs.forEach((disc, i) => {
    const corners = powerCell(discs, i);
    if (corners.length === 0) return;
    cells.push({ kind: 0, discs: [i], centre: disc.z, weight: disc.w,
      polygon: corners.map(({ p }) => middle(disc.z, p)) });
    corners.forEach(({ p, beyond: j }, k) => {
      const q = corners[(k + 1) % corners.length].p;
      const before = corners[(k + corners.length - 1) % corners.length].beyond;
      if (j > i && norm(subtract(p, q)) > 1e-9) {
        cells.push({ ...edgeCell(disc, discs[j]), discs: [i, j],
          polygon: [middle(disc.z, p), middle(discs[j].z, p), middle(discs[j].z, q), middle(disc.z, q)] });
      }
      if (j < 0 || before < 0 || j === before) return;
      const three = [i, j, before].sort((a, b) => a - b);
      if (triangles.has(three.join())) return;
      triangles.add(three.join());
      const u = subtract(p, disc.z);
      cells.push({ kind: 2, discs: three, centre: p, weight: disc.w - dot(u, u),
        polygon: three.map((l) => middle(discs[l].z, p)) });
    });
  });
  for (const cell of cells) makeAnticlockwise(cell.polygon);
  return cells;
}

function turn(a, b, c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

function makeAnticlockwise(polygon) {
  let area = 0;
  for (let k = 1; k + 1 < polygon.length; ++k) area += turn(polygon[0], polygon[k], polygon[k + 1]);
  if (area < 0) polygon.reverse();
}

export function isIn(cell, x) {
  return cell.polygon.every((a, k) => turn(a, cell.polygon[(k + 1) % cell.polygon.length], x) >= 0);
}

// G, N and the length scale of a cell's patch at x; c and q are the sandwiching circles' centres.
export function evaluate(cell, x) {
  const u = subtract(x, cell.centre);
  let N = cell.kind === 2 ? times(u, -1) : u;
  if (cell.kind === 1) N = subtract(u, times(cell.axis, 2 * dot(u, cell.axis)));
  return { G: dot(u, N) - cell.weight / 2, N, rho: norm(u), c: subtract(x, N), q: add(x, N) };
}

export const cellAt = (cells, x) => cells.find((cell) => isIn(cell, x)) ?? cells[0];

// The patch's curve as branches with a parameter: the angle of a circle, the area of a hyperbola.
// Of both the derivative is as long as the length scale, so a difference of parameters is a length
// over rho.
function branches({ kind, centre, weight, axis }) {
  const half = weight / 2;
  if (kind !== 1) {
    const squared = kind === 0 ? half : -half;
    if (!(squared > 0)) return [];
    const r = Math.sqrt(squared);
    return [{ isCircle: true, has: () => true,
      at: (t) => add(centre, [r * Math.cos(t), r * Math.sin(t)]),
      parameter: (x) => Math.atan2(x[1] - centre[1], x[0] - centre[0]) }];
  }
  const across = [-axis[1], axis[0]];
  const [free, bound] = half > 0 ? [axis, across] : [across, axis];
  const root = Math.sqrt(Math.abs(half)) || 1e-9; // not 0, where the skin is singular
  return [1, -1].map((sign) => ({ isCircle: false,
    has: (x) => sign * dot(subtract(x, centre), bound) > 0,
    at: (t) => add(centre, add(times(free, root * Math.sinh(t)), times(bound, sign * root * Math.cosh(t)))),
    parameter: (x) => Math.asinh(dot(subtract(x, centre), free) / root) }));
}

// Where the patch's curve crosses the cell's sides: G is a quadratic polynomial along each.
function crossings(cell) {
  const found = [];
  cell.polygon.forEach((p, k) => {
    const d = subtract(cell.polygon[(k + 1) % cell.polygon.length], p), { G, N } = evaluate(cell, p);
    const b = dot(N, d), a = evaluate(cell, add(cell.centre, d)).G + cell.weight / 2;
    const root = Math.sqrt(b * b - a * G);
    // The stable form; for a = 0 only one root is finite.
    const s = -(b + (b < 0 ? -root : root));
    for (const t of [s / a, G / s]) if (t >= 0 && t < 1) found.push(add(p, times(d, t)));
  });
  return found;
}

// The polygon's part within |x|, |y| <= half, for drawing: some sides lie far away.
export function clipped(polygon, half) {
  let kept = polygon;
  for (const [axis, sign] of [[0, 1], [0, -1], [1, 1], [1, -1]]) {
    const room = (p) => half - sign * p[axis];
    kept = kept.flatMap((p, k) => {
      const next = kept[(k + 1) % kept.length], a = room(p), b = room(next);
      const cut = add(p, times(subtract(next, p), a / (a - b)));
      return [...(a >= 0 ? [p] : []), ...(a >= 0 !== b >= 0 ? [cut] : [])];
    });
  }
  return kept;
}

const longest = 0.04; // of a straight piece that stands for the curve, over rho

// The parts of the curve in one cell, each a list of its points.
function arcsIn(cell) {
  const all = crossings(cell), arcs = [];
  for (const branch of branches(cell)) {
    const ends = all.filter(branch.has).map(branch.parameter).sort((a, b) => a - b);
    if (branch.isCircle) ends.push(...(ends.length ? [ends[0] + 2 * Math.PI] : [0, 2 * Math.PI]));
    for (let k = 0; k + 1 < ends.length; ++k) {
      const [from, to] = [ends[k], ends[k + 1]];
      if (to - from < 1e-12 || !isIn(cell, branch.at((from + to) / 2))) continue;
      const pieces = Math.ceil((to - from) / longest);
      arcs.push(Array.from({ length: pieces + 1 }, (_, n) => {
        const x = branch.at(from + ((to - from) * n) / pieces);
        return { x, cell, step: (to - from) / pieces, ...evaluate(cell, x) };
      }));
    }
  }
  return arcs;
}

// The skin: closed curves, each a list of points {x, cell, step, G, N, rho, c, q} whose last is the
// first; `step` is the length over rho from the point before.
export function skin(cells) {
  const rest = cells.flatMap(arcsIn), loops = [];
  while (rest.length > 0) {
    let loop = rest.pop();
    for (;;) {
      const end = loop.at(-1).x, home = norm(subtract(end, loop[0].x));
      let best = { d: home, k: -1 };
      rest.forEach((arc, k) => [arc[0], arc.at(-1)].forEach(({ x }, isLast) => {
        const d = norm(subtract(end, x));
        if (d < best.d) best = { d, k, isLast };
      }));
      if (best.k < 0) break;
      const [arc] = rest.splice(best.k, 1);
      loop = loop.concat((best.isLast ? arc.reverse() : arc).slice(1));
    }
    loops.push(loop);
  }
  return loops;
}

// Vertices on one closed curve, so that all edges are nearly `share` length scales long.
export function meshOf(loop, share) {
  const along = [0];
  for (let k = 1; k < loop.length; ++k) along.push(along[k - 1] + loop[k].step);
  const count = Math.max(3, Math.ceil(along.at(-1) / share)), vertices = [];
  for (let n = 0, k = 1; n < count; ++n) {
    const at = (n * along.at(-1)) / count;
    while (along[k] < at) ++k;
    const t = (at - along[k - 1]) / (along[k] - along[k - 1]);
    const { cell } = loop[k];
    let x = add(times(loop[k - 1].x, 1 - t), times(loop[k].x, t));
    for (let step = 0; step < 3; ++step) {
      const { G, N, rho } = evaluate(cell, x);
      x = subtract(x, times(N, G / (2 * rho * rho)));
    }
    vertices.push({ x, ...evaluate(cell, x) });
  }
  return vertices;
}

// The smallest half edge over the larger length scale, the largest over the smaller one.
export function sizes(vertices) {
  let least = Infinity, most = 0;
  vertices.forEach((a, k) => {
    const b = vertices[(k + 1) % vertices.length], half = norm(subtract(a.x, b.x)) / 2;
    least = Math.min(least, half / Math.max(a.rho, b.rho));
    most = Math.max(most, half / Math.min(a.rho, b.rho));
  });
  return { least, most };
}

// The weight of the edge between two discs at a distance; its zero is where the skin splits.
export const edgeWeight = (a, b, distance) =>
  edgeCell({ z: [0, 0], w: a }, { z: [distance, 0], w: b }).weight;
export const splitDistance = (a, b) => Math.sqrt(a) + Math.sqrt(b);
