// The sweep, touch and dragging: the viewer worked by hand, on a desk and on a phone.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fingers, settle } from './browser.mjs';
import {
  morskin, molecules, folder, make, pages, stage, small, withPage, change, check, picture,
} from './pages.mjs';
import { difference } from './pictures.mjs';

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
    // It runs by itself, and stops where it is asked to, by a click as slow as a hand's.
    const name = () => page.locator('button.play').getAttribute('aria-label');
    assert.equal(await name(), 'Run the sweep');
    await page.locator('button.play').click();
    await page.waitForFunction((most) => window.viewer.state.step > 0 &&
      window.viewer.state.step < most / 2, steps);
    assert.equal(await name(), 'Stop the sweep');
    await page.locator('button.play').click({ delay: 200 });
    assert.equal(await page.evaluate(() => window.viewer.state.playing), false);
    assert.equal(await name(), 'Run the sweep');
  });
});

test('a sweep left open does not end with a closed mesh', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const end = (closed) => page.evaluate((isClosed) => {
      const { viewer } = window;
      viewer.scene.page.about.closed = isClosed;
      viewer.goTo(1);
      viewer.goTo(Infinity);
      return document.querySelector('.done + .note').textContent;
    }, closed);
    assert.match(await end(true), /triangles, closed$/);
    assert.match(await end(false), /triangles, not closed$/);
  });
});

test('dark and light follow the system until the switch is used', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { ...small, scheme: 'dark' }, async (page) => {
    await picture(page, 'dark');
    const system = (colorScheme) => change(page, () => page.emulateMedia({ colorScheme }));
    assert.ok(await system('light') > 0.2);
    assert.ok(await system('dark') > 0.2);
    assert.ok(await change(page, () => page.keyboard.press('d')) > 0.2);
    // From now on it is as the switch says.
    assert.equal(await system('light'), 0);
    assert.equal(await system('dark'), 0);
    assert.equal(await page.evaluate(() => window.viewer.isDark()), false);
    assert.ok(await change(page, () => page.keyboard.press('d')) > 0.2);
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

test('fingers turn the surface, move it nearer and tell of what they tap', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { width: 390, height: 844, touch: true }, async (page) => {
    const touch = await fingers(page);
    const distance = () => page.evaluate(() => window.viewer.stage.controls.getDistance());
    const told = page.locator('#panel section').first();
    const turned = await change(page, async () => {
      await touch('touchStart', [195, 220]);
      for (let k = 1; k < 6; ++k) await touch('touchMove', [195 + 12 * k, 220 + 4 * k]);
      await touch('touchEnd');
    });
    assert.ok(turned > 0.05, String(turned));
    assert.ok(!await told.isVisible(), 'a drag is no tap');
    // The one finger rests, as that of a tap would; the other draws away from it.
    await page.evaluate(() => window.viewer.stage.fit());
    const far = await distance();
    await page.evaluate(() => window.viewer.panel.say('until a tap'));
    await touch('touchStart', [195, 200]);
    await touch('touchStart', [195, 200], [195, 260]);
    for (let k = 1; k < 6; ++k) await touch('touchMove', [195, 200 - 10 * k], [195, 260]);
    await touch('touchEnd', [195, 150]);
    await touch('touchEnd');
    assert.ok(await distance() < 0.9 * far);
    assert.match(await told.textContent(), /until a tap/, 'two fingers are no tap');
    await page.evaluate(() => window.viewer.stage.fit());
    const words = new Set();
    for (const x of [195, 160, 230, 125]) {
      await page.touchscreen.tap(x, 220);
      words.add(await told.textContent());
    }
    assert.ok([...words].some((text) => /^ClickedTriangle/.test(text)), `${[...words]}`);
  });
});

test('fingers on the surface neither zoom nor scroll the page', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { width: 390, height: 844, touch: true }, async (page) => {
    const touch = await fingers(page);
    // Pinches, drags, and tells how the browser then shows the page.
    const shown = async () => {
      await touch('touchStart', [195, 200]);
      await touch('touchStart', [195, 200], [195, 240]);
      for (let k = 1; k < 9; ++k) {
        await touch('touchMove', [195, 200 - 10 * k], [195, 240 + 10 * k]);
      }
      await touch('touchEnd');
      await touch('touchStart', [195, 300]);
      for (let k = 1; k < 9; ++k) await touch('touchMove', [195, 300 - 20 * k]);
      await touch('touchEnd');
      await settle(page);
      return page.evaluate(() => {
        const { scale, pageLeft, pageTop } = window.visualViewport;
        return { scale, left: pageLeft, top: pageTop };
      });
    };
    assert.deepEqual(await shown(), { scale: 1, left: 0, top: 0 });
    // It would be seen here if they did.
    await page.locator('canvas').evaluate((canvas) => { canvas.style.touchAction = 'auto'; });
    const { scale, top } = await shown();
    assert.ok(scale > 1.5 && top > 50, `${scale}, ${top}`);
  });
});

test('a triangle without an angle is told, not left out', { timeout: 900000 }, async () => {
  const flat = join(folder, 'flat.ply');
  writeFileSync(flat, 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n' +
    'property double y\nproperty double z\nelement face 1\n' +
    'property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n');
  await withPage(make('flat', flat), small, async (page) => {
    assert.match(await page.locator('.counts').textContent(), /smallest angle 0\.00°/);
    assert.match(await page.locator('.legend').first().textContent(), /least 0\.0°/);
  });
});

