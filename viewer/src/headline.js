// Numbers in words, and what stands under the title: counts, and whether the mesh is certified.

import { counted, element, number } from './dom.js';

/** { chain: ["A"], waters: true } as "chain A, waters". */
function selectionWords(selection) {
  return Object.entries(selection).map(([name, value]) => {
    const words = name.replaceAll('_', ' ');
    return value === true ? words : `${words} ${[value].flat().join(' ')}`;
  }).join(', ');
}

// A number's text with the sign for minus that is as wide as the one for plus; no -0.
export const signed = (text) => (Number(text) === 0 ? text.replace('-', '') : text.replace(/^-/, '−'));

// A or A^2, as it is printed.
export const inPrint = (unit) => unit.replace('A', 'Å').replace('^2', '²');

// The decimals of places in what reaches so far, at least as many as given: a tiny thing has more.
export const decimals = (least, reach) =>
  Math.max(least, Math.min(2 - Math.floor(Math.log10(reach || 1)), 100));

// A level of the Morse function.
export function levelInWords(value, scene) {
  const { low, high } = scene.functionRange(), { unit } = scene.page.about.function;
  return `${signed(value.toFixed(decimals(2, high - low)))} ${inPrint(unit)}`;
}

export function headline(about) {
  const lines = [`${counted(about.mesh.triangles, 'triangle')}, ${number(about.mesh.vertices)} vertices`];
  if (about.atoms) lines.push(`${counted(about.atoms, 'atom')}, model ${about.model}`);
  if (about.selection) lines.push(`chosen: ${selectionWords(about.selection)}`);
  if (Number.isFinite(about.min_angle_deg)) lines.push(`smallest angle ${about.min_angle_deg.toFixed(2)}°`);
  return lines.join(' · ');
}

export function certificateLine(about) {
  if (about.certified === undefined) return null;
  return about.certified
    ? element('details', { class: 'certified' },
      element('summary', {}, 'Certified: homeomorphic, sizes and angles as claimed'),
      element('p', { class: 'note' }, 'Proved from the mesh as it is written, rounding counted: it is a closed surface that a ',
        'continuous motion of space carries onto the skin, with every component and no other; its vertices lie on the skin; ',
        '[U] and the claimed angles hold for every triangle. “morskin check” proves it again.'))
    : element('p', { class: 'uncertified' }, `Not certified: ${about.reason}`);
}
