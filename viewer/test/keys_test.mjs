// The keyboard alone: every key of the help, and all that the tabulator reaches.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pages, small, withPage } from './pages.mjs';

const state = (page) => page.evaluate(() => ({ ...window.viewer.state }));

test('every key of the help does what it says', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const tried = new Set(['Click', 'G']); // tested where clicks and growths are
    const press = async (key, name = key === ' ' ? 'Space' : key.toUpperCase()) => {
      tried.add(name);
      await page.keyboard.press(key);
      return state(page);
    };
    const first = await state(page);
    for (const [key, name] of [['e', 'edges'], ['x', 'seeThrough'], ['a', 'atoms'], ['k', 'points'],
      ['l', 'lines'], ['s', 'spheres'], ['i', 'simplified'], ['m', 'section'], ['u', 'cut'],
      ['v', 'level'], ['p', 'panel'], [' ', 'playing']]) {
      assert.equal((await press(key))[name], !first[name], `key ${key}`);
      assert.equal((await press(key))[name], first[name], `key ${key} again`);
    }
    for (const [key, style] of [['2', 'flat'], ['3', 'wire'], ['4', 'off'], ['1', 'smooth']]) {
      assert.equal((await press(key)).style, style);
    }
    const colours = await page.locator('#colour option').evaluateAll((list) => list.map((o) => o.value));
    for (const [key, at] of [['c', 1], ['c', 2], ['Shift+C', 1], ['Shift+C', 0], ['Shift+C', -1]]) {
      assert.equal((await press(key, 'C')).colouring, colours.at(at), key);
    }
    assert.equal((await press(']')).offset, 0.02);
    assert.equal((await press(']')).offset, 0.04);
    assert.equal((await press('[')).offset, 0.02);
    const all = await page.evaluate(() => window.viewer.sweep.steps), hundredth = Math.ceil(all / 100);
    await page.evaluate(() => window.viewer.goTo(Infinity));
    for (const [key, name, step] of [[',', ',', all - 1], ['<', ',', all - 1 - hundredth],
      ['.', '.', all - hundredth], ['>', '.', all], ['.', '.', all]]) {
      assert.equal((await press(key, name)).step, step, `key ${key}`);
    }
    const isDark = () => page.evaluate(() => window.viewer.isDark());
    await press('d');
    assert.equal(await isDark(), true);
    await press('d');
    assert.equal(await isDark(), false);
    const help = page.locator('#help');
    await press('h');
    const told = await help.locator('kbd').allTextContents();
    assert.ok(await help.isVisible());
    await press('h');
    assert.ok(!await help.isVisible());
    await press('h');
    await page.keyboard.press('Escape'); // the browser's own key: it closes when it comes to it
    await page.waitForFunction(() => document.activeElement === document.body);
    assert.ok(!await help.isVisible());
    // What is nearest to the eye goes where the arrow points, as if it were dragged.
    const view = () => page.evaluate(() => {
      const { camera, controls, bounds } = window.viewer.stage, old = window.nearest;
      camera.updateMatrixWorld();
      const seen = old?.project(camera).toArray() ?? [];
      const off = camera.position.clone().sub(controls.target).setLength(bounds.radius);
      window.nearest = controls.target.clone().add(off);
      return { seen, distance: controls.getDistance() };
    });
    await view();
    for (const [key, axis, way] of [['ArrowLeft', 0, -1], ['ArrowRight', 0, 1], ['ArrowUp', 1, 1],
      ['ArrowDown', 1, -1]]) {
      await press(key, 'Arrows');
      const { seen } = await view();
      assert.ok(way * seen[axis] > 0.02 && Math.abs(seen[1 - axis]) < 0.02, `${key}: ${seen}`);
    }
    const { distance } = await view();
    await press('+');
    assert.ok((await view()).distance < 0.95 * distance);
    await press('-', '−');
    await press('-', '−');
    assert.ok((await view()).distance > 1.05 * distance);
    await press('f');
    assert.ok(Math.abs((await view()).distance / distance - 1) < 1e-6);
    assert.deepEqual([...tried].sort(), [...new Set(told)].sort(), 'the keys tried are those of the help');
  });
});

test('brackets typed with Alt move the plane, and Shift leaps on keyboards of Europe too',
  { timeout: 900000 }, async () => {
    await withPage(pages.ligand, small, async (page) => {
      const press = (key, held = {}) => page.evaluate(([name, more]) => {
        const event = new KeyboardEvent('keydown', { key: name, cancelable: true, ...more });
        window.dispatchEvent(event);
        return event.defaultPrevented;
      }, [key, held]);
      const offset = async () => (await state(page)).offset;
      assert.ok(await press(']', { altKey: true }));
      assert.equal(await offset(), 0.02);
      assert.ok(await press('[', { altKey: true, ctrlKey: true }), 'AltGr');
      assert.equal(await offset(), 0);
      for (const held of [{ ctrlKey: true }, { metaKey: true }]) {
        assert.ok(!await press(']', held), 'the browser keeps its own');
      }
      assert.ok(!await press('e', { altKey: true }));
      assert.equal(await offset(), 0);
      const all = await page.evaluate(() => window.viewer.sweep.steps);
      const hundredth = Math.ceil(all / 100);
      await press(';', { shiftKey: true });
      assert.equal((await state(page)).step, all - hundredth);
      await press(':', { shiftKey: true });
      assert.equal((await state(page)).step, all);
    });
  });

test('behind the open help no key acts, and Escape closes it', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const help = page.locator('#help');
    const all = () => page.evaluate(() => ({ ...window.viewer.state, isDark: window.viewer.isDark(),
      eye: window.viewer.stage.camera.position.toArray() }));
    await page.evaluate(() => window.viewer.goTo(5));
    const first = await all();
    await page.keyboard.press('h');
    await help.locator('h2').click(); // off the button, which the space bar would press
    for (const key of ['2', 'c', ...'exaklsimuvp', ']', 'ArrowLeft', 'ArrowUp', '+', 'd', '.', '>', ' ', 'g']) {
      await page.keyboard.press(key);
      assert.deepEqual(await all(), first, `key ${key}`);
      assert.ok(await help.isVisible(), `key ${key} closes it`);
    }
    await page.keyboard.press('Escape');
    await help.waitFor({ state: 'hidden' });
    await page.keyboard.press('e');
    assert.deepEqual(await all(), { ...first, edges: true }, 'keys act again');
  });
});

test('the space bar unfolds what is proved and runs no sweep', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { width: 760, height: 600, scale: 0.5 }, async (page) => {
    await page.locator('summary').focus();
    await page.keyboard.press(' ');
    assert.equal(await page.locator('details').getAttribute('open'), '');
    assert.equal((await state(page)).playing, false);
  });
});

test('all of it can be reached with the tabulator', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const count = await page.evaluate(() => {
      window.missed = new Set([...document.querySelectorAll('canvas, input, select, button, summary')]
        .filter((part) => part.checkVisibility()));
      document.addEventListener('focusin', (event) => window.missed.delete(event.target));
      return window.missed.size;
    });
    assert.ok(count > 25, `${count} parts`);
    for (let i = 0; i <= count; ++i) await page.keyboard.press('Tab');
    assert.deepEqual(await page.evaluate(() => [...window.missed].map((part) => part.outerHTML)), []);
  });
});
