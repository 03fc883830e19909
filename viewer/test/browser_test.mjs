// The viewer in a real browser: every switch, list, slider and key is worked, on a desk and on a
// phone; nothing may complain, and the pictures must be those stored in test/pictures.
//
//   npm test               UPDATE=1 npm test stores the pictures anew
//   MORSKIN=path/to/it     the command to make pages with (default ../build/morskin)

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, settle } from './browser.mjs';
import { compare, difference } from './pictures.mjs';

const root = new URL('../..', import.meta.url).pathname;
const morskin = process.env.MORSKIN ?? join(root, 'build/morskin');
const molecules = join(root, 'bench/molecules');
const folder = mkdtempSync(join(tmpdir(), 'morskin-viewer-'));
let browser;

const make = (name, ...words) => {
  const path = join(folder, `${name}.html`);
  execFileSync(morskin, ['view', ...words, '-o', path, '-q']);
  return path;
};
const pages = {};

before(async () => {
  browser = await launch();
  pages.ligand = make('ligand', join(molecules, '5tmn_ligand.pdb'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// The canvas alone, for letters differ from machine to machine, and small.
const stage = (page) => page.locator('#stage').screenshot();

const small = { width: 760, height: 400, scale: 0.5 };

async function withPage(file, options, work) {
  const opened = await open(browser, file, options);
  try {
    await work(opened.page);
    assert.deepEqual(opened.complaints, []);
  } finally {
    await opened.close();
  }
}

// Does something and says how much of the picture it changed.
async function change(page, act) {
  const old = await stage(page);
  await act();
  await settle(page);
  return difference(old, await stage(page));
}

const check = (page, id) => page.locator(`#${id}`).evaluate((box) => box.click());
const picture = async (page, name) => {
  const wrong = compare(name, await stage(page));
  assert.equal(wrong, null);
};

test('the page in the repository is what its sources make', () => {
  execFileSync('node', [join(root, 'viewer/build.mjs'), '--check']);
});

test('gramicidin is under 5 MB and shows within 5 seconds', { timeout: 900000 }, async () => {
  const file = make('gramicidin', join(molecules, '1grm_model1.pdb'));
  const text = readFileSync(file, 'utf8');
  const { triangles } = JSON.parse(text.match(/id="about">([^]*?)<\/script>/)[1]).mesh;
  assert.ok(triangles > 300000, `${triangles} triangles`);
  assert.ok(statSync(file).size < 5e6, `${statSync(file).size} bytes`);
  // The quickest of three: what else the machine does is not the page's doing.
  const waits = [];
  while (waits.length < 3 && !(Math.min(...waits) < 5000)) {
    await withPage(file, {}, async (page) => {
      waits.push(Number(await page.locator('html').getAttribute('data-ready')));
    });
  }
  console.log(`# ready after ${waits.join(', ')} ms, ${statSync(file).size} bytes`);
  assert.ok(Math.min(...waits) < 5000, `ready after ${waits} ms`);
});

test('every colouring of the surface differs from the one before', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const ids = await page.locator('#colour option').evaluateAll((list) => list.map((o) => o.value));
    assert.deepEqual(ids, ['kind', 'scale', 'quality', 'component', 'atom', 'region', 'value',
      'operation', 'plain']);
    await picture(page, 'colour-kind');
    for (const id of ids.slice(1)) {
      const changed = await change(page, () => page.locator('#colour').selectOption(id));
      assert.ok(changed > 0.02, `${id} changed ${changed}`);
      await picture(page, `colour-${id}`);
    }
  });
});

test('the angles of the page are as many below 30, 35 and 40 degrees as those of the mesh',
  { timeout: 900000 }, async () => {
    const molecule = join(molecules, '5tmn_ligand.pdb');
    const report = JSON.parse(execFileSync(morskin, ['mesh', molecule, '-o', '/dev/null',
      '--fronts', '1', '--json']));
    const share = (degrees) => 100 * report.quality.triangles_below_deg[degrees] / report.triangles;
    await withPage(pages.ligand, small, async (page) => {
      assert.equal(await page.locator('.histogram').count(), 0);
      await page.locator('#colour').selectOption('quality');
      const told = await page.getByRole('img', { name: 'Histogram of the smallest angles' })
        .getAttribute('aria-label');
      const shares = [...told.matchAll(/([\d.]+) % of the triangles below (\d+)/g)];
      assert.deepEqual(shares.map(([, , degrees]) => degrees), ['30', '35', '40']);
      // Angles are off by a few tenths of a degree: places are rounded to the page's grid.
      for (const [, told, degrees] of shares) {
        assert.ok(Math.abs(told - share(degrees)) < 0.2, `${told} below ${degrees}`);
      }
      assert.equal(Number(shares[0][1]), 0);
      const heights = await page.locator('.histogram i').evaluateAll((bars) =>
        bars.map((bar) => bar.getBoundingClientRect().height));
      assert.equal(heights.length, 40);
      assert.ok(heights.slice(0, 10).every((height) => height === 0), `${heights}`);
      assert.ok(Math.max(...heights) > 40 && heights.slice(11).every((height) => height >= 1));
    });
  });

test('every style of the surface shows', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    await page.locator('#colour').selectOption('plain');
    for (const style of ['flat', 'wire', 'off', 'smooth']) {
      const changed = await change(page, () => page.locator(`[data-value=${style}]`).click());
      assert.ok(changed > 0.001, `${style} changed ${changed}`);
      if (style !== 'off') await picture(page, `style-${style}`);
    }
    for (const id of ['edges', 'seeThrough']) {
      assert.ok(await change(page, () => check(page, id)) > 0.02, id);
      await picture(page, id);
      await check(page, id);
    }
  });
});

