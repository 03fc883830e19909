import { launch, open, settle } from './test/browser.mjs';
const [file, out, opts, ...acts] = process.argv.slice(2);
const browser = await launch();
const o = await open(browser, file, JSON.parse(opts || '{}'));
console.log('ready', o.seconds, await o.page.evaluate(() => document.documentElement.dataset.ready));
for (const a of acts) { const t=Date.now(); await o.page.evaluate(a); await settle(o.page); console.log(a.slice(0,60), Date.now()-t, 'ms'); }
await o.page.screenshot({ path: out });
console.log(o.complaints);
await browser.close();
