// The interactive parts of the course: each opens from a file, loads nothing, fits a phone, and does
// by keyboard, mouse and touch what it says. Their mathematics is tested beside their sources.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { embedded } from '../../papers/interactive/embedded.mjs';
import { fingers, settle } from './browser.mjs';
import { assertStopped, desk, drawn, parts, phone, state, withPart } from './interactive.mjs';

test('every part is shown by a lesson, and the viewer opens there as its link says', async () => {
  const shown = embedded();
  for (const name of parts) assert.ok(shown.some(({ part }) => part === name), name);
  const viewers = shown.filter(({ part }) => part === 'viewer');
  assert.ok(viewers.length >= 6);
  for (const { lesson, state: hash } of viewers) {
    await withPart('viewer', { width: 736, height: 640 }, async (page) => {
      const now = await page.evaluate(() => window.viewer.state);
      for (const [name, word] of new URLSearchParams(hash.slice(1))) {
        const told = typeof now[name] === 'boolean' ? Number(now[name]) : now[name];
        assert.equal(String(told), word, `${lesson}: ${name}`);
      }
      if (now.step < await page.evaluate(() => window.viewer.sweep.steps)) {
        const bridges = await page.evaluate(() => window.viewer.sweep.counts()[3]);
        assert.deepEqual(bridges, { now: 1, all: 2 }, `${lesson}: the step is before the second bridge`);
      }
    }, hash);
  }
});

for (const name of parts) {
  test(`${name} opens with a question, fits a phone and is worked without a pointer`, async () => {
    await withPart(name, phone, async (page) => {
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
      const answers = page.locator('.question button');
      const replies = new Set();
      for (let k = 0; k < await answers.count(); ++k) {
        await answers.nth(k).tap();
        replies.add(await page.locator('.reply').textContent());
      }
      assert.ok(replies.size === await answers.count() && replies.size >= 2);
      assert.equal([...replies].filter((reply) => reply.startsWith('Right')).length, 1);
      const heights = await page.locator('button, select, input[type=range]').evaluateAll((list) =>
        list.filter((e) => e.offsetParent).map((e) => e.getBoundingClientRect().height));
      assert.ok(Math.min(...heights) >= 30, `${heights}`);
      // Everything that can be taken hold of is reached with the tabulator.
      const count = await page.evaluate(() => [...document.querySelectorAll(
        'button:not(:disabled), select, input, [tabindex="0"]')].filter((e) => e.getClientRects().length).length);
      const reached = new Set();
      for (let k = 0; k < count + 2; ++k) {
        await page.keyboard.press('Tab');
        reached.add(await page.evaluate(() => [...document.querySelectorAll('*')].indexOf(document.activeElement)));
      }
      assert.ok(reached.size >= count, `${reached.size} of ${count}`);
    });
  });
}

test('the reader finds where two discs part, with the arrow keys alone', async () => {
  await withPart('skin2d', desk, async (page) => {
    const disc = page.locator('[aria-label^="Disc 2"]');
    await disc.focus();
    const curves = () => page.evaluate(() => window.part.parts().loops.length);
    while (await curves() === 1) await page.keyboard.press('ArrowRight');
    while (await curves() === 2) await page.keyboard.press('Shift+ArrowLeft');
    assert.match(await page.locator('main').textContent(), /Found: √w₁ \+ √w₂ = 2\.828/);
  });
});

test('a disc follows the mouse and a finger to the end', async () => {
  await withPart('skin2d', desk, async (page) => {
    const box = await page.locator('[aria-label^="Disc 1"] circle').last().boundingBox();
    await page.mouse.move(box.x + 5, box.y + 5);
    await page.mouse.down();
    await page.mouse.move(box.x - 60, box.y + 40, { steps: 3 });
    await page.mouse.up();
    const [x, y] = (await state(page)).discs[0].z;
    assert.ok(x < -1.5 && y < -0.3, `${x}, ${y}`);
  });
  await withPart('skin2d', phone, async (page) => {
    const disc = page.locator('[aria-label^="Disc 1"] circle').last();
    await disc.scrollIntoViewIfNeeded();
    const box = await disc.boundingBox(), touch = await fingers(page);
    const [was] = (await state(page)).discs, at = [box.x + 5, box.y + 5];
    await touch('touchStart', at);
    for (let k = 1; k < 9; ++k) await touch('touchMove', [at[0] - 5 * k, at[1] - 12 * k]);
    await touch('touchEnd');
    const [now] = (await state(page)).discs;
    assert.ok(now.z[0] < was.z[0] - 0.7 && now.z[1] > was.z[1] + 1.7, `${was.z} became ${now.z}`);
  });
});

