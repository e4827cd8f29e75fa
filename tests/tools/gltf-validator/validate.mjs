// validate.mjs FOLDER FILE…: prints the result of the validator in FOLDER/node_modules for each GLB, as a line of JSON.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {resolve} from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(resolve(folder, 'package.json'))('gltf-validator');
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {format: 'glb', maxIssues: 0});
  const {numErrors, numWarnings, messages, truncated} = report.issues;
  console.log(JSON.stringify({version: report.validatorVersion, errors: numErrors, warnings: numWarnings, truncated, messages}));
}
