// The conditions of papers/certificate.md on a small mesh, computed as certify/ does but in plain
// doubles: no rounding is counted, and every vertex is tried for (c3).
//
// Balls are {z, w}, a mesh is {positions, triangles}. Edits make a new mesh of an old one.

const add = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
const subtract = (a, b) => add(a, b, -1);
const times = (a, s) => a.map((x) => x * s);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const norm = (a) => Math.sqrt(dot(a, a));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(a, 1 / norm(a));

function solve(rows) {
  const n = rows.length;
  for (let i = 0; i < n; ++i) {
    let p = i;
    for (let r = i + 1; r < n; ++r) if (Math.abs(rows[r][i]) > Math.abs(rows[p][i])) p = r;
    [rows[i], rows[p]] = [rows[p], rows[i]];
    if (Math.abs(rows[i][i]) < 1e-12) return null;
    for (let r = 0; r < n; ++r) {
      if (r === i) continue;
      const f = rows[r][i] / rows[i][i];
      for (let c = i; c <= n; ++c) rows[r][c] -= f * rows[i][c];
    }
  }
  return rows.map((row, i) => row[n] / row[i]);
}

function subsets(count, most) {
  let all = [[]];
  for (let i = 0; i < count; ++i) all = all.concat(all.filter((s) => s.length < most).map((s) => [...s, i]));
  return all.slice(1);
}

// G and N at x: the least of (|m|^2 + sum s_i pi_i(x)) / 2 over convex combinations s of the balls,
// m = sum s_i (z_i - x). The least lies on the face of at most four balls where it is stationary.
export function evaluate(balls, x) {
  const u = balls.map(({ z }) => subtract(z, x)), power = balls.map(({ w }, i) => dot(u[i], u[i]) - w);
  let best = { G: Infinity };
  for (const set of subsets(balls.length, 4)) {
    // Stationary along differences of shares: m . (u_i - u_0) + (pi_i - pi_0) / 2 = 0, sum s = 1.
    const rows = set.map((i, k) => (k === 0 ? [...set.map(() => 1), 1]
      : [...set.map((j) => dot(u[j], subtract(u[i], u[set[0]]))), (power[set[0]] - power[i]) / 2]));
    const s = solve(rows);
    if (!s || s.some((share) => share < -1e-12)) continue;
    const m = set.reduce((sum, i, k) => add(sum, u[i], s[k]), [0, 0, 0]);
    const G = (dot(m, m) + set.reduce((sum, i, k) => sum + s[k] * power[i], 0)) / 2;
    if (G < best.G) best = { G, N: times(m, -1), balls: set };
  }
  return { ...best, rho: norm(best.N) };
}

export function project(balls, x) {
  for (let step = 0; step < 30; ++step) {
    const { G, N, rho } = evaluate(balls, x);
    x = add(x, N, -G / (2 * rho * rho));
  }
  return x;
}

// Triangles at each vertex as a half-edge map; the first defect in words, or none.
export function manifoldDefect({ positions, triangles }) {
  const next = positions.map(() => new Map());
  for (const t of triangles) {
    for (let k = 0; k < 3; ++k) {
      const [v, a, b] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
      if (next[v].has(a)) return `edge ${v}–${a}: two triangles run along it the same way`;
      next[v].set(a, b);
    }
  }
  for (let v = 0; v < positions.length; ++v) {
    if (next[v].size === 0) return `vertex ${v} is in no triangle`;
    for (const b of next[v].values()) if (!next[v].has(b)) return `edge ${v}–${b} is open`;
    let [b] = next[v].keys(), count = 0;
    const first = b;
    do { b = next[v].get(b); ++count; } while (b !== first);
    if (count < next[v].size) return `vertex ${v}: its triangles form more than one fan`;
  }
  return null;
}

export function components({ positions, triangles }) {
  const parent = positions.map((_, v) => v);
  const find = (v) => { while (parent[v] !== v) v = parent[v] = parent[parent[v]]; return v; };
  for (const [a, b, c] of triangles) { parent[find(a)] = find(b); parent[find(b)] = find(c); }
  return positions.map((_, v) => find(v));
}

export function maxPath(n, g) {
  return n > 0 && n * n > g ? g / (n + Math.sqrt(n * n - g)) : Infinity;
}

function shapeOf(p) {
  const area = cross(subtract(p[1], p[0]), subtract(p[2], p[0])), doubled = norm(area);
  const sides = [0, 1, 2].map((k) => norm(subtract(p[(k + 1) % 3], p[(k + 2) % 3])));
  return { sides, R: (sides[0] * sides[1] * sides[2]) / (2 * doubled), normal: times(area, 1 / doubled) };
}

