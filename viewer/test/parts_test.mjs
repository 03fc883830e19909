// What a page tells of parts: components by themselves, the colour of each fragment, the level of the
// Morse function.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { settle } from './browser.mjs';
import {
  change, check, folder, make, molecules, morskin, pages, picture, small, stage, withPage,
} from './pages.mjs';
import { difference } from './pictures.mjs';

const shell = join(molecules, 'shell_hollow.xyzr');
// A page of two balls of radius 1.7 and 1.5 times a unit.
const pair = (name, unit) => {
  const balls = join(folder, `${name}.xyzr`), page = join(folder, `${name}.html`);
  writeFileSync(balls, `0 0 0 ${1.7 * unit}\n${1.5 * unit} ${unit} 0 ${1.5 * unit}\n`);
  execFileSync(morskin, ['view', balls, '-o', page, '-q']);
  return page;
};
before(() => {
  pages.tiny = pair('tiny', 1e-5);
  pages.shell = make('shell', shell);
  pages.distance = make('distance', join(molecules, 'caffeine.xyz'), '--function', 'distance:3,1,2');
});

test('each component is shown or hidden by itself, with the volume of the report',
  { timeout: 900000 }, async () => {
    const report = JSON.parse(execFileSync(morskin, ['mesh', shell, '--model', 'paper', '-o', '/dev/null',
      '--fronts', '1', '--json']));
    assert.equal(report.voids.length, 1);
    await withPage(pages.shell, small, async (page) => {
      const rows = await page.locator('.rows .toggle').allTextContents();
      assert.equal(rows.length, 2);
      assert.match(rows[0], /^outside/);
      const [, volume] = rows[1].match(/^void 1(.*) Å³$/);
      const [told] = report.voids[0].volume; // bounds
      assert.ok(Math.abs(Number(volume.replaceAll(',', '')) / told - 1) < 1e-3, `${volume}, not ${told}`);
      // The void is inside: hiding it changes nothing until the outside is gone.
      assert.ok(await change(page, () => check(page, 'component-1')) < 0.001);
      assert.ok(await change(page, () => check(page, 'component-0')) > 0.05);
      const hit = () => page.evaluate(() => {
        const { x, y, width, height } = document.querySelector('#stage').getBoundingClientRect();
        window.viewer.inspect(x + width / 2, y + height / 2);
        return !document.querySelector('#panel section').hidden;
      });
      assert.equal(await hit(), false);
      assert.ok(await change(page, () => check(page, 'component-1')) > 0.02);
      assert.equal(await hit(), true);
      await picture(page, 'void');
      const hash = await page.evaluate(() => { window.viewer.address.write(); return location.hash; });
      assert.equal(hash, '#hidden=0');
      await withPage(pages.shell + hash, small, async (again) => {
        assert.equal(await again.evaluate(() => window.viewer.state.hidden), '0');
        assert.equal(await again.locator('#component-0').isChecked(), false);
      });
      for (const nonsense of ['2', '1,0', '0,0', '-1', 'x', '0,']) {
        await withPage(`${pages.shell}#hidden=${nonsense}`, small, async (other) =>
          assert.equal(await other.evaluate(() => window.viewer.state.hidden), '', nonsense));
      }
    });
    await withPage(`${pages.ligand}#hidden=0`, small, async (page) => {
      assert.equal(await page.locator('.rows').count(), 0, 'one component has no list');
      const hidden = await page.evaluate(() => window.viewer.state.hidden);
      assert.equal(hidden, '', 'so it is not hidden');
    });
  });

test('the head names what was chosen of the atoms, and does not say that there is no more',
  { timeout: 900000 }, async () => {
    const chosen = make('chosen', join(molecules, '5tmn_ligand.pdb'), '-C', '0.2', '--waters', '--altloc', 'all');
    await withPage(chosen, small, async (page) => {
      const head = await page.locator('.counts').textContent();
      assert.match(head, /32 atoms, model paper · chosen: waters, altloc all · smallest/);
    });
  });

