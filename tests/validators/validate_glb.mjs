// SPDX-License-Identifier: Apache-2.0
// Runs the Khronos glTF validator on files. Exits 1 on any error or warning; infos are printed.
import { readFile } from 'node:fs/promises';
import process from 'node:process';

const severityNames = ['error', 'warning', 'info', 'hint'];

// Texture coordinates are written for textures that users add, so materials without a texture do not use them. The
// validator does not know the two extensions of these files, nor that instancing uses accessors.
const isExpected = ({ code, pointer }, isInstanced) =>
  code === 'UNSUPPORTED_EXTENSION' ||
  (code === 'UNUSED_OBJECT' && /\/TEXCOORD_\d+$/.test(pointer ?? '')) ||
  (code === 'UNUSED_OBJECT' && isInstanced && /^\/accessors\/\d+$/.test(pointer ?? ''));

const validator = await import('gltf-validator').catch(() => {
  console.error(`gltf-validator is not installed; run 'npm ci' in ${import.meta.dirname ?? 'tests/validators'}`);
  process.exit(1);
});

async function validate(file) {
  const report = await validator.default.validateBytes(new Uint8Array(await readFile(file)), {
    uri: file,
  });
  const { issues, info } = report;
  const isInstanced = info?.extensionsUsed?.includes('EXT_mesh_gpu_instancing') ?? false;
  const unexpected = issues.messages.filter((issue) => !isExpected(issue, isInstanced));
  for (const { severity, code, message, pointer } of unexpected) {
    console.log(`${file}: ${severityNames[severity]}: ${code}: ${message} (${pointer ?? 'file'})`);
  }
  return issues.numErrors + issues.numWarnings === 0;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node validate_glb.mjs FILE...');
  process.exit(1);
}
let valid = true;
for (const file of files) {
  const good = await validate(file).catch((error) => {
    console.log(`${file}: error: ${error.message ?? error}`);
    return false;
  });
  valid &&= good;
}
console.log(`${files.length} files, ${valid ? 'all valid' : 'not all valid'}`);
process.exit(valid ? 0 : 1);