// (c1) and (c2) on a triangle: by the corner opposite its longest side or, where that does not do,
// by all three and how far N is from an isometry between them, piece by piece.
function proveTube(balls, corners) {
  const shape = shapeOf(corners.map(({ x }) => x)), { sides, R, normal } = shape;
  const k = sides.indexOf(Math.max(...sides));
  const upright = dot(corners[k].N, normal), longer = Math.max(sides[(k + 1) % 3], sides[(k + 2) % 3]);
  const rho = Math.min(...corners.map((c) => c.rho)), g = R * R + Math.max(...corners.map((c) => Math.abs(c.G)));
  const path = maxPath(rho - R, g);
  const proof = { ...shape, isUpright: upright > longer, isInTube: Number.isFinite(path), path };
  if ((proof.isUpright && proof.isInTube) || !(R < rho)) return proof;
  Object.assign(proof, { isUpright: true, isInTube: true, path: 0 });
  const squared = (a, b) => dot(subtract(a, b), subtract(a, b));
  const hold = (p, r, depth) => {
    for (const c of p) {
      if (!(dot(c.N, normal) > 0)) { proof.isUpright = false; return false; }
      if (!(Math.abs(c.G) < c.rho * c.rho)) { proof.isInTube = false; return false; }
    }
    const up = Math.min(...p.map((c) => dot(c.N, normal) - 1e-6 * c.rho));
    const fold = Math.max(...p.map((c, i) => squared(p[(i + 1) % 3].x, c.x) - squared(p[(i + 1) % 3].N, c.N)));
    const bend = Math.min(r, Math.sqrt(Math.max(0, fold) / 3)), least = Math.min(...p.map((c) => c.rho));
    const affine = Math.sqrt(Math.max(0, least * least - r * r));
    const isUpright = up > bend;
    const way = maxPath((1 - 1e-6) * affine - bend, Math.max(...p.map((c) => Math.abs(c.G))) + r * r);
    if (isUpright && Number.isFinite(way)) { proof.path = Math.max(proof.path, way); return true; }
    if (depth === 5) { proof[isUpright ? 'isInTube' : 'isUpright'] = false; return false; }
    const m = [0, 1, 2].map((i) => times(add(p[(i + 1) % 3].x, p[(i + 2) % 3].x), 0.5))
      .map((x) => ({ x, ...evaluate(balls, x) }));
    return [m, [p[0], m[2], m[1]], [p[1], m[0], m[2]], [p[2], m[1], m[0]]].every((q) => hold(q, r / 2, depth + 1));
  };
  if (!hold(corners, R, 0)) proof.path = Infinity;
  return proof;
}

// The distance from the origin to a triangle, and to its shadow in a plane (flat triangles too).
function distanceTo(p) {
  const n = cross(subtract(p[1], p[0]), subtract(p[2], p[0])), size = dot(n, n);
  const foot = size > 0 ? times(n, dot(n, p[0]) / size) : null;
  if (foot && [0, 1, 2].every((k) =>
    dot(cross(subtract(p[(k + 1) % 3], p[k]), subtract(foot, p[k])), n) >= 0)) return norm(foot);
  return Math.min(...[0, 1, 2].map((k) => {
    const d = subtract(p[(k + 1) % 3], p[k]), t = Math.max(0, Math.min(1, -dot(p[k], d) / (dot(d, d) || 1)));
    return norm(add(p[k], d, t));
  }));
}

