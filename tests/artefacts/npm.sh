#!/usr/bin/env bash
# The npm package, installed into an empty folder: its example on Node 18 to 22, TypeScript with strict checks, and a bundle that
# runs in a worker.
#   npm.sh TARBALL MESH   in an empty folder
set -euo pipefail
npm init -y >/dev/null
npm install --silent "$1" typescript@5 @types/node esbuild >/dev/null
cp node_modules/restrip-wasm/example.mjs .
for version in 18 20 22; do
  npm exec --silent --yes --package="node@$version" -- sh -c "node --version | grep -q '^v$version[.]' && node example.mjs '$2'" |
    sed 's/, [0-9]* ms,/,/' >"printed-$version"
  cmp "printed-$version" printed-18
done
grep -q 'strips kept' printed-18
cat >worker.mts <<'END'
import { parentPort } from 'node:worker_threads';
import address from 'restrip-wasm/restrip.wasm';
import { load } from 'restrip-wasm';
const restrip = await load(new URL(address, import.meta.url));
const mesh = restrip.mesh({ points: new Float32Array(12), triangles: [0, 1, 2, 2, 1, 3] }).begin();
mesh.update();
const indices: number[] = Array.from(mesh.indices);
parentPort?.postMessage(indices);
END
npx tsc --strict --noEmit --target es2022 --module nodenext --moduleResolution nodenext worker.mts
npx esbuild worker.mts --bundle --platform=node --format=esm --loader:.wasm=file --outfile=bundle/worker.mjs --log-level=error
cat >main.mjs <<'END'
import { Worker } from 'node:worker_threads';
const indices = await new Promise((done, fail) => new Worker(new URL('bundle/worker.mjs', import.meta.url)).once('message', done).once('error', fail));
const strip = indices.filter((index) => index !== 0xffffffff);
if (strip.length !== 4 || new Set(strip).size !== 4) throw new Error(`the worker made ${indices}`);
END
node main.mjs
echo "npm.sh: all is well"
