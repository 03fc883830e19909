// Makes dist/viewer.html, the one file that the command puts its data into: the page with its style
// and its script, three.js in it, and the licence of what is not ours. With --check it only says
// whether that file is up to date.

import { build } from 'esbuild';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';

const here = (name) => new URL(name, import.meta.url).pathname;

const { outputFiles } = await build({
  entryPoints: [here('src/main.js')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'none',
  charset: 'utf8',
  write: false,
});
const { version } = JSON.parse(readFileSync(here('node_modules/three/package.json'), 'utf8'));
const licence = readFileSync(here('node_modules/three/LICENSE'), 'utf8').trim();
// A script inside a page ends at the first thing that looks like its end.
const script = outputFiles[0].text.replaceAll('</script', '<\\/script').trim();
const style = readFileSync(here('src/style.css'), 'utf8').trim();
// Functions, because in a text $ has a meaning.
const page = readFileSync(here('src/page.html'), 'utf8')
  .replace('@STYLE@', () => style)
  .replace('@SCRIPT@', () => `/*\nThis script contains three.js ${version}.\n\n${licence}\n*/\n${script}`);
for (const mark of ['@ABOUT@', '@DATA@']) {
  if (page.split(mark).length !== 2) throw new Error(`${mark} must stand once in the page`);
}
if (/(src|href)="https?:/.test(page)) throw new Error('the page loads something from elsewhere');
if (process.argv.includes('--check')) {
  if (readFileSync(here('dist/viewer.html'), 'utf8') === page) process.exit(0);
  console.error('viewer/dist/viewer.html is not what its sources make; run make viewer-asset');
  process.exit(1);
}
mkdirSync(here('dist'), { recursive: true });
writeFileSync(here('dist/viewer.html'), page);
console.log(`viewer/dist/viewer.html: ${page.length} characters, three.js ${version}`);