test('a finger on a disc or a solid does not scroll the page, beside them it does', async () => {
  for (const [name, held] of [['skin2d', '[aria-label^="Disc 1"] circle >> nth=-1'],
    ['certificate', 'canvas'], ['front', 'canvas'], ['guard', 'canvas >> nth=0']]) {
    await withPart(name, { ...phone, height: 500 }, async (page) => {
      const touch = await fingers(page);
      await page.evaluate(() => { document.body.style.paddingBottom = '500px'; }); // room to scroll
      // By how much the page scrolls when a finger goes up from the middle of something.
      const scrolled = async (place) => {
        await place.evaluate((e) => e.scrollIntoView({ block: 'center' }));
        const { x, y, width, height } = await place.boundingBox();
        const at = [x + width / 2, y + height / 2], top = () => page.evaluate(() => window.scrollY);
        const was = await top();
        await touch('touchStart', at);
        for (let k = 1; k < 9; ++k) await touch('touchMove', [at[0], at[1] - 10 * k]);
        await touch('touchEnd');
        await settle(page);
        return await top() - was;
      };
      assert.equal(await scrolled(page.locator(held)), 0, name);
      assert.ok(await scrolled(page.locator('p.soft').first()) > 30, name);
    });
  }
});

test('an edge and a triangle redden where [L] and [U] break', async () => {
  await withPart('sizes', desk, async (page) => {
    const verdict = () => page.locator('table').last().textContent();
    assert.match(await verdict(), /kept.*kept/);
    await page.locator('[aria-label^="Corner 3"]').focus();
    for (let k = 0; k < 12; ++k) await page.keyboard.press('ArrowUp');
    assert.match(await verdict(), /too large/);
    for (let k = 0; k < 44; ++k) await page.keyboard.press('ArrowDown');
    await page.locator('[aria-label^="Corner 2"]').focus();
    for (let k = 0; k < 26; ++k) await page.keyboard.press('ArrowLeft');
    assert.match(await verdict(), /too short/);
    await page.locator('input[aria-label=Q]').fill('1.5');
    assert.match(await page.locator('table').first().textContent(), /may not end: needs Q > 1\.583/);
  });
});

