// What the tests of the parts' mathematics compare with: meshes and reports of the real program.
//
//   MORSKIN=path/to/it     the command (default ../../../build/morskin)

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';

export const morskin = process.env.MORSKIN ?? new URL('../../../build/morskin', import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), 'morskin-interactive-'));
after(() => rmSync(folder, { recursive: true }));

// Balls {z: [x, y, z], w}; a file that the program reads with all digits.
export function write(name, balls) {
  const path = join(folder, `${name}.xyzw`);
  writeFileSync(path, balls.map(({ z, w }) => `${[...z, w].join(' ')}\n`).join(''));
  return path;
}

export function info(balls) {
  return JSON.parse(execFileSync(morskin, ['info', write('info', balls), '--json'], { encoding: 'utf8' }));
}

// Runs `mesh`; its report, all it said, and the mesh as it was written.
export function mesh(balls, ...words) {
  const out = join(folder, 'mesh.ply');
  const done = spawnSync(morskin, ['mesh', write('mesh', balls), '-o', out, '--json', '--vertex-data',
    'normal,scale', ...words], { encoding: 'utf8' });
  if (done.status !== 0) throw new Error(done.stderr);
  return { report: JSON.parse(done.stdout), said: done.stderr, ...readPly(out) };
}

// Runs `check` on a mesh {positions, triangles} with any coordinates; its report as JSON.
export function checked(balls, mesh, ...words) {
  return report(mesh, '--against', write('check', balls), ...words);
}

// The same of the mesh alone: by name, whether each verdict holds.
export function verdicts(mesh) {
  return Object.fromEntries(report(mesh).verdicts.map(({ name, holds }) => [name, holds]));
}

function report({ positions, triangles }, ...words) {
  const out = join(folder, 'edited.off');
  writeFileSync(out, [`OFF\n${positions.length} ${triangles.length} 0`,
    ...positions.map((x) => x.join(' ')), ...triangles.map((t) => `3 ${t.join(' ')}`), ''].join('\n'));
  const done = spawnSync(morskin, ['check', out, '--json', ...words], { encoding: 'utf8' });
  if (!done.stdout.startsWith('{')) throw new Error(`${done.status}: ${done.stderr}`);
  return JSON.parse(done.stdout);
}

// The data of a part, as build.py has the program make them.
export function partData(name) {
  execFileSync('python3', [new URL('../build.py', import.meta.url).pathname, folder, name, '--command', morskin]);
  const page = readFileSync(join(folder, `${name}.html`), 'utf8');
  return JSON.parse(page.match(/id="data">(.*?)<\/script>/s)[1]);
}

const widths = { double: 8, float: 4, uchar: 1, int: 4, uint: 4 };

// A binary PLY file of doubles, as the program writes it.
function readPly(path) {
  const bytes = readFileSync(path), end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString().split('\n').map((line) => line.split(' '));
  const counts = Object.fromEntries(header.filter(([w]) => w === 'element').map(([, name, n]) => [name, Number(n)]));
  const columns = header.filter(([w, kind]) => w === 'property' && kind !== 'list').map(([, kind, name]) => ({ kind, name }));
  let at = end;
  const positions = [], normals = [], scales = [], triangles = [];
  for (let v = 0; v < counts.vertex; ++v) {
    const row = {};
    for (const { kind, name } of columns) {
      row[name] = kind === 'double' ? bytes.readDoubleLE(at) : bytes.readFloatLE(at);
      at += widths[kind];
    }
    positions.push([row.x, row.y, row.z]);
    normals.push([row.nx, row.ny, row.nz]);
    scales.push(row.length_scale);
  }
  for (let t = 0; t < counts.face; ++t) {
    triangles.push([1, 5, 9].map((k) => bytes.readInt32LE(at + k)));
    at += 13;
  }
  return { positions, normals, scales, triangles };
}
