// The part of the course where pairs of critical points are cancelled, worked by mouse and keys.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { desk, state, withPart } from './interactive.mjs';

test('pairs are cancelled by a click or by keys, and a refusal says why', async () => {
  await withPart('morse', desk, async (page) => {
    const press = (name) => page.getByRole('button', { name, exact: true }).click();
    const said = () => page.locator('.said').textContent();
    const sum = () => page.locator('p.value').textContent();
    const hills = /^5 minima − 9 saddles \+ 4 maxima = 0$/;
    assert.match(await sum(), hills);
    const met = await page.evaluate(() => {
      const press = (name) => [...document.querySelectorAll('button')].find((b) => (b.ariaLabel ?? b.textContent) === name).click();
      return window.part.state.complex.arcs.map((_, n) => {
        for (let k = 0; k <= n; ++k) press('next line');
        press('cancel it');
        const said = document.querySelector('.said').textContent;
        press('start again');
        return said;
      });
    });
    for (const reason of [/^Cancelled a saddle and a minimum/, /^Refused. c is (higher|lower) than b/, /^Refused. Another saddle of b/]) {
      assert.ok(met.some((said) => reason.test(said)), `${reason}`);
    }
    await page.getByRole('button', { name: 'next line' }).press('Enter');
    assert.match(await said(), /^From saddle a at /);
    await page.getByRole('button', { name: 'cancel it' }).press('Enter');
    assert.equal(await said(), met[0]);
    await press('start again');
    assert.match(await sum(), hills);
    // A click in the middle of a line tries that line.
    const target = await page.evaluate(() => {
      const { complex } = window.part.state, n = complex.arcs.findIndex(({ line, own }) =>
        line[own >> 1].every((c) => c > 0.1 && c < 0.9));
      return { n, at: complex.arcs[n].line[complex.arcs[n].own >> 1], saddle: complex.arcs[n].saddle };
    });
    const box = await page.locator('svg').first().boundingBox();
    await page.mouse.click(...[target.at[0], 1 - target.at[1]].map((c, k) =>
      [box.x, box.y][k] + ((c + 0.06) / 1.12) * box.width));
    const after = await state(page);
    assert.ok(after.chosen === target.n || after.complex.cancelled.at(-1)?.saddle === target.saddle);
    await press('start again');
    while (await page.getByRole('button', { name: 'cancel the least persistent' }).isEnabled()) {
      await press('cancel the least persistent');
      assert.match(await said(), /^Cancelled/);
    }
    assert.match(await sum(), /^1 minimum − 2 saddles \+ 1 maximum = 0$/);
    await press('next line');
    await press('cancel it');
    assert.match(await said(), /Both lines of the saddle a end at this/);
    assert.equal(await page.locator('.tasks .good').count(), 4);
    await press('start again');
    assert.match(await sum(), hills);
    await page.locator('.pair').first().press('Enter');
    assert.match(await said(), /^(Cancelled|No line joins)/);
    await press('One hill');
    assert.match(await sum(), /^1 minimum − 2 saddles \+ 1 maximum = 0$/);
    assert.match(await said(), /^Click a line/);
    await press('next line');
    await press('cancel it');
    assert.match(await said(), /Both lines/);
  });
});

test('as printed, only loops are refused, and the page says when no function has what is left', async () => {
  await withPart('morse', desk, async (page) => {
    await page.getByText('as printed').click();
    // Whichever line may go goes, the last first.
    const said = await page.evaluate(() => {
      const press = (name) => [...document.querySelectorAll('button')].find((b) => (b.ariaLabel ?? b.textContent) === name).click();
      const words = [];
      for (let k = 0; k < 40 && !document.querySelector('p.value').textContent.includes('no function'); ++k) {
        press('line before');
        press('cancel it');
        words.push(document.querySelector('.said').textContent);
      }
      return words;
    });
    for (const words of said) assert.match(words, /^(Cancelled|Refused. Both lines)/);
    assert.match(await page.locator('main').textContent(), /no function has this complex/);
  });
});