test('every layer can be shown and hidden again', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    await page.locator('#colour').selectOption('plain');
    await settle(page);
    const bare = await stage(page);
    // Atoms are inside.
    await page.keyboard.press('x');
    assert.ok(await change(page, () => check(page, 'atoms')) > 0.01);
    await picture(page, 'layer-atoms');
    await check(page, 'atoms');
    await page.keyboard.press('x');
    for (const [id, name] of [['points', 'points'], ['lines', 'lines'], ['spheres', 'spheres'],
      ['section', 'section']]) {
      assert.ok(await change(page, () => check(page, id)) > 0.001, id);
      await picture(page, `layer-${name}`);
      await check(page, id);
      await settle(page);
      assert.ok(difference(bare, await stage(page)) < 0.001, `${id} is still there`);
    }
  });
});

test('the simplified complex has fewer points, lines and regions', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    for (const id of ['points', 'lines']) await check(page, id);
    await page.locator('#colour').selectOption('region');
    const count = (id) => page.locator(`label[for=${id}] .count`).textContent().then(Number);
    const before = [await count('points'), await count('lines')];
    assert.ok(await change(page, () => check(page, 'simplified')) > 0.001);
    const left = [await count('points'), await count('lines')];
    assert.ok(left[0] < before[0] && left[1] < before[1], `${before} became ${left}`);
    await picture(page, 'simplified');
  });
});

test('the plane moves, turns, and cuts the surface', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    await check(page, 'section');
    await settle(page);
    assert.ok(await change(page, () => check(page, 'cut')) > 0.02);
    await picture(page, 'plane-z');
    const move = (value) => page.locator('#offset').evaluate((slider, to) => {
      slider.value = to;
      slider.dispatchEvent(new Event('input'));
    }, value);
    assert.ok(await change(page, () => move(0.3)) > 0.02);
    for (const axis of ['x', 'y', 'view']) {
      const press = () => page.locator(`section [data-value=${axis}]`).click();
      assert.ok(await change(page, press) > 0.02, axis);
    }
    assert.ok(await change(page, () => page.keyboard.press('[')) > 0.0005);
  });
});