test('the words fit one of a thing as they fit many, and a number below 0', { timeout: 900000 }, async () => {
  const ball = join(folder, 'ball.xyzr');
  writeFileSync(ball, '0 0 0 1.5\n');
  await withPage(make('ball', ball), small, async (page) => {
    assert.match(await page.locator('.counts').textContent(), / · 1 atom, model/);
    await page.locator('#colour').selectOption('region');
    assert.match(await page.locator('.legend').first().textContent(), /^1 pair of a minimum/);
    await page.locator('#colour').selectOption('value');
    assert.match(await page.locator('.ticks').textContent(), /^−1\.\d+−?0\.\d+1\.\d+$/, 'as it writes minus');
    const { width, height } = await page.locator('#stage').boundingBox();
    await page.mouse.click(width / 2, height / 2);
    assert.match(await page.locator('.told').textContent(), /Cellvertex: sphere; ball 1Nearest ball1$/);
  });
  await withPage(pages.ligand, small, async (page) => {
    assert.match(await page.locator('.counts').textContent(), / · 32 atoms, model/);
    const said = await page.evaluate(() => {
      const { viewer } = window, words = [];
      for (const n of [0, 1, 2]) {
        viewer.scene.page.about.critical.left[1] = n;
        viewer.set({ simplified: false });
        viewer.set({ simplified: true });
        words.push(document.querySelector('label[for=spheres] + .note').textContent);
      }
      return words;
    });
    said.forEach((words, n) => assert.match(words, [/ 0 saddles /, / 1 saddle /, / 2 saddles /][n]));
  });
});