// (c3) at a vertex: in words what is against it, or nothing.
function objection(mesh, points, proofs, around, v) {
  const at = points[v], own = maxPath(at.rho, Math.abs(at.G));
  const path = (t) => maxPath(at.rho, proofs[t].R ** 2 + Math.abs(at.G)
    + Math.max(...mesh.triangles[t].map((a) => Math.abs(points[a].G))));
  if (!(own < at.rho / 16)) return 'off the skin';
  for (const t of around[v]) if (!(path(t) < dot(at.N, proofs[t].normal))) return 'its triangles are too large';
  const normal = unit(at.N), across = unit(cross(normal, Math.abs(normal[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]));
  const other = cross(normal, across);
  let turn = 0;
  for (const t of around[v]) {
    const k = mesh.triangles[t].indexOf(v);
    const [a, b] = [1, 2].map((n) => {
      const e = subtract(mesh.positions[mesh.triangles[t][(k + n) % 3]], at.x);
      return Math.atan2(dot(e, other), dot(e, across));
    });
    turn += (b - a + 4 * Math.PI) % (2 * Math.PI);
  }
  if (Math.round(turn / (2 * Math.PI)) !== 1) return 'its triangles go round it more than once';
  for (let t = 0; t < proofs.length; ++t) {
    if (mesh.triangles[t].includes(v)) continue;
    const s = Math.min(path(t), proofs[t].path + own);
    const seen = mesh.triangles[t].map((a) => subtract(mesh.positions[a], at.x));
    if (distanceTo(seen) > s) continue;
    const aside = seen.map((p) => add(p, normal, -dot(p, normal)));
    if (distanceTo(aside) > (s * s) / (2 * at.rho)) continue;
    return `triangle ${t} comes near the path through vertex ${v}`;
  }
  return null;
}

// Each condition with what is against it (null where it holds, undefined where it was not asked).
// expected: components and Euler characteristic of the skin.
export function certify(balls, mesh, expected) {
  const points = mesh.positions.map((x) => ({ x, ...evaluate(balls, x) }));
  const proofs = mesh.triangles.map((t) => proveTube(balls, t.map((v) => points[v])));
  const first = (list, breaks, words) => {
    const k = list.findIndex(breaks);
    return k < 0 ? null : words(k);
  };
  const result = {
    manifold: manifoldDefect(mesh),
    onSkin: first(points, ({ G, rho }) => !(Math.abs(G) < 2e-7 * rho * rho), (v) =>
      `vertex ${v} lies ${Math.abs(points[v].G / (2 * points[v].rho)).toPrecision(2)} off the skin`),
    upright: first(proofs, (p) => !p.isUpright, (t) => {
      const isDenied = mesh.triangles[t].some((v) => dot(points[v].N, proofs[t].normal) < 0);
      return `triangle ${t} ${isDenied ? 'does not face' : 'is not shown to face'} the way the skin does`;
    }),
    tube: first(proofs, (p) => !p.isInTube, (t) => {
      const isOff = mesh.triangles[t].some((v) => !(Math.abs(points[v].G) < points[v].rho ** 2));
      return `triangle ${t} ${isOff ? 'has a corner that is too far off' : 'is too large'} to be proved near the skin`;
    }),
  };
  const bad = new Set(proofs.flatMap((p, t) => (p.isUpright && p.isInTube ? [] : [t])));
  if (result.manifold === null) {
    const of = components(mesh), roots = [...new Set(of)];
    const chi = mesh.positions.length - mesh.triangles.length / 2;
    result.counts = roots.length !== expected.components
      ? `${roots.length} components, the skin has ${expected.components}`
      : chi !== expected.euler ? `χ is ${chi}, the skin’s is ${expected.euler}` : null;
    result.degree = 'is proved only where (c1) and (c2) hold everywhere';
    if (result.upright === null && result.tube === null) {
      const around = mesh.positions.map(() => []);
      mesh.triangles.forEach((t, k) => t.forEach((v) => around[v].push(k)));
      result.degree = null;
      for (const root of roots) {
        let words = null;
        const isProved = of.some((r, v) => r === root
          && (words = objection(mesh, points, proofs, around, v)) === null);
        if (!isProved) result.degree = words;
      }
    }
  }
  const holds = (...names) => names.every((name) => result[name] === null);
  const isHomeomorphic = holds('manifold', 'upright', 'tube', 'degree', 'counts');
  return { ...result, bad, isHomeomorphic, isSound: isHomeomorphic && result.onSkin === null };
}

const copied = ({ positions, triangles }) =>
  ({ positions: positions.map((x) => [...x]), triangles: triangles.map((t) => [...t]) });

// Without vertices that no triangle uses.
function tidied({ positions, triangles }) {
  const used = new Set(triangles.flat()), ids = new Map();
  const kept = positions.filter((_, v) => used.has(v) && ids.set(v, ids.size));
  return { positions: kept, triangles: triangles.map((t) => t.map((v) => ids.get(v))) };
}

export const edits = {
  turn(mesh, t) {
    const made = copied(mesh);
    made.triangles[t].reverse();
    return made;
  },
  drop(mesh, t) {
    const made = copied(mesh);
    made.triangles.splice(t, 1);
    return tidied(made);
  },
  dropComponent(mesh, t) {
    const made = copied(mesh), of = components(mesh), root = of[mesh.triangles[t][0]];
    made.triangles = made.triangles.filter(([v]) => of[v] !== root);
    return tidied(made);
  },
  // Flips the first edge of a triangle, if the new edge is not there yet.
  flip(mesh, t) {
    const made = copied(mesh), [a, b, c] = mesh.triangles[t];
    const s = mesh.triangles.findIndex((o, k) => k !== t && o.includes(a) && o.includes(b));
    if (s < 0) return made;
    const d = mesh.triangles[s].find((v) => v !== a && v !== b);
    if (mesh.triangles.some((o) => o.includes(c) && o.includes(d))) return made;
    made.triangles[t] = [a, d, c];
    made.triangles[s] = [d, b, c];
    return made;
  },
  // Moves a vertex along its normal, by a share of its length scale.
  move(mesh, v, share, balls) {
    const made = copied(mesh);
    made.positions[v] = add(mesh.positions[v], evaluate(balls, mesh.positions[v]).N, share);
    return made;
  },
  // Moves a vertex over the skin towards the next corner of its triangle.
  slide(mesh, v, share, balls) {
    const made = copied(mesh), t = mesh.triangles.find((o) => o.includes(v));
    const to = mesh.positions[t[(t.indexOf(v) + 1) % 3]];
    made.positions[v] = project(balls, add(times(mesh.positions[v], 1 - share), to, share));
    return made;
  },
  // The whole mesh once more on top of itself.
  double(mesh) {
    const made = copied(mesh), n = mesh.positions.length;
    made.positions.push(...mesh.positions.map((x) => [...x]));
    made.triangles.push(...mesh.triangles.map((t) => t.map((v) => v + n)));
    return made;
  },
  invert(mesh) {
    const made = copied(mesh);
    for (const t of made.triangles) t.reverse();
    return made;
  },
};
