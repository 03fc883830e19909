// What the tests of the course's interactive parts share: the parts, bundled anew, and a browser to
// open them.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { launch, open, settle } from './browser.mjs';
import { morskin, root } from './pages.mjs';

const folder = mkdtempSync(join(tmpdir(), 'morskin-interactive-'));
export const parts = JSON.parse(execFileSync('python3', [join(root, 'papers/interactive/build.py'),
  folder, '--command', morskin, '--list'], { encoding: 'utf8' }));
let browser;
before(async () => { browser = await launch(); });
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// name: of a part, or viewer, and what follows # in its address.
export async function withPart(name, options, work, hash = '') {
  const opened = await open(browser, join(folder, `${name}.html`) + hash, options);
  try {
    await work(opened.page);
    await settle(opened.page);
    assert.deepEqual(opened.complaints, []);
  } finally {
    await opened.close();
  }
}

export const desk = { width: 940, height: 900 };
export const phone = { width: 390, height: 844, touch: true, scheme: 'dark' };
export const state = (page) => page.evaluate(() => structuredClone(window.part.state));

// The pictures that the canvases of a part show.
export const drawn = (page) => page.locator('canvas').evaluateAll((all) =>
  all.map((canvas) => canvas.toDataURL()));

// Fails if a part still plays: after the time for several steps it is where it was.
export async function assertStopped(page) {
  const { step } = await state(page);
  await page.waitForTimeout(400);
  assert.equal((await state(page)).step, step);
}
