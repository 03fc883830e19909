// Draws papers/figures/play-NAME.png, what a page shows of an interactive part where it cannot run:
//
//     node papers/interactive/pictures.mjs FOLDER_OF_BUILT_PARTS [NAME ...]

import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { launch, open } from '../../viewer/test/browser.mjs';

// The views that the lessons show, where a page has several.
const views = { viewer: '#colouring=kind&section=1&cut=1' };
const figures = new URL('../figures/', import.meta.url).pathname;
const [folder, ...names] = process.argv.slice(2);
const all = readdirSync(folder).filter((file) => file.endsWith('.html')).map((file) => file.slice(0, -5));
const browser = await launch();
for (const name of names.length ? names : all) {
  const { page, close } = await open(browser, resolve(folder, `${name}.html`) + (views[name] ?? ''), { width: 820, height: 560 });
  await page.screenshot({ path: `${figures}play-${name}.png` });
  await close();
}
await browser.close();