// In the page: looks straight at triangles whose corners lie in two cells, and says of points on them
// the colour seen there and the kind of the cell that holds them, by all of its walls.
function seenAndTrue(parts) {
  const { scene, stage } = window.viewer, { complex, mesh, cells } = scene;
  const walls = complex.walls(), gl = stage.renderer.getContext(), found = [];
  const corner = (t, k) => stage.controls.target.clone()
    .fromArray(mesh.positions, 3 * mesh.corners[3 * t + k]);
  const outside = (cell, p) => {
    let most = -Infinity;
    for (let i = 0; i < walls[cell].length; i += 4) {
      const [x, y, z, w] = walls[cell].slice(i, i + 4);
      most = Math.max(most, x * p.x + y * p.y + z * p.z - w);
    }
    return most;
  };
  for (let t = 0; t < mesh.triangleCount && found.length < parts; t += 7) {
    const own = [0, 1, 2].map((k) => cells[mesh.corners[3 * t + k]]);
    const kinds = new Set(own.map((cell) => complex.dimension(cell)));
    if (new Set(own).size !== 2 || kinds.size !== 2) continue;
    const [a, b, c] = [0, 1, 2].map((k) => corner(t, k));
    const size = a.distanceTo(b);
    const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
    stage.controls.target.copy(a).add(b).add(c).divideScalar(3);
    stage.camera.position.copy(stage.controls.target).addScaledVector(normal, 6 * size);
    stage.camera.near = size / 10;
    stage.camera.updateProjectionMatrix();
    stage.camera.up.copy(b).sub(a).normalize();
    stage.camera.lookAt(stage.controls.target);
    stage.camera.updateMatrixWorld();
    stage.renderer.render(stage.world, stage.camera);
    for (let i = 1; i < 12; ++i) {
      for (let j = 1; i + j < 12; ++j) {
        const p = a.clone().multiplyScalar(1 - (i + j) / 12).addScaledVector(b, i / 12)
          .addScaledVector(c, j / 12);
        const inside = own.filter((cell) => outside(cell, p) < -0.03 * size);
        if (inside.length !== 1) continue;
        const at = p.clone().project(stage.camera), pixel = new Uint8Array(4);
        gl.readPixels(Math.floor((at.x + 1) / 2 * gl.drawingBufferWidth),
          Math.floor((at.y + 1) / 2 * gl.drawingBufferHeight), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        found.push([complex.dimension(inside[0]), [...pixel.subarray(0, 3)]]);
      }
    }
  }
  return found;
}

test('where a wall between two cells crosses a triangle, each fragment has the colour of its own cell',
  { timeout: 900000 }, async () => {
    const kinds = [[236, 190, 92], [78, 158, 196], [120, 180, 110], [205, 104, 92]];
    const unit = (v) => v.map((x) => x / Math.hypot(...v));
    const nearest = (colour) => kinds.map((kind) => unit(kind).reduce((sum, x, k) =>
      sum + (x - unit(colour)[k]) ** 2, 0)).reduce((best, d, i, all) => (d < all[best] ? i : best), 0);
    await withPage(pages.ligand, { width: 900, height: 600 }, async (page) => {
      const found = await page.evaluate(seenAndTrue, 3000);
      assert.ok(found.length > 2000, `${found.length}`);
      const wrong = found.filter(([kind, colour]) => nearest(colour) !== kind);
      assert.ok(wrong.length < 0.005 * found.length, `${wrong.length} of ${found.length}`);
    });
  });

test('a length scale that is one number has one colour, whatever rounding makes of it',
  { timeout: 900000 }, async () => {
    const ball = join(folder, 'far.xyzr');
    writeFileSync(ball, '12.3 -45.6 78.9 1.5\n');
    const values = (page) => page.evaluate(() => {
      const all = window.viewer.colourings.find(({ id }) => id === 'scale').values();
      return [Math.min(...all), Math.max(...all)];
    });
    await withPage(make('far', ball), small, async (page) => {
      assert.deepEqual(await values(page), [0.5, 0.5]);
      await page.locator('#colour').selectOption('scale');
      assert.match(await page.locator('.ticks').textContent(), /^(\d\.\d+?)\1\1$/);
    });
    await withPage(pages.distance, small, async (page) =>
      assert.deepEqual(await values(page), [0, 1]));
  });

test('the level moves with the sweep, as a plane of a height', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    await page.locator('#colour').selectOption('plain');
    assert.ok(await change(page, () => check(page, 'level')) > 0.002, 'over all that is swept');
    const levels = [];
    for (const share of [0.2, 0.5, 0.8]) {
      const moved = await change(page, () => page.evaluate((x) =>
        window.viewer.goTo(x * window.viewer.sweep.steps), share));
      assert.ok(moved > 0.02, `at ${share}`);
      levels.push(await page.evaluate(() => window.viewer.level()));
      assert.match(await page.getByText(/^level /).textContent(), /^level −?[\d.]+ Å$/);
    }
    assert.ok(levels[0] < levels[1] && levels[1] < levels[2], `${levels}`);
    // The plane is where it says: at that height, and across the direction.
    const off = await page.evaluate(() => {
      const { plane } = window.viewer.functionLevel, { direction } = window.viewer.scene.page.about.function;
      const across = plane.position.clone().set(0, 0, 1).applyQuaternion(plane.quaternion);
      const { x, y, z } = plane.position;
      return [window.viewer.scene.functionValue(x, y, z) - window.viewer.level(),
        1 - across.dot(across.clone().fromArray(direction))];
    });
    assert.ok(off.every((x) => Math.abs(x) < 1e-4), `${off}`);
    await picture(page, 'level');
    await check(page, 'level');
    assert.ok(!await page.getByText(/^level /).isVisible());
  });
});

