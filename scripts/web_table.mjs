#!/usr/bin/env node
// The figures of docs/how-to/browser.md, as tables:  scripts/web_table.mjs sizes | speed | bytes
// Build the targets `web` and `restrip_program` of the preset release first. `speed` and `bytes` are measured in headless
// Chromium ($CHROMIUM, else chromium).
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { Browser } from '../tests/web/browser.mjs';

const root = fileURLToPath(new URL('../', import.meta.url));
const folder = join(root, 'build/release/web');
const grouped = (n) => Math.round(n).toLocaleString('en');
const table = (rows) => console.log([rows[0], rows[0].map(() => '---'), ...rows.slice(1)].map((row) => `| ${row.join(' | ')} |`).join('\n'));
const policies = ['local', 'linked', 'quick', 'full'];

async function inChromium(code, argument) {
  const browser = await Browser.start(process.env.CHROMIUM ?? 'chromium');
  try {
    const page = await browser.page(840, 520);
    await page.open(pathToFileURL(join(folder, 'viewer.html')).href);
    await page.until(() => window.restripViewer?.settled);
    return await page.run(code, argument);
  } finally {
    await browser.stop();
  }
}

function sizes() {
  const files = [['the library', 'package/restrip.wasm'], ['the same, tables up to k = 6', 'package/restrip-small.wasm'],
    ['the readers of files', 'package/restrip-readers.wasm'], ['its JavaScript', 'package/restrip.mjs'], ['the viewer, with its mesh', 'viewer.html'],
    ['the atlas: index', 'atlas/index.html'], ['the atlas: splits, k = 6, a = 3', 'atlas/split-6-3.html'], ['the painter', 'atlas/paint.html']];
  table([['', 'bytes', 'gzip', 'Brotli'], ...files.map(([what, file]) => {
    const bytes = readFileSync(join(folder, file));
    return [what, bytes.length, gzipSync(bytes, { level: 9 }).length, brotliCompressSync(bytes).length].map((n) => (typeof n === 'number' ? grouped(n) : n));
  })]);
}

async function speed() {
  const scratch = mkdtempSync(join(tmpdir(), 'restrip-web-'));
  const rows = [['policy', 'cost', 'native: ns a split, a collapse', 'Chromium', 'times native']];
  const measured = await inChromium((names) => {
    const { restrip, mesh: { points }, splits } = window.restripViewer;
    window.restripViewer.mesh.begin({ policy: 'local' });
    const mesh = restrip.progressive({ points, base: window.restripViewer.mesh.triangles, splits });
    const out = [];
    for (const cost of ['strips', 'indices'])
      for (const policy of names) {
        const [up, down] = [[], []];
        for (let repeat = 0; repeat < (policy === 'full' ? 5 : 15); ++repeat) {
          mesh.begin({ policy, cost });
          const start = performance.now();
          mesh.moveTo(mesh.levels);
          const turn = performance.now();
          mesh.moveTo(0);
          up.push(turn - start);
          down.push(performance.now() - turn);
        }
        out.push([policy, cost, Math.min(...up) * 1e6 / mesh.levels, Math.min(...down) * 1e6 / mesh.levels]);
      }
    return out;
  }, policies);
  for (const [policy, cost, up, down] of measured) {
    const report = join(scratch, 'replay.json');
    execFileSync(join(root, 'build/release/bin/restrip'), ['replay', join(folder, 'hare.pm'), '--policy', policy, '--cost', cost, '--json', report]);
    const { ns_per_operation: nativeUp, ns_per_collapse: nativeDown } = JSON.parse(readFileSync(report, 'utf8'));
    rows.push([`\`${policy}\``, cost, `${grouped(nativeUp)}, ${grouped(nativeDown)}`, `${grouped(up)}, ${grouped(down)}`,
      `${(up / nativeUp).toFixed(1)}, ${(down / nativeDown).toFixed(1)}`]);
  }
  rmSync(scratch, { recursive: true });
  table(rows);
}

async function bytes() {
  const measured = await inChromium((names) => {
    const viewer = window.restripViewer;
    const { mesh, scene } = viewer;
    const out = [];
    for (const cost of ['strips', 'indices'])
      for (const policy of cost === 'strips' ? [...names, 'baked'] : [...names, 'bare']) {
        mesh.begin({ policy, cost });
        // Under `bare`, which keeps no strips, the list with slots.
        const follow = () => {
          const ranges = policy === 'bare' ? mesh.updateList() : mesh.update();
          scene.upload(policy === 'bare' ? mesh.listIndices : mesh.indices, ranges);
        };
        follow();
        let [steps, uploaded, whole, list] = [0, 0, 0, 0];
        const step = (percent) => {
          mesh.moveTo(Math.round(mesh.levels * percent / 100));
          scene.bytesUploaded = 0;
          follow();
          ++steps;
          uploaded += scene.bytesUploaded;
          whole += scene.indices.width * (policy === 'bare' ? mesh.listIndices : mesh.indices).length;
          list += 3 * scene.indices.width * mesh.figures.triangles;
        };
        for (let percent = 1; percent <= 100; ++percent) step(percent);
        for (let percent = 99; percent >= 0; --percent) step(percent);
        out.push([policy, cost, uploaded / steps, whole / steps, list / steps]);
      }
    return out;
  }, policies);
  table([['policy', 'cost', 'bytes uploaded for 1 %', 'the whole buffer', 'a whole triangle list', 'of the list'],
    ...measured.map(([policy, cost, uploaded, whole, list]) =>
      [...(policy === 'bare' ? ['a list with slots', '–'] : [`\`${policy}\``, cost]), grouped(uploaded), grouped(whole), grouped(list), `${(100 * uploaded / list).toFixed(0)} %`])]);
}

const commands = { sizes, speed, bytes };
if (!(process.argv[2] in commands)) {
  console.error('usage: scripts/web_table.mjs sizes | speed | bytes');
  process.exit(2);
}
await commands[process.argv[2]]();
