// What the tests of the viewer share: pages of molecules, made anew, and a browser to open them.
//
//   MORSKIN=path/to/it     the command to make pages with (default ../build/morskin)

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { launch, open, settle } from './browser.mjs';
import { compare, difference } from './pictures.mjs';

export const root = new URL('../..', import.meta.url).pathname;
export const morskin = process.env.MORSKIN ?? join(root, 'build/morskin');
export const molecules = join(root, 'bench/molecules');
export const folder = mkdtempSync(join(tmpdir(), 'morskin-viewer-'));
let browser;

export const make = (name, ...words) => {
  const path = join(folder, `${name}.html`);
  const isMesh = words.some((word) => word.endsWith('.ply')) && !words.includes('--against');
  const model = isMesh ? [] : ['--model', 'paper'];
  execFileSync(morskin, ['view', ...model, ...words, '-o', path, '-q']);
  return path;
};
export const pages = {};

before(async () => {
  browser = await launch();
  pages.ligand = make('ligand', join(molecules, '5tmn_ligand.pdb'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

// The canvas alone, for letters differ from machine to machine, and small.
export const stage = (page) => page.locator('#stage').screenshot();

export const small = { width: 760, height: 400, scale: 0.5 };

export async function withPage(file, options, work) {
  const opened = await open(browser, file, options);
  try {
    await work(opened.page);
    assert.deepEqual(opened.complaints, []);
  } finally {
    await opened.close();
  }
}

// Does something and says how much of the picture it changed.
export async function change(page, act) {
  const old = await stage(page);
  await act();
  await settle(page);
  return difference(old, await stage(page));
}

export const check = (page, id) => page.locator(`#${id}`).evaluate((box) => box.click());
export const picture = async (page, name) => {
  const wrong = compare(name, await stage(page));
  assert.equal(wrong, null);
};
