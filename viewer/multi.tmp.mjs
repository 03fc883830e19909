import { launch, open, settle } from './test/browser.mjs';
import { readFileSync } from 'node:fs';
const [file, opts, list] = process.argv.slice(2);
const browser = await launch();
const o = await open(browser, file, JSON.parse(opts || '{}'));
console.log('ready', await o.page.evaluate(() => document.documentElement.dataset.ready));
for (const [out, act] of JSON.parse(readFileSync(list))) { const t=Date.now(); await o.page.evaluate(act); await settle(o.page); const ms=Date.now()-t; await o.page.screenshot({ path: `/tmp/wt/shots/${out}.png` }); console.log(out, ms, 'ms'); }
console.log(o.complaints);
await browser.close();
