// The keyboard. The same table makes the help.

export const keys = [
  ['Click', 'what is there: triangle, vertex, atom'],
  ['1 2 3 4', 'surface smooth, flat, wire, off'],
  ['C', 'next colour (Shift: the one before)'],
  ['E', 'triangles’ sides'],
  ['X', 'see through'],
  ['A', 'atoms'],
  ['K', 'critical points'],
  ['L', 'integral lines'],
  ['S', 'protecting spheres'],
  ['I', 'simplified complex'],
  ['M', 'mixed cells, cut by the plane'],
  ['U', 'cut the surface'],
  ['[ ]', 'move the plane'],
  ['V', 'the Morse function: direction or centre, and level'],
  ['Space', 'run the sweep'],
  [', .', 'one step back, on (Shift: a hundredth)'],
  ['G', 'let it grow'],
  ['Arrows', 'turn'],
  ['+ −', 'nearer, farther'],
  ['F', 'look at all of it'],
  ['D', 'dark or light'],
  ['P', 'panel'],
  ['H', 'this help'],
];

const switches = { e: 'edges', x: 'seeThrough', a: 'atoms', k: 'points', l: 'lines', s: 'spheres',
  i: 'simplified', m: 'section', u: 'cut', v: 'level', p: 'panel' };
const styles = { 1: 'smooth', 2: 'flat', 3: 'wire', 4: 'off' };

export function listen(viewer) {
  const turn = 0.09, help = document.getElementById('help');
  const acts = {
    arrowleft: () => viewer.stage.turn(-turn, 0),
    arrowright: () => viewer.stage.turn(turn, 0),
    arrowup: () => viewer.stage.turn(0, turn),
    arrowdown: () => viewer.stage.turn(0, -turn),
    '+': () => viewer.stage.zoom(1 / 1.12),
    '=': () => viewer.stage.zoom(1 / 1.12),
    '-': () => viewer.stage.zoom(1.12),
    f: () => viewer.stage.fit(),
    d: () => viewer.turnTheme(),
    h: () => viewer.toggleHelp(),
    '?': () => viewer.toggleHelp(),
    c: (event) => viewer.nextColouring(event.shiftKey ? -1 : 1),
    ' ': () => viewer.togglePlay(),
    g: () => viewer.toggleGrowth(),
    '[': () => viewer.section && viewer.set({ offset: Math.max(-1, viewer.state.offset - 0.02) }),
    ']': () => viewer.section && viewer.set({ offset: Math.min(1, viewer.state.offset + 0.02) }),
    ',': () => step(-1),
    '.': () => step(1),
    '<': () => leap(-1),
    '>': () => leap(1),
    // Comma and full stop with Shift on most keyboards of Europe.
    ';': () => leap(-1),
    ':': () => leap(1),
  };
  const leap = (way) => viewer.sweep && step(way * Math.ceil(viewer.sweep.steps / 100));
  const step = (by) => viewer.sweep && viewer.goTo(viewer.state.step + by);

  window.addEventListener('keydown', (event) => {
    // Many keyboards have brackets with Alt, or with AltGr, which may count as Ctrl and Alt.
    const isTyped = event.altKey && (event.key === '[' || event.key === ']');
    if (event.metaKey || ((event.ctrlKey || event.altKey) && !isTyped)) return;
    const key = event.key.toLowerCase();
    // What lies behind the help is out of reach: the keys that opened it close it, no other acts.
    if (help.open && key !== 'h' && key !== '?') return;
    // Sliders, lists and buttons keep the keys that work them.
    const { target } = event;
    const isOnControl = target.matches?.('input, select, button, summary');
    if (isOnControl && (key.startsWith('arrow') || key === ' ')) return;
    if (target.matches?.('select') && key.length === 1) return;
    if (styles[key]) {
      viewer.set({ style: styles[key] });
    } else if (switches[key]) {
      const id = switches[key];
      if (id !== 'panel' && !viewer.panel.rows[id]) return;
      viewer.set({ [id]: !viewer.state[id] });
    } else if (acts[key]) {
      acts[key](event);
    } else {
      return;
    }
    event.preventDefault();
  });
}
