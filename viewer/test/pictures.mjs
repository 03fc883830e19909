// Pictures compared with stored ones. Software rendering gives nearly the same everywhere; what
// differs is counted, not forbidden.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';

const stored = new URL('./pictures/', import.meta.url).pathname;

// A pixel differs if a channel is off by more than this, of 255.
const tolerance = 24;
// This share of the pixels may: edges of triangles and lines fall a little differently.
const mostDifferent = 0.02;

// Nothing, or what is wrong. With UPDATE=1 in the environment the picture is stored instead.
export function compare(name, bytes) {
  const path = `${stored}${name}.png`;
  if (process.env.UPDATE || !existsSync(path)) {
    mkdirSync(stored, { recursive: true });
    writeFileSync(path, bytes);
    return process.env.UPDATE ? null : `${name}: was not stored; is now`;
  }
  const now = PNG.sync.read(bytes), then = PNG.sync.read(readFileSync(path));
  if (now.width !== then.width || now.height !== then.height) return `${name}: size differs`;
  let different = 0;
  for (let i = 0; i < now.data.length; i += 4) {
    const off = [0, 1, 2].some((k) => Math.abs(now.data[i + k] - then.data[i + k]) > tolerance);
    if (off) ++different;
  }
  const share = different / (now.width * now.height);
  if (share <= mostDifferent) return null;
  writeFileSync(`${stored}${name}.new.png`, bytes);
  return `${name}: ${(100 * share).toFixed(1)} % of the pixels differ; see ${name}.new.png`;
}

// The share of pixels in which two pictures of one size differ.
export function difference(one, other) {
  const a = PNG.sync.read(one), b = PNG.sync.read(other);
  let different = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 8)) ++different;
  }
  return different / (a.width * a.height);
}
