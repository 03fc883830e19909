// The sweep and the growth, run by themselves until they end or are asked to stop.

const sweepSeconds = 18, growthSeconds = 6;

// What comes next; who starts again forgets it, or two would run at once.
let nextStep, nextFrame;

export function playSweep(viewer) {
  const { state, sweep } = viewer;
  if (state.playing) {
    viewer.set({ playing: false });
    return;
  }
  viewer.set({ playing: true, step: state.step >= sweep.steps ? 0 : state.step });
  let last = performance.now(), place = state.step;
  const tick = (now) => {
    if (!state.playing) return;
    // The time between two frames, but not more than looks smooth when frames are slow.
    place += Math.min(now - last, 250) / 1000 * sweep.steps / sweepSeconds;
    last = now;
    const isOver = place >= sweep.steps;
    viewer.set({ step: Math.min(Math.round(place), sweep.steps), playing: !isOver });
    if (!isOver) nextStep = requestAnimationFrame(tick);
  };
  cancelAnimationFrame(nextStep);
  nextStep = requestAnimationFrame(tick);
}

export function playGrowth(viewer) {
  const { state, growth: { frames: { length } } } = viewer;
  if (state.growing) {
    viewer.set({ growing: false });
    return;
  }
  viewer.set({ growing: true, frame: state.frame >= length ? 0 : state.frame });
  const pause = (1000 * growthSeconds) / length;
  const tick = () => {
    if (!state.growing) return;
    const frame = state.frame + 1;
    viewer.set({ frame, growing: frame < length });
    if (frame < length) nextFrame = setTimeout(tick, pause);
  };
  clearTimeout(nextFrame);
  nextFrame = setTimeout(tick, pause);
}