test('the mesh is proved until it is spoiled, and each spoil names its condition', async () => {
  await withPart('certificate', desk, async (page) => {
    const press = (name) => page.getByRole('button', { name, exact: true }).click();
    const said = () => page.locator('main').textContent();
    assert.match(await said(), /Proved homeomorphic to the skin, with its vertices on it/);
    for (const [name, words] of [['turn it round', /run along it the same way/], ['drop it', /is open/],
      ['cover twice', /\(c3\) covers the skin oncebroken/], ['all inside out', /\(c1\)[^(]*broken/],
      ['drop its component', /1 components, the skin has 2/], ['move the vertex out', /off the skin/]]) {
      await press(name);
      assert.match(await said(), words, name);
      await press('undo');
      assert.match(await said(), /with its vertices on it/);
    }
    const pictures = await drawn(page), { chosen } = await state(page);
    await page.locator('canvas').click({ position: { x: 260, y: 300 } });
    assert.notEqual((await state(page)).chosen, chosen, 'a click chooses a triangle');
    pictures.push(...await drawn(page));
    await page.locator('canvas').focus();
    await page.keyboard.press('ArrowLeft');
    pictures.push(...await drawn(page));
    await page.emulateMedia({ colorScheme: 'dark' });
    await settle(page);
    pictures.push(...await drawn(page));
    assert.equal(new Set(pictures).size, 4, 'another triangle, another side, another colour');
  });
});

test('the front is followed step by step, with the line of Algorithm 1 lit', async () => {
  await withPart('front', desk, async (page) => {
    const lit = () => page.locator('pre .lit').allTextContents();
    const press = (name) => page.getByRole('button', { name, exact: true }).click();
    const step = async () => (await state(page)).step;
    const [bowls, , , bridges, seals] = await page.evaluate(() => window.part.done);
    assert.deepEqual([bowls, bridges, seals], [2, 2, 2], 'as the answer to the question says');
    assert.deepEqual(await lit(), ['   creation() at every minimum']);
    for (const [name, words] of [['creep', /12 .*creep/], ['wing', /wing\(\)/], ['bridge', /5 .*bridge/],
      ['seal', /seal/]]) {
      const before = await step();
      await press(name);
      assert.ok(await step() > before, name);
      assert.match((await lit()).join(), words);
    }
    const sealed = await step();
    await press('‹ step');
    assert.equal(await step(), sealed - 1);
    await press('step ›');
    assert.equal(await step(), sealed);
    await page.locator('input[aria-label=Step]').press('End');
    assert.match(await page.locator('main').textContent(), /no front/);
    await press('play');
    await page.waitForFunction(() => window.part.state.step > 3 && window.part.state.step < 700);
    await press('pause');
    await assertStopped(page);
    const { laid, milliseconds } = await page.evaluate(async () => {
      const play = [...document.querySelectorAll('button')].find((b) => b.textContent === 'play');
      const start = performance.now(), from = window.part.state.step;
      for (let k = 0; k < 5; ++k) play.click();
      await new Promise((resolve) => { setTimeout(resolve, 400); });
      play.click();
      return { laid: window.part.state.step - from, milliseconds: performance.now() - start };
    });
    assert.ok(laid > 0 && laid <= 3 + milliseconds / 40,
      `a short pause makes it no faster: ${laid} steps in ${milliseconds} ms`);
    await assertStopped(page);
  });
});

test('the sweep without the guard stops where it lays a triangle over another, the other one closes', async () => {
  await withPart('guard', desk, async (page) => {
    const press = (name) => page.getByRole('button', { name, exact: true }).click();
    const laid = () => page.evaluate(() => window.part.laid());
    const notes = () => page.locator('.halves p').allTextContents();
    const { apart, first } = await state(page);
    assert.deepEqual(await laid(), [apart, apart]);
    assert.deepEqual((await notes()).map((text) => /None lies over/.test(text)), [true, true]);
    await press('first overlap');
    assert.deepEqual(await laid(), [first, first]);
    assert.match((await notes())[1], new RegExp(`Stopped. Triangle number ${first} \\(red\\) lies over`));
    const pictures = [await drawn(page)];
    await page.getByText('close up').click();
    pictures.push(await drawn(page));
    await page.locator('canvas').first().focus();
    await page.keyboard.press('ArrowLeft');
    pictures.push(await drawn(page));
    for (const k of [0, 1]) {
      assert.equal(new Set(pictures.map((both) => both[k])).size, 3, 'both come nearer and turn');
    }
    await press('to the end');
    const [whole, stopped] = await laid();
    assert.ok(whole > first && stopped === first);
    assert.match((await notes())[0], /no front: closed. None lies over/);
    await page.getByText('let the second go on').click();
    assert.ok((await laid())[1] > whole, 'it covers the skin more than once');
    assert.match((await notes())[1], /goes on over finished triangles/);
    await page.getByText('let the second go on').click();
    assert.deepEqual(await laid(), [whole, first]);
    const { step } = await state(page);
    await press('one triangle less');
    assert.equal((await state(page)).step, step - 1);
    await press('one triangle more');
    assert.equal((await state(page)).step, step);
    await press('where they part');
    assert.deepEqual(await laid(), [apart, apart]);
    await press('play');
    await page.waitForFunction((n) => window.part.laid()[0] > n, first + 30);
    assert.equal((await laid())[1], first);
    await press('pause');
    await assertStopped(page);
  });
});
