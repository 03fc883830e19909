// The address that keeps the state, the click that tells, the scale, the picture and the way back to
// a folded panel.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { settle } from './browser.mjs';
import { change, folder, morskin, pages, small, stage, withPage } from './pages.mjs';
import { difference } from './pictures.mjs';

const hash = (page) => page.evaluate(() => { window.viewer.address.write(); return location.hash; });
const state = (page) => page.evaluate(() => ({ ...window.viewer.state }));

test('a page opened by its own address is the same page again', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    assert.equal(await hash(page), '');
    const first = await state(page);
    for (const key of 'emucaxk2lsiv]') await page.keyboard.press(key);
    await page.keyboard.press('ArrowLeft');
    await page.locator('#step').press('PageDown');
    await page.locator('section [data-value=view]').click();
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press('ArrowUp'); // the plane is that of the view before
    await page.keyboard.press('p');
    await settle(page);
    const address = await hash(page), was = await state(page), seen = await stage(page);
    const normal = await page.evaluate(() => window.viewer.normal);
    assert.match(address, /edges=1.*axis=.*eye=/);
    // All that an address can tell of this page is not as it was at first.
    const same = Object.keys(was).filter((name) => was[name] === first[name]);
    assert.deepEqual(same, ['hidden', 'share', 'playing', 'frame', 'growing']);
    await withPage(pages.ligand + address, small, async (again) => {
      assert.deepEqual(await state(again), was);
      const other = await again.evaluate(() => window.viewer.normal);
      assert.ok(normal.every((x, k) => Math.abs(x - other[k]) < 1e-6), other);
      // Thin lines fall a little differently, as in the stored pictures; the plane has many.
      assert.ok(difference(seen, await stage(again)) < 0.05);
      assert.equal(await hash(again), address);
    });
  });
});

test('an address put in the place of another opens what a new page would', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const eye = () => page.evaluate(() => window.viewer.stage.camera.position.toArray()
      .map((x) => x.toFixed(4)));
    const first = await state(page), home = await eye();
    for (const key of 'e2mu') await page.keyboard.press(key);
    await page.keyboard.press('ArrowLeft');
    await page.locator('section [data-value=view]').click();
    await settle(page);
    assert.notDeepEqual(await eye(), home);
    await page.evaluate(() => { location.hash = '#colouring=scale'; });
    await page.waitForFunction(() => window.viewer.state.colouring === 'scale');
    await settle(page);
    assert.deepEqual(await state(page), { ...first, colouring: 'scale' });
    assert.deepEqual(await eye(), home);
    assert.equal(await hash(page), '#colouring=scale');
    // A sweep that runs stops at the step of the address.
    await page.evaluate(() => window.viewer.togglePlay());
    await page.waitForFunction(() => window.viewer.state.playing && window.viewer.state.step > 3);
    await page.evaluate(() => { location.hash = '#step=3'; });
    await page.waitForFunction(() => !window.viewer.state.playing);
    await settle(page);
    assert.deepEqual(await state(page), { ...first, step: 3 });
  });
});

test('an address that makes no sense opens the page as it is', { timeout: 900000 }, async () => {
  const nonsense = '#style=none&colouring=7&step=NaN&offset=9&eye=1,2&edges=yes&axis=q&axis=1,1,NaN&__proto__=1&frame=3';
  await withPage(pages.ligand, small, async (page) => {
    const first = await state(page);
    await withPage(pages.ligand + nonsense, small, async (again) => {
      assert.deepEqual(await state(again), { ...first, offset: 1 });
    });
    // Nor one that has the eye where there is nothing to see.
    const eye = (at) => at.evaluate(() => window.viewer.stage.camera.position.toArray());
    const home = await eye(page);
    for (const word of ['0,0,0,1e300,0,0', '1e9,0,0,1e9,0,1', ',,,,,', '0,0,NaN,0,0,1', '1,2,3,4,5,6,7']) {
      await page.evaluate((to) => { location.hash = `#edges=1&eye=${to}`; }, word);
      await page.waitForFunction(() => window.viewer.state.edges);
      assert.deepEqual(await eye(page), home, word);
      await page.evaluate(() => { location.hash = ''; });
      await page.waitForFunction(() => !window.viewer.state.edges);
    }
  });
});

test('a click tells of triangle, vertex and ball, and beside the surface of nothing', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const told = page.locator('.told');
    const { width, height } = await page.locator('#stage').boundingBox();
    let words = '';
    for (const share of [0.5, 0.42, 0.58, 0.36]) {
      await page.mouse.click(width * share, height / 2);
      if (await told.isVisible()) { words = await told.textContent(); break; }
    }
    assert.match(words, /angles [\d.]+°, [\d.]+°, [\d.]+°.*Laid by.*Vertexat.*\[L\].*\[U\].*ρ.*Cell.*Nearest ball.*Its atom[A-Z].*Residue0PJ/);
    const [, L] = words.match(/\(above 1\)([\d.]+)/), [, U] = words.match(/\(below 1\)([\d.]+)/);
    assert.ok(Number(L) > 1 && Number(U) < 1, words);
    await page.mouse.click(3, 3);
    assert.ok(!await told.isVisible());
  });
});

