// The button that plays a part, in a page of stubs.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { player } from '../common.js';

// An element that remembers what a click does.
function stub() {
  return { append() {}, setAttribute() {}, addEventListener(_, listener) { this.click = listener; } };
}

function played(steps) {
  globalThis.document = { createElement: stub };
  const state = { step: 0, isPlaying: false };
  const play = player(state, 40, () => { if (state.step >= steps) state.step = 0; },
    () => ++state.step < steps);
  return { state, play };
}

test('a part that is stopped and started again at once plays no faster', () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const { state, play } = played(1000);
  for (let click = 0; click < 9; ++click) play.click();
  assert.ok(state.isPlaying && play.textContent === 'pause');
  const before = state.step;
  for (let k = 0; k < 10; ++k) mock.timers.tick(40);
  assert.equal(state.step, before + 10);
  mock.timers.reset();
});

test('a part plays to its end, and from the start when it is asked again', () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const { state, play } = played(3);
  play.click();
  for (let k = 0; k < 5; ++k) mock.timers.tick(40);
  assert.deepEqual([state.step, state.isPlaying, play.textContent], [3, false, 'play']);
  play.click();
  assert.equal(state.step, 1);
  play.click();
  for (let k = 0; k < 5; ++k) mock.timers.tick(40);
  assert.deepEqual([state.step, play.textContent], [1, 'play']);
  mock.timers.reset();
});
