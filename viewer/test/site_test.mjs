// The site of the course (make papers) in headless Chromium, from the disk: no page scrolls sideways
// on a phone or a desk, none complains or loads from elsewhere, and the search finds.

import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { complaintsOf, launch } from './browser.mjs';

const site = resolve(import.meta.dirname, process.env.SITE ?? '../../build/course');
const pages = existsSync(site)
  ? readdirSync(site, { recursive: true }).filter((name) => name.endsWith('.html')
    && name !== 'index.html' && !name.startsWith('interactive/')).sort()
  : [];
const widths = { phone: 390, desk: 1280 };
const isListing = (name) => name.startsWith('src/');  // all alike: the phone is enough
let browser;

before(async () => { browser = await launch(); });
after(() => browser.close());

// Runs `work` with a page, and fails if the browser complains of anything meanwhile.
async function withTab(options, work) {
  const context = await browser.newContext({ offline: true, ...options });
  try {
    const tab = await context.newPage(), complaints = complaintsOf(tab);
    await work(tab);
    assert.deepEqual(complaints, []);
  } finally {
    await context.close();
  }
}

// Pixels by which a page is wider than the window, or its text than its column.
const excess = (tab) => tab.evaluate(() => Math.max(
  ...[document.documentElement, document.querySelector('.content')].map(
    (box) => box.scrollWidth - box.clientWidth)));

const open = (tab, name) => tab.goto(`file://${site}/${name}`);

for (const [device, width] of Object.entries(widths)) {
  test(`no page scrolls sideways on a ${device}`, { timeout: 3600000 }, async () => {
    assert.ok(pages.length > 50, `no site in ${site}: make papers`);
    await withTab({ viewport: { width, height: 800 } }, async (tab) => {
      const wide = [];
      for (const name of pages.filter((name) => device === 'phone' || !isListing(name))) {
        await open(tab, name);
        const pixels = await excess(tab);
        if (pixels > 0) wide.push(`${name}: ${pixels} pixels too wide`);
      }
      assert.deepEqual(wide, []);
    });
  });
}

test('a page that is too wide is found', async () => {
  await withTab({ viewport: { width: widths.phone, height: 800 } }, async (tab) => {
    await open(tab, 'README.html');
    await tab.evaluate(() => document.querySelector('article').insertAdjacentHTML('beforeend',
      '<div style="width: 1000px">wide</div>'));
    assert.ok(await excess(tab) > 500);
  });
});

test('an error on the console, a warning there and a file that is missing are found', async () => {
  const wrong = {
    'an error': () => console.error('an error'),
    'a warning': () => console.warn('a warning'),
    'missing.png': () => new Promise((done) => {
      Object.assign(new Image(), { onerror: done, src: 'missing.png' });
    }),
  };
  for (const [words, act] of Object.entries(wrong)) {
    await assert.rejects(withTab({}, async (tab) => {
      await open(tab, 'README.html');
      await tab.evaluate(act);
    }), new RegExp(words));
  }
});

test('the search finds a lesson from the disk, and leads to it', { timeout: 300000 }, async () => {
  await withTab({ viewport: { width: widths.desk, height: 800 } }, async (tab) => {
    await open(tab, 'lessons/0-why.html');
    await tab.locator('.sidebar-search').fill('persistence');
    await tab.locator('.sidebar-search').press('Enter');
    const found = tab.locator('#search-results a', { hasText: 'Lesson 4' });
    await found.click();
    assert.match(tab.url(), /lessons\/4-morse-smale\.html/);
  });
});

test('previous and next lead through the lessons', { timeout: 300000 }, async () => {
  await withTab({ viewport: { width: widths.phone, height: 800 } }, async (tab) => {
    await open(tab, 'lessons/0-why.html');
    for (const number of [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]) {
      await tab.locator('a.next-page').click();
      assert.match(tab.url(), new RegExp(`lessons/${number}-`));
    }
    await tab.locator('a.prev-page').click();
    assert.match(tab.url(), /lessons\/9-/);
  });
});

test('the page turns dark when the browser asks, and when its switch is used', async () => {
  const dark = (tab) => tab.evaluate(() => {
    const [red, green, blue] = getComputedStyle(document.body).backgroundColor.match(/\d+/g);
    const drawing = document.querySelector('article img[src$=".svg"]');
    return Number(red) + Number(green) + Number(blue) < 150
      && getComputedStyle(drawing).filter.includes('invert');
  });
  const viewport = { width: widths.desk, height: 800 };
  await withTab({ viewport, colorScheme: 'dark' }, async (tab) => {
    await open(tab, 'lessons/1-skin.html');
    assert.ok(await dark(tab));
  });
  await withTab({ viewport, colorScheme: 'light' }, async (tab) => {
    await open(tab, 'lessons/1-skin.html');
    assert.ok(!await dark(tab));
    const toggle = tab.locator('.theme-toggle-content button');
    for (let i = 0; i < 2 && !await dark(tab); ++i) await toggle.click();
    assert.ok(await dark(tab));
  });
});

test('formulas are set in their own font', async () => {
  await withTab({ viewport: { width: widths.desk, height: 800 } }, async (tab) => {
    await open(tab, 'lessons/5-creep.html');
    assert.ok(await tab.evaluate(async () => {
      await document.fonts.ready;
      return document.fonts.check('16px KaTeX_Math') && [...document.fonts].some(
        (font) => font.family === 'KaTeX_Math' && font.status === 'loaded');
    }));
  });
});