test('with the panel folded a line over the surface tells the atom, and is read aloud',
  { timeout: 900000 }, async () => {
    for (const size of [small, { width: 390, height: 844, touch: true }]) {
      await withPage(pages.ligand, size, async (page) => {
        const line = page.getByRole('status'), told = page.locator('.told');
        const click = (x, y) => (size.touch ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
        const clickSurface = async () => {
          const { width, height } = await page.locator('#stage').boundingBox();
          for (const share of [0.5, 0.42, 0.58, 0.36]) {
            await click(width * share, height / 2);
            if (await page.locator('.told tr').count() > 0) return;
          }
          assert.fail('no place of the surface was hit');
        };
        await clickSurface();
        assert.ok(await told.isVisible());
        assert.equal(await line.textContent(), '', 'the panel has told it');
        await page.keyboard.press('p');
        await settle(page);
        assert.ok(!await told.isVisible());
        const words = /^Nearest ball \d+ [A-Z]+ · Its atom [A-Z]+\d* · Residue 0PJ/;
        assert.match(await line.textContent(), words);
        // Beside the surface there is nothing to tell: the line stays, and takes no place.
        await click(3, 60);
        assert.deepEqual([await line.textContent(), await line.count()], ['', 1]);
        assert.equal(await line.evaluate((e) => e.offsetHeight), 0);
        await clickSurface();
        assert.match(await line.textContent(), words);
        const here = await line.boundingBox(), button = await page.locator('#unfold').boundingBox();
        assert.ok(here.height > 15 && here.height < 60 && here.x + here.width < button.x);
        assert.ok(await line.evaluate((e) => e.checkVisibility()));
        await page.evaluate(() => window.viewer.copyLink());
        assert.match(await line.textContent(), /^The link is/);
        await page.locator('#unfold').click();
        assert.deepEqual([await line.textContent(), await told.isVisible()], ['', true]);
      });
    }
  });

test('the scale bar is as long as it says, nearer too', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const wrong = () => page.evaluate(() => {
      const { camera, controls, container } = window.viewer.stage;
      const bar = document.querySelector('#scale i').getBoundingClientRect().width;
      const length = Number.parseFloat(document.querySelector('#scale span').textContent);
      // A step of that length to the right of the middle, as the camera sees it.
      const right = controls.target.clone().setFromMatrixColumn(camera.matrixWorld, 0);
      const seen = controls.target.clone().addScaledVector(right, length).project(camera).x;
      return Math.abs((seen * container.clientWidth) / 2 - bar);
    });
    assert.ok(await wrong() < 1.5);
    for (let k = 0; k < 8; ++k) await page.keyboard.press('+');
    await settle(page);
    assert.ok(await wrong() < 1.5);
  });
});

test('the panel comes back after P, and the picture is saved', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    assert.ok(!await page.locator('#unfold').isVisible());
    await page.keyboard.press('p');
    assert.ok(!await page.locator('#panel').isVisible());
    await page.locator('#unfold').click();
    assert.ok(await page.locator('#panel').isVisible());
    const [download] = await Promise.all([page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the picture (PNG)' }).click()]);
    assert.match(download.suggestedFilename(), /ligand.*\.png$/);
    const bytes = readFileSync(await download.path());
    assert.deepEqual([...bytes.subarray(1, 4)], [...Buffer.from('PNG')]);
    assert.ok(bytes.length > 5000, 'not an empty picture');
    assert.ok(await change(page, () => page.getByRole('button', { name: 'Copy a link to this view' }).click()) < 0.01);
    assert.match(await page.locator('.told').textContent(), /link is/);
  });
});

test('the eye at something tiny is where the address says', { timeout: 900000 }, async () => {
  const balls = join(folder, 'tiny.xyzr'), file = join(folder, 'tiny.html');
  writeFileSync(balls, '0 0 0 1.7e-5\n1.5e-5 1e-5 0 1.5e-5\n');
  execFileSync(morskin, ['view', balls, '-o', file, '-q']);
  await withPage(file, small, async (page) => {
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    const eye = (at) => at.evaluate(() => window.viewer.stage.camera.position.toArray());
    const was = await eye(page);
    await withPage(file + await hash(page), small, async (again) => {
      const is = await eye(again), off = Math.hypot(...is.map((x, k) => x - was[k]));
      assert.ok(off < 1e-3 * Math.hypot(...was), `${is} for ${was}`);
    });
  });
});