test('the sweep goes from the first bowl to the last seal', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const steps = Number(await page.locator('#step').getAttribute('max'));
    const move = (share) => page.locator('#step').evaluate((slider, to) => {
      slider.value = to;
      slider.dispatchEvent(new Event('input'));
    }, Math.round(share * steps));
    const done = () => page.locator('.done .number:not(.all)').allTextContents()
      .then((list) => list.map((text) => Number(text.replaceAll(',', ''))));
    const whole = await stage(page);
    let last = [0, 0, 0, 0, 0];
    await move(0);
    assert.deepEqual(await done(), last);
    for (const share of [0.05, 0.3, 0.6, 0.9]) {
      assert.ok(await change(page, () => move(share)) > 0.005, `at ${share}`);
      const now = await done();
      assert.ok(now.every((n, i) => n >= last[i]) && now[1] > last[1], `${now} after ${last}`);
      assert.match(await page.locator('.done + .note').textContent(), /edges in the front at/);
      last = now;
      await picture(page, `sweep-${Math.round(100 * share)}`);
    }
    await move(1);
    await settle(page);
    assert.match(await page.locator('.done + .note').textContent(), /closed/);
    const off = difference(whole, await stage(page));
    assert.ok(off < 0.001, `the end is the whole mesh, but for ${off}`);
    // It runs by itself, and stops where it is asked to.
    await page.locator('button.play').click();
    await page.waitForFunction((most) => window.viewer.state.step > 0 &&
      window.viewer.state.step < most / 2, steps);
    await page.locator('button.play').click();
    assert.equal(await page.evaluate(() => window.viewer.state.playing), false);
  });
});

test('every key of the help does what it says', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const state = () => page.evaluate(() => ({ ...window.viewer.state }));
    const eye = () => page.evaluate(() => window.viewer.stage.camera.position.toArray().join());
    for (const [key, name] of [['e', 'edges'], ['x', 'seeThrough'], ['a', 'atoms'], ['k', 'points'],
      ['l', 'lines'], ['s', 'spheres'], ['i', 'simplified'], ['m', 'section'], ['u', 'cut'],
      ['p', 'panel'], ['1', 'style'], ['2', 'style'], ['3', 'style'], ['4', 'style'],
      ['c', 'colouring'], ['C', 'colouring'], [']', 'offset'], ['[', 'offset'], [',', 'step'],
      ['.', 'step'], ['<', 'step'], ['>', 'step'], [' ', 'playing'], [' ', 'playing']]) {
      if (key === '1') await page.keyboard.press('2');
      const old = (await state())[name];
      await page.keyboard.press(key);
      assert.notEqual((await state())[name], old, `key ${key}`);
    }
    for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', '+', '-']) {
      const old = await eye();
      await page.keyboard.press(key);
      assert.notEqual(await eye(), old, key);
    }
    const old = await eye();
    await page.keyboard.press('f');
    assert.notEqual(await eye(), old, 'f');
    await page.keyboard.press('h');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(!await page.locator('#help').isVisible());
    await settle(page);
  });
});

test('all of it can be reached with the tabulator', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const reached = new Set();
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id ||
        document.activeElement.getAttribute('aria-label') || document.activeElement.dataset.value));
    }
    const ids = await page.locator('#panel input, #panel select').evaluateAll((l) => l.map((e) => e.id));
    for (const id of ids) assert.ok(reached.has(id), `${id} is out of reach`);
  });
});

test('dark and light follow the system and the switch', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { ...small, scheme: 'dark' }, async (page) => {
    await picture(page, 'dark');
    assert.ok(await change(page, () => page.keyboard.press('d')) > 0.2);
    assert.ok(await change(page, () => page.keyboard.press('d')) > 0.2);
    await page.keyboard.press('d');
    await page.emulateMedia({ colorScheme: 'light' });
    await settle(page);
    assert.equal(await page.evaluate(() => window.viewer.isDark()), false);
  });
});

