// Opens pages in headless Chromium with software rendering, as a machine without a graphics card
// does, and notes everything that the browser complains about.

import { chromium } from 'playwright-core';

// Milliseconds for any one thing: a busy machine is slow, and that is no failure.
const patience = 300000;

export async function launch(...more) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--hide-scrollbars', ...more],
  });
}

// A list that grows by all that the browser complains of while a page is open: errors and warnings
// on the console, errors of scripts, what cannot be loaded and what is loaded from elsewhere.
export function complaintsOf(page) {
  const complaints = [];
  const add = (words) => complaints.push(`${page.url()}: ${words}`);
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) add(message.text());
  });
  page.on('pageerror', add);
  page.on('requestfailed', (request) => {
    // A page that is left, or a download, ends a request without a fault.
    if (request.failure().errorText !== 'net::ERR_ABORTED') add(`no ${request.url()}`);
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) add(`loads ${request.url()}`);
  });
  return complaints;
}

export async function open(browser, file, { width = 1100, height = 720, scheme = 'light',
  scale = 1, touch = false } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: scheme,
    deviceScaleFactor: scale, hasTouch: touch, offline: true });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  const complaints = complaintsOf(page);
  const start = Date.now();
  await page.goto(`file://${file}`);
  await page.waitForSelector('html[data-ready]');
  await settle(page);
  return { page, complaints, seconds: (Date.now() - start) / 1000, close: () => context.close() };
}

// Until what was asked for has been drawn, in full resolution again if it was coarser on the way.
export async function settle(page) {
  await page.waitForFunction(() => !window.viewer || window.viewer.stage.coarse === 1);
  await page.evaluate(() => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(() => {
      window.viewer?.stage.drawNow();
      window.viewer?.stage.renderer.getContext().finish();
      setTimeout(done, 30);
    }));
  }));
}

// Puts fingers on a page and lifts them: touch('touchStart', [x, y], ...), touchMove and touchEnd.
export async function fingers(page) {
  const session = await page.context().newCDPSession(page);
  return (type, ...places) => session.send('Input.dispatchTouchEvent',
    { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
}
