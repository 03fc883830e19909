// The plane skin against the program's: discs are balls with their centres in one plane.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as skin2d from '../skin2d_math.js';
import { info } from './program.mjs';

function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function discs(seed) {
  const next = random(seed), count = 2 + Math.floor(4 * next());
  return Array.from({ length: count }, () => ({ z: [4 * next() - 2, 3 * next() - 1.5], w: 0.2 + 2 * next() }));
}

const inSpace = (list) => list.map(({ z, w }) => ({ z: [...z, 0], w }));

test('two discs part where the program counts two components, to the last digits of a distance', () => {
  for (const [a, b] of [[2, 2], [1, 3], [0.5, 0.7]]) {
    const d = skin2d.splitDistance(a, b);
    for (const [share, curves] of [[1 - 1e-6, 1], [1 + 1e-6, 2]]) {
      const pair = [{ z: [0, 0], w: a }, { z: [d * share, 0], w: b }];
      const { necks } = info(inSpace(pair));
      assert.equal(necks.count, curves === 1 ? 1 : 0);
      assert.equal(skin2d.skin(skin2d.mixedCells(pair)).length, curves);
    }
  }
});

test('edges of positive weight that meet their power cells are the program’s necks, of the same radius', () => {
  for (let seed = 1; seed <= 30; ++seed) {
    const list = discs(seed), cells = skin2d.mixedCells(list);
    const ours = cells.filter((cell) => cell.kind === 1 && cell.weight > 0 && skin2d.isIn(cell, cell.centre))
      .map(({ weight }) => Math.sqrt(weight / 2)).sort((a, b) => a - b);
    const { necks } = info(inSpace(list));
    assert.equal(ours.length, necks.count, `seed ${seed}`);
    if (ours.length) assert.ok(Math.abs(ours[0] - necks.narrowest[0].radius) < 1e-5, `seed ${seed}`);
  }
});

test('every point lies in one cell up to walls, and G and N agree on both sides of a wall', () => {
  for (let seed = 1; seed <= 200; ++seed) {
    const cells = skin2d.mixedCells(discs(seed)), next = random(seed + 1000);
    for (let n = 0; n < 20; ++n) {
      const x = [5 * next() - 2.5, 4 * next() - 2];
      assert.equal(cells.filter((cell) => skin2d.isIn(cell, x)).length, 1, `seed ${seed}`);
    }
    for (const { polygon } of cells) {
      const wall = [0, 1].map((k) => (polygon[0][k] + polygon[1][k]) / 2);
      if (Math.hypot(...wall) > 100) continue;
      const near = cells.filter((cell) => [1e-7, -1e-7].some((e) =>
        skin2d.isIn(cell, [wall[0] + e, wall[1]]) || skin2d.isIn(cell, [wall[0], wall[1] + e])));
      const values = near.map((cell) => skin2d.evaluate(cell, wall));
      for (const { G, N } of values) {
        assert.ok(Math.abs(G - values[0].G) < 1e-9);
        assert.ok(Math.hypot(N[0] - values[0].N[0], N[1] - values[0].N[1]) < 2e-6);
      }
    }
  }
});

test('the skin is closed curves on which G is 0, and its mesh keeps the sizes asked for', () => {
  for (let seed = 1; seed <= 200; ++seed) {
    const loops = skin2d.skin(skin2d.mixedCells(discs(seed)));
    assert.ok(loops.length > 0);
    for (const loop of loops) {
      const [first, last] = [loop[0].x, loop.at(-1).x];
      assert.ok(Math.hypot(first[0] - last[0], first[1] - last[1]) < 1e-6, `seed ${seed} is open`);
      for (const { G } of loop) assert.ok(Math.abs(G) < 1e-8);
      const mesh = skin2d.meshOf(loop, 0.2);
      for (const { G } of mesh) assert.ok(Math.abs(G) < 1e-8);
      // The length scale grows along an edge by a factor of exp(0.2) at most.
      const most = (Math.exp(0.2) - 1) / 2;
      assert.ok(skin2d.sizes(mesh).most < most, `seed ${seed}: ${skin2d.sizes(mesh).most}`);
    }
  }
});
