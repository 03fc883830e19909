// Small helpers to build the panel, and the interactive parts of the course.

export function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

// Of SVG.
export function shape(tag, attributes = {}, ...children) {
  return filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function filled(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, '');
    else if (value !== false && value != null) made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child != null));
  return made;
}

// Drawn, because not every machine has a font with these signs.
const shapes = {
  fit: 'M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3M8 6v4M6 8h4',
  theme: 'M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11',
  help: 'M5.5 6a2.5 2.5 0 1 1 3.6 2.2C8.3 8.7 8 9.1 8 10M8 12.4v.2',
  picture: 'M2.5 4h11v8.5h-11zM2.5 10.5l3-3 2.5 2.5 2-2 3.5 3',
  link: 'M6.5 9.5l3-3M7 5l1.5-1.5a2.5 2.5 0 0 1 4 4L11 9M9 11l-1.5 1.5a2.5 2.5 0 0 1-4-4L5 7',
  panel: 'M2.5 3.5h11v9h-11zM10 3.5v9',
  fold: 'M4 6l4 4 4-4',
  play: 'M5.5 3.5v9l7-4.5z',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
};

export const icon = (name) => shape('svg', { viewBox: '0 0 16 16', class: `shape shape-${name}`,
  'aria-hidden': 'true' }, shape('path', { d: shapes[name] }));

export const number = (n) => n.toLocaleString('en');

// How many of what: 1 atom, 2 atoms.
export const counted = (n, one) => `${number(n)} ${n === 1 ? one : `${one}s`}`;

// Shows on a button that plays something whether it runs, and what a press does. Only a change is
// shown: a sign put anew in every frame would go from under the pointer, and its click with it.
export function showPlaying(button, isPlaying, [run, stop], key) {
  const words = isPlaying ? stop : run;
  if (button.getAttribute('aria-label') === words) return;
  button.setAttribute('aria-label', words);
  button.title = `${words} (${key})`;
  button.replaceChildren(icon(isPlaying ? 'pause' : 'play'));
}

// A row of buttons of which one is pressed.
export function choice(label, options, now, pick) {
  const buttons = options.map(([value, text, key]) =>
    element('button', { type: 'button', 'aria-pressed': String(value === now), 'data-value': value,
      title: key ? `${text} (${key})` : text, onclick: () => pick(value) }, text));
  const row = element('div', { class: 'choice', role: 'group', 'aria-label': label }, ...buttons);
  row.show = (value) => buttons.forEach((button) =>
    button.setAttribute('aria-pressed', String(button.dataset.value === value)));
  return row;
}

// A layer's switch: a checkbox, swatches, a name and how many there are.
export function toggle({ id, label, key, colours = [], count, title, change }) {
  const box = element('input', { type: 'checkbox', id, onchange: () => change(box.checked) });
  const row = element('label', { class: 'toggle', for: id, title: title ?? (key && `Key ${key}`) },
    box, element('span', { class: 'name' }, label),
    ...colours.map((colour) => element('i', { class: 'dot', style: `background:${colour}` })),
    element('span', { class: 'count' }, count ?? ''));
  row.box = box;
  row.count = row.querySelector('.count');
  return row;
}

export function section(title, ...children) {
  return element('section', {}, element('h2', {}, title), ...children);
}

// Bars over a scale: how many in each of its equal parts; a single one of many shows too.
// words: what is heard in their place.
export function histogram(counts, words) {
  const most = Math.max(...counts);
  const height = (count) => (count > 0 ? `max(1px, ${100 * count / most}%)` : '0');
  return element('div', { class: 'histogram', role: 'img', title: words, 'aria-label': words },
    ...counts.map((count) => element('i', { style: `height:${height(count)}` })));
}