test('a phone shows the stage above the panel, and touch works it', { timeout: 900000 }, async () => {
  const phone = { width: 390, height: 844, touch: true };
  await withPage(pages.ligand, phone, async (page) => {
    const [above, below] = await Promise.all(['#stage', '#panel'].map((id) =>
      page.locator(id).boundingBox()));
    assert.ok(above.y + above.height <= below.y + 1 && above.height > 380 && below.width === 390);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    await picture(page, 'phone');
    await page.locator('label[for=points]').scrollIntoViewIfNeeded();
    assert.ok(await change(page, () => page.locator('label[for=points]').tap()) > 0.001);
    await page.locator('button.fold').tap();
    await settle(page);
    assert.ok((await page.locator('#stage').boundingBox()).height > above.height + 150);
    // Fingers are wide: what is tapped is at least 30 pixels high, or its row is.
    const heights = await page.locator('button, select').evaluateAll((list) => list
      .filter((e) => e.offsetParent).map((e) => e.getBoundingClientRect().height));
    assert.ok(Math.min(...heights) >= 30, `${heights}`);
  });
});

test('all of a tall molecule is in view, on a desk and on a phone', { timeout: 900000 }, async () => {
  const stack = join(folder, 'stack.xyzr');
  writeFileSync(stack, [0, 2, 4, 6, 8].map((y) => `0 ${y} 0 1\n`).join(''));
  const file = make('stack', stack);
  for (const size of [small, { width: 390, height: 844, touch: true }]) {
    await withPage(file, size, async (page) => {
      // The farthest point from the middle: 1 is the window's rim.
      const farthest = await page.evaluate(() => {
        const { bounds, camera, controls } = window.viewer.stage;
        const point = controls.target.clone();
        let max = 0;
        for (let i = 0; i < bounds.sample.length; i += 3) {
          point.fromArray(bounds.sample, i).project(camera);
          max = Math.max(max, Math.abs(point.x), Math.abs(point.y));
        }
        return max;
      });
      assert.ok(farthest > 0.8 && farthest < 1, `the farthest point is at ${farthest}`);
    });
  }
});

test('dragging turns the surface', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const changed = await change(page, async () => {
      await page.mouse.move(150, 150);
      await page.mouse.down();
      await page.mouse.move(230, 180, { steps: 4 });
      await page.mouse.up();
    });
    assert.ok(changed > 0.05, String(changed));
  });
});

test('a mesh shows only the layers it has, and a growing one its frames', { timeout: 900000 }, async () => {
  const ring = join(molecules, 'ring12.xyzr');
  const mesh = (name, ...words) => {
    const path = join(folder, name);
    execFileSync(morskin, ['mesh', ring, '-o', path, '-q', ...words]);
    return path;
  };
  const coarse = mesh('coarse.ply', '-C', '0.16', '-Q', '1.7'), fine = mesh('fine.ply');
  await withPage(make('mesh', fine), small, async (page) => {
    const ids = await page.locator('#colour option').evaluateAll((list) => list.map((o) => o.value));
    assert.deepEqual(ids, ['quality', 'component', 'plain']);
    assert.equal(await page.locator('#step').count(), 0);
    assert.equal(await page.locator('#atoms').count(), 0);
    for (const key of 'axkmsul ,.') await page.keyboard.press(key);
    await picture(page, 'mesh');
  });
  await withPage(make('growing', fine, '--frames', coarse, fine), small, async (page) => {
    const move = (to) => page.locator('#frame').evaluate((slider, frame) => {
      slider.value = frame;
      slider.dispatchEvent(new Event('input'));
    }, to);
    assert.ok(await change(page, () => move(0)) > 0.02);
    assert.match(await page.locator('.player ~ .note').last().textContent(), /coarse/);
    await picture(page, 'growth');
    await page.keyboard.press('g');
    await page.waitForFunction(() => window.viewer.state.frame === 2);
  });
  await withPage(make('against', fine, '--against', ring), small, async (page) => {
    await check(page, 'lines');
    await check(page, 'points');
    assert.equal(await page.locator('#step').count(), 0);
    await settle(page);
    await picture(page, 'against');
  });
});
