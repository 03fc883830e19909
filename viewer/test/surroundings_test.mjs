// What the page meets in a browser that is not as it was made for.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { launch, settle } from './browser.mjs';
import { folder, pages, small, stage, withPage } from './pages.mjs';
import { difference } from './pictures.mjs';

test('a graphics card that was lost comes back with the same picture', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const whole = await stage(page);
    const event = (name, act) => page.evaluate(([name, act]) => new Promise((done) => {
      const { renderer } = window.viewer.stage;
      window.card ??= renderer.getContext().getExtension('WEBGL_lose_context');
      renderer.domElement.addEventListener(name, () => setTimeout(done, 100), { once: true });
      window.card[act]();
    }), [name, act]);
    await event('webglcontextlost', 'loseContext');
    const frames = await page.evaluate(() => window.viewer.stage.frames);
    await event('webglcontextrestored', 'restoreContext');
    await page.waitForFunction((n) => window.viewer.stage.frames > n, frames, { timeout: 60000 });
    await settle(page);
    const off = difference(whole, await stage(page));
    assert.ok(off < 0.001, `${off} of the picture is another`);
  });
});

test('the help opens at its beginning where it is longer than the window', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, { width: 390, height: 500, scale: 0.5 }, async (page) => {
    const help = page.locator('#help');
    for (let round = 0; round < 2; ++round) {
      await page.keyboard.press('h');
      const [at, most] = await help.evaluate((part) =>
        [part.scrollTop, part.scrollHeight - part.clientHeight]);
      assert.ok(most > 50, `all of it is in view: ${most}`);
      assert.equal(at, 0);
      await page.keyboard.press('h');
    }
  });
});

test('without scripts the page says so, and is not unpacked for ever', { timeout: 900000 }, async () => {
  const browser = await launch();
  try {
    const page = await browser.newPage({ javaScriptEnabled: false });
    await page.goto(`file://${pages.ligand}`);
    assert.match(await page.locator('body').innerText(), /^The page cannot be shown: .*JavaScript/);
  } finally {
    await browser.close();
  }
});

test('a browser without WebGL is told what to do', { timeout: 900000 }, async () => {
  const browser = await launch('--disable-3d-apis');
  try {
    const page = await browser.newPage();
    await page.goto(`file://${pages.ligand}`);
    assert.match(await page.locator('#message.failed').innerText(),
      /^The page cannot be shown: .* no WebGL 2; turn on hardware acceleration/);
  } finally {
    await browser.close();
  }
});

test('colours that a system forces upon the page leave the legend its own', { timeout: 900000 }, async () => {
  await withPage(pages.ligand, small, async (page) => {
    const colours = (part) => page.locator(part).evaluateAll((list) =>
      list.map((e) => getComputedStyle(e).backgroundColor));
    const legend = await colours('.legend .dot'), layers = await colours('.toggle .dot');
    assert.ok(new Set(legend).size === 4 && layers.length > 8, `${legend}, ${layers}`);
    await page.emulateMedia({ forcedColors: 'active' });
    assert.deepEqual(await colours('.legend .dot'), legend);
    assert.deepEqual(await colours('.toggle .dot'), layers);
    await page.locator('#colour').selectOption('quality');
    const [bars, panel] = [await colours('.histogram i'), await colours('#panel')];
    assert.ok(!bars.includes(panel[0]), `bars are ${bars[0]} like the panel`);
  });
});

test('a page that was cut off says so, and is not unpacked for ever', { timeout: 900000 }, async () => {
  const whole = readFileSync(pages.ligand), at = (words) => whole.lastIndexOf(words);
  const file = join(folder, 'cut.html'), browser = await launch();
  try {
    for (const end of [at('id="about"') + 20, at('id="data"') + 5000, at('<script>') + 5000]) {
      writeFileSync(file, whole.subarray(0, end));
      const page = await browser.newPage();
      await page.goto(`file://${file}`);
      assert.equal(await page.locator('#message.failed').innerText(),
        'The page cannot be shown: it is cut off, or this browser is too old');
    }
  } finally {
    await browser.close();
  }
});

test('a page whose data are broken says that they are', { timeout: 900000 }, async () => {
  const [before, data, after] = readFileSync(pages.ligand, 'utf8').split(/(?<=id="data">)([^<]*)/);
  const browser = await launch();
  try {
    for (const broken of [data.slice(0, data.length / 2), '', `!!${data}`]) {
      const file = join(folder, 'broken.html');
      writeFileSync(file, before + broken + after);
      const page = await browser.newPage();
      await page.goto(`file://${file}`);
      assert.equal(await page.locator('#message.failed').innerText(),
        'The page cannot be shown: its data are broken or cut off');
    }
  } finally {
    await browser.close();
  }
});

test('a page shown within another as its text works without an address', { timeout: 900000 }, async () => {
  const outer = join(folder, 'outer.html');
  const text = readFileSync(pages.ligand, 'utf8').replaceAll('&', '&amp;').replaceAll('"', '&quot;');
  writeFileSync(outer, `<!doctype html><html data-ready><title>of another</title>
    <iframe sandbox="allow-scripts" style="width: 700px; height: 380px" srcdoc="${text}"></iframe>`);
  await withPage(outer, small, async (page) => {
    const inner = await (await page.locator('iframe').elementHandle()).contentFrame();
    await inner.waitForSelector('html[data-ready]');
    await inner.evaluate(() => {
      window.viewer.set({ edges: true });
      window.viewer.address.write();
      return window.viewer.copyLink();
    });
    assert.equal(await inner.locator('.told').textContent(), 'This page has no address to link to.');
  });
});

test('on paper the surface keeps its proportions and the legend its colours', { timeout: 900000 }, async () => {
  await withPage(`${pages.ligand}#colouring=quality`, small, async (page) => {
    const style = (part, name) => page.locator(part).first().evaluate((e, of) => getComputedStyle(e)[of], name);
    await page.emulateMedia({ media: 'print' });
    // The browser lays the page out for paper and draws nothing anew.
    assert.equal(await style('canvas', 'objectFit'), 'contain');
    assert.equal(await style('#scale', 'display'), 'none', 'it would not be true');
    for (const part of ['.ramp', '.histogram i', '.toggle .dot']) {
      assert.equal(await style(part, 'printColorAdjust'), 'exact', part);
    }
  });
});