test('without a sweep the level has a slider, which the address keeps', { timeout: 900000 }, async () => {
  const mesh = join(folder, 'caffeine.ply'), molecule = join(molecules, 'caffeine.xyz');
  execFileSync(morskin, ['mesh', molecule, '--model', 'paper', '-o', mesh, '-q']);
  const file = make('against', mesh, '--against', molecule);
  await withPage(file, small, async (page) => {
    const slider = page.locator('#share'), level = (at) => at.evaluate(() => window.viewer.level());
    assert.ok(!await slider.isVisible());
    await check(page, 'level');
    const { low, high } = await page.evaluate(() => window.viewer.scene.functionRange());
    assert.ok(await change(page, () => slider.fill('0.25')) > 0.01);
    assert.ok(Math.abs(await level(page) - (0.75 * low + 0.25 * high)) < 1e-9);
    assert.match(await page.getByText(/^level /).textContent(), /^level −[\d.]+ Å$/);
    const hash = await page.evaluate(() => { window.viewer.address.write(); return location.hash; });
    assert.equal(hash, '#level=1&share=0.25');
    await withPage(file + hash, small, async (again) => {
      assert.equal(await level(again), await level(page));
      assert.equal(await again.locator('#share').inputValue(), '0.25');
    });
  });
});

test('of a squared distance the centre is shown, and a sphere through the front', { timeout: 900000 },
  async () => {
    await withPage(pages.distance, small, async (page) => {
      assert.match(await page.locator('label[for=level]').textContent(), /Centre and level/);
      assert.ok(await change(page, () => check(page, 'level')) > 0.02);
      await page.evaluate(() => window.viewer.goTo(0.5 * window.viewer.sweep.steps));
      await settle(page);
      await picture(page, 'level-distance');
      const [radius, level, at] = await page.evaluate(() => {
        const { functionLevel: { group, sphere }, scene } = window.viewer;
        return [sphere.scale.x, window.viewer.level(),
          group.position.toArray().map((x, k) => x + scene.centre[k])];
      });
      assert.ok(Math.abs(radius ** 2 - level) < 1e-6 * level);
      at.forEach((x, k) => assert.ok(Math.abs(x - [3, 1, 2][k]) < 1e-5));
      assert.match(await page.getByText(/^level /).textContent(), /Å²$/);
      await page.locator('#colour').selectOption('value');
      assert.match(await page.locator('.legend').first().textContent(), /squared distance, Å²$/);
    });
  });

test('the ends of the scale of a function are told apart far from its zero', { timeout: 900000 },
  async () => {
    const far = make('far', join(molecules, 'caffeine.xyz'), '--function', 'distance:10000,0,0');
    await withPage(far, small, async (page) => {
      await page.locator('#colour').selectOption('value');
      const told = (await page.locator('.ticks span').allTextContents()).map(Number);
      const { low, high } = await page.evaluate(() => window.viewer.scene.functionRange());
      [low, (low + high) / 2, high].forEach((value, i) =>
        assert.ok(Math.abs(told[i] - value) < 0.01 * (high - low), `${told} of ${low} to ${high}`));
      // Values are not rounded to single precision, which has steps of 8 here.
      const steps = await page.evaluate(() =>
        window.viewer.scene.functionValues().filter((x) => x % 1 !== 0).length);
      assert.ok(steps > 1000, `${steps} values between whole numbers`);
    });
  });

test('the section of cells that are tiny is that of large ones', { timeout: 900000 }, async () => {
  const section = async (page) => {
    await page.evaluate(() => window.viewer.set({ style: 'off', section: true }));
    await settle(page);
    await page.evaluate(() => { document.querySelector('#scale').hidden = true; });
    return stage(page);
  };
  await withPage(pages.tiny, small, async (page) => {
    const tiny = await section(page);
    await withPage(pair('large', 1), small, async (large) => {
      const off = difference(tiny, await section(large));
      assert.ok(off < 0.05, `${off} of the picture is another`); // thin lines fall differently
    });
  });
});

test('places and levels of what is tiny are told with digits that are not all 0', { timeout: 900000 },
  async () => {
    await withPage(pages.tiny, small, async (page) => {
      await check(page, 'level');
      assert.match(await page.getByText(/^level /).textContent(), /[1-9]/);
      const told = await page.evaluate(() => {
        const { x, y, width, height } = document.querySelector('#stage').getBoundingClientRect();
        window.viewer.inspect(x + width / 2, y + height / 2);
        return document.querySelector('.told').textContent.match(/at (.*?)ρ|at ([^[]*)/)[0];
      });
      assert.match(told, /[1-9]/);
    });
  });