test('a mesh shows only the layers it has, and a growing one its frames', { timeout: 900000 }, async () => {
  const ring = join(molecules, 'ring12.xyzr');
  const mesh = (name, ...words) => {
    const path = join(folder, name);
    execFileSync(morskin, ['mesh', ring, '--model', 'paper', '-o', path, '-q', ...words]);
    return path;
  };
  const long = 'coarse_as_a_mesh_may_be_and_of_a_name_longer_than_the_panel_is_wide';
  // A click at one of many places of the window.
  const isTold = (page) => page.evaluate(() => {
    const { viewer } = window, box = viewer.stage.container.getBoundingClientRect();
    for (let i = 1; i < 400; ++i) {
      viewer.inspect(box.left + box.width * (i % 20) / 20, box.top + box.height * Math.floor(i / 20) / 20);
      if (!viewer.panel.told.hidden) return true;
    }
    return false;
  });
  const coarse = mesh(`${long}.ply`, '-C', '0.16', '-Q', '1.7'), fine = mesh('fine.ply');
  await withPage(make('mesh', fine), small, async (page) => {
    const ids = await page.locator('#colour option').evaluateAll((list) => list.map((o) => o.value));
    assert.deepEqual(ids, ['quality', 'component', 'plain']);
    assert.equal(await page.locator('#step').count(), 0);
    assert.equal(await page.locator('#atoms').count(), 0);
    for (const key of 'axkmsul ,.') await page.keyboard.press(key);
    await picture(page, 'mesh');
    await page.keyboard.press('p');
    assert.equal(await isTold(page), true);
    assert.match(await page.locator('#answer').textContent(), /^Triangle angles .*° · Vertex at −?\d/);
  });
  await withPage(make('growing', fine, '--frames', coarse, fine), small, async (page) => {
    const move = (to) => page.locator('#frame').evaluate((slider, frame) => {
      slider.value = frame;
      slider.dispatchEvent(new Event('input'));
    }, to);
    assert.ok(await change(page, () => move(0)) > 0.02);
    assert.match(await page.locator('.player ~ .note').last().textContent(), /coarse/);
    assert.ok(await page.locator('.body').evaluate((body) => body.scrollWidth <= body.clientWidth),
      'a long name makes the panel scroll sideways');
    await picture(page, 'growth');
    // Whatever is switched, the frame is shown alone, and a click tells nothing of the mesh.
    const isMeshSeen = () => page.evaluate(() => window.viewer.surface.group.visible);
    for (const key of '2341') await page.keyboard.press(key);
    await settle(page);
    await picture(page, 'growth');
    assert.deepEqual([await isMeshSeen(), await isTold(page)], [false, false]);
    const growing = () => page.evaluate(() => window.viewer.state.growing);
    await page.keyboard.press('g');
    assert.equal(await growing(), true);
    await page.keyboard.press('g');
    assert.equal(await growing(), false);
    // The address opens the frame.
    const address = await page.evaluate(() => { window.viewer.address.write(); return location.hash; });
    assert.match(address, /frame=0/);
    await withPage(join(folder, 'growing.html') + address, small, async (again) =>
      assert.equal(await again.evaluate(() => window.viewer.state.frame), 0));
    // Stopped and started again it is no faster: three seconds for each of two frames.
    const seconds = await page.evaluate(() => new Promise((done) => {
      const { viewer } = window, start = performance.now();
      for (let k = 0; k < 3; ++k) viewer.toggleGrowth();
      viewer.stage.onDraw.push(() => {
        if (viewer.state.frame === 2) done((performance.now() - start) / 1000);
      });
    }));
    assert.ok(seconds > 5.9, `${seconds} s`);
    assert.deepEqual([await isMeshSeen(), await isTold(page)], [true, true]);
  });
  await withPage(make('swept', ring, '--frames', coarse), small, async (page) => {
    const isFrontSeen = () => page.evaluate(() => window.viewer.sweep.frontObject.visible);
    const go = (name, to) => page.evaluate(([act, n]) => window.viewer[act](n), [name, to]);
    await go('goTo', 500);
    assert.equal(await isFrontSeen(), true);
    await go('goToFrame', 0);
    assert.equal(await isFrontSeen(), false, 'the front of the mesh lies over a frame');
    await go('goTo', 600);
    assert.equal(await isFrontSeen(), false);
    await go('goToFrame', 1);
    assert.equal(await isFrontSeen(), true);
  });
  const empty = join(folder, 'empty.off');
  writeFileSync(empty, 'OFF\n0 0 0\n');
  await withPage(make('empty frame', fine, '--frames', empty), small, async (page) => {
    await page.evaluate(() => window.viewer.goToFrame(0));
    await settle(page);
    assert.match(await page.locator('.player ~ .note').last().textContent(), /empty: 0 triangles/);
  });
  await withPage(make('against', fine, '--against', ring), small, async (page) => {
    await check(page, 'lines');
    await check(page, 'points');
    assert.equal(await page.locator('#step').count(), 0);
    await settle(page);
    await picture(page, 'against');
  });
});
