// GLB files of `mesh` before the validator of the Khronos Group, which writes glTF's specification.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { molecules, morskin } from './pages.mjs';

async function report(molecule, ...words) {
  const folder = mkdtempSync(join(tmpdir(), 'morskin-gltf-'));
  try {
    const file = join(folder, 'm.glb');
    execFileSync(morskin, ['mesh', join(molecules, molecule), '-q', '-o', file, ...words]);
    return await validator.validateBytes(new Uint8Array(readFileSync(file)));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

for (const words of [[], ['--vertex-data', 'all']]) {
  test(`glTF's validator finds nothing in a GLB file ${words.join(' ')}`, async () => {
    const { issues, info } = await report('caffeine.xyz', ...words);
    assert.deepEqual(issues.messages, []);
    assert.ok(info.totalTriangleCount > 1000);
  });
}
