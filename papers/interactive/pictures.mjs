// Draws papers/figures/play-NAME.png, what a page shows of an interactive part where it cannot run, as
// the lessons name them, each with the state in its link:
//
//     node papers/interactive/pictures.mjs FOLDER_OF_BUILT_PARTS [NAME ...]

import { resolve } from 'node:path';
import { launch, open } from '../../viewer/test/browser.mjs';
import { embedded } from './embedded.mjs';

const figures = new URL('../figures/', import.meta.url).pathname;
const [folder, ...names] = process.argv.slice(2);
const browser = await launch();
for (const { picture, part, state } of embedded()) {
  if (names.length && !names.includes(picture)) continue;
  const { page, close } = await open(browser, resolve(folder, `${part}.html`) + state, { width: 820, height: 560 });
  await page.screenshot({ path: `${figures}play-${picture}.png` });
  await close();
}
await browser.close();
