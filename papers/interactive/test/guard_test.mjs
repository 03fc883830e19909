// The two sweeps of the guard's page, and the first overlap: against `check` and against points.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as guard from '../guard_math.js';
import { partData, verdicts } from './program.mjs';

const [guarded, unguarded] = partData('guard').sweeps;
const first = guard.firstOverlap(unguarded);
const start = ({ positions, triangles }, count) => {
  const kept = triangles.slice(0, count);
  return { positions: positions.slice(0, Math.max(...kept.flat()) + 1), triangles: kept };
};

function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const subtract = (a, b) => a.map((x, k) => x - b[k]);

// Whether a point lies inside a triangle, seen along a direction.
function covers({ p }, x, along) {
  const sides = [0, 1, 2].map((k) => dot(along, cross(subtract(p[(k + 1) % 3], p[k]), subtract(x, p[k]))));
  return sides.every((side) => side > 0) || sides.every((side) => side < 0);
}

// Points of a triangle on a grid of `n` to a side.
const grid = ({ p }, n = 60) => Array.from({ length: n * n }, (_, i) => [(i % n) + 0.5, Math.floor(i / n) + 0.5].map((x) => x / n))
  .filter(([s, t]) => s + t < 1).map(([s, t]) => p[0].map((x, k) => x + s * (p[1][k] - x) + t * (p[2][k] - x)));

test('with the guard the sweep ends closed, without it open, and both begin alike', () => {
  assert.deepEqual(guard.frontEdges(guarded, guarded.triangles.length), []);
  assert.ok(guard.frontEdges(unguarded, unguarded.triangles.length).length > 0);
  assert.ok(Object.values(verdicts(guarded)).every((holds) => holds));
  assert.ok(!verdicts(unguarded).closed);
  const common = guard.commonStart(guarded, unguarded);
  assert.ok(common > 0 && common <= first.triangle);
  assert.deepEqual(start(guarded, common), start(unguarded, common));
});

test('no triangle of the guarded sweep overlaps another, nor any before the first overlap, and check finds no contact there', () => {
  assert.equal(guard.firstOverlap(guarded), null);
  const before = start(unguarded, first.triangle);
  assert.equal(guard.firstOverlap(before), null);
  assert.ok(verdicts(before)['without self-intersections']);
});

test('the first overlap has points in both triangles, seen along their normals, and in no others', () => {
  const top = guard.triangleOf(unguarded, first.triangle);
  for (let s = 0; s < first.triangle; ++s) {
    const below = guard.triangleOf(unguarded, s);
    if (Math.hypot(...subtract(top.middle, below.middle)) > 2 * (top.radius + below.radius)) continue;
    const along = top.normal.map((x, k) => x + below.normal[k]);
    assert.equal(grid(top).some((x) => covers(below, x, along)), first.over.includes(s), `triangle ${s}`);
  }
});

test('overlap is that of points in a plane, in either order, and moves with both triangles', () => {
  const next = random(5);
  let overlaps = 0;
  for (let n = 0; n < 400; ++n) {
    const corners = Array.from({ length: 2 }, () => Array.from({ length: 3 }, () => [next() * 2, next() * 2, 0])).map((p) =>
      (cross(subtract(p[1], p[0]), subtract(p[2], p[0]))[2] > 0 ? p : [p[0], p[2], p[1]]));
    const pair = (move) => corners.map((p) => guard.triangleOf({ positions: p.map(move), triangles: [[0, 1, 2]] }, 0));
    const [a, b] = pair((x) => x), is = guard.overlap(a, b);
    const share = grid(a, 200).some((x) => covers(b, x, [0, 0, 1])) || grid(b, 200).some((x) => covers(a, x, [0, 0, 1]));
    if (share) assert.ok(is, `${n}`);
    if (is && !share) assert.ok(!guard.overlap(...pair((x) => x).map((one) => smaller(one, 0.97))), `${n}: a sliver that the grid misses`);
    assert.equal(guard.overlap(b, a), is);
    const [c, s] = [Math.cos(n), Math.sin(n)];
    assert.equal(guard.overlap(...pair(([x, y]) => [c * x - s * y + 3, 0.6 * (s * x + c * y), 0.8 * (s * x + c * y) - 7])), is);
    overlaps += is;
  }
  assert.ok(overlaps > 50 && overlaps < 350, `${overlaps}`);
});

// A triangle drawn in towards its middle.
function smaller({ p, middle }, share) {
  const positions = p.map((x) => x.map((c, k) => middle[k] + share * (c - middle[k])));
  return guard.triangleOf({ positions, triangles: [[0, 1, 2]] }, 0);
}

test('triangles that share an edge or a corner, or face opposite ways, do not overlap', () => {
  const positions = [[0, 0, 0], [1, 0, 0], [0.5, 1, 0.1], [0.5, -1, -0.2], [-1, 0.2, 0], [0.4, 0.3, 0.01], [1.4, 0.3, 0.01], [0.9, 1.2, 0.01]];
  const triangles = [[0, 1, 2], [0, 3, 1], [0, 2, 4], [5, 6, 7], [5, 7, 6]];
  const all = triangles.map((_, t) => guard.triangleOf({ positions, triangles }, t));
  assert.ok(!guard.overlap(all[0], all[1]) && !guard.overlap(all[0], all[2]) && !guard.overlap(all[1], all[2]));
  assert.ok(guard.overlap(all[0], all[3]) && !guard.overlap(all[0], all[4]));
});

test('the front is closed polygons: as many of its edges end in a vertex as begin there', () => {
  for (const mesh of [guarded, unguarded]) {
    for (let count = 1; count <= mesh.triangles.length; count += 97) {
      const balance = new Map();
      for (const [a, b] of guard.frontEdges(mesh, count)) {
        balance.set(a, (balance.get(a) ?? 0) + 1);
        balance.set(b, (balance.get(b) ?? 0) - 1);
      }
      assert.ok([...balance.values()].every((n) => n === 0), `${count} triangles`);
    }
  }
});
