// Colours, as [r, g, b] from 0 to 255.

export const hex = ([r, g, b]) =>
  '#' + [r, g, b].map((x) => Math.round(x).toString(16).padStart(2, '0')).join('');

export const red = [214, 64, 58];
export const blue = [56, 112, 214];
export const green = [44, 152, 84];
export const plain = [196, 201, 208];

// By dimension of the mixed cell's simplex.
export const kinds = [[236, 190, 92], [78, 158, 196], [120, 180, 110], [205, 104, 92]];

// Creation, creep, wing, bridge, seal.
export const operations = [[214, 64, 58], [178, 190, 206], [242, 178, 62], [124, 88, 190],
  [44, 152, 84]];

export const elements = {
  H: [236, 236, 236], C: [150, 152, 158], N: [66, 110, 220], O: [220, 60, 52], S: [232, 196, 60],
  P: [240, 140, 50], F: [120, 205, 120], CL: [70, 190, 80], BR: [160, 70, 50], I: [130, 60, 160],
  FE: [205, 110, 60], ZN: [125, 128, 176], MG: [90, 170, 70], CA: [110, 150, 110],
  NA: [150, 100, 220], K: [150, 80, 200],
};
export const otherElement = [216, 130, 190];

// Six places of viridis (Smith and van der Walt, CC0), straight in between.
export const scaleColours = [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132],
  [122, 209, 81], [253, 231, 37]];

export function gradient(x) {
  const at = Math.min(Math.max(x, 0), 1) * (scaleColours.length - 1);
  const i = Math.min(Math.floor(at), scaleColours.length - 2), share = at - i;
  return scaleColours[i].map((a, k) => a + share * (scaleColours[i + 1][k] - a));
}

// A colour for the n-th of many things, far from those of its neighbours in number: hues a golden
// section apart, in three lightnesses.
export function categorical(n) {
  const hue = (n * 0.618034 + 0.58) % 1, lightness = [0.62, 0.5, 0.74][n % 3];
  const a = 0.5 * Math.min(lightness, 1 - lightness);
  return [0, 8, 4].map((k) => {
    const t = (k + hue * 12) % 12;
    return 255 * (lightness - a * Math.max(-1, Math.min(t - 3, 9 - t, 1)));
  });
}
