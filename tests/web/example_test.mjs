// The example in the package's README runs as it is printed, in a page that a server gives out, and draws: at the finest
// level its picture is the same as of the triangle list, pixel for pixel, in storage that is made once, also after
// uploads of only ranges. Other levels look different. In the same page run the lines that the viewer prints.
//   node example_test.mjs WEB_FOLDER CHROMIUM
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { Browser } from './browser.mjs';
import { checkUse, gpuFlags, printed } from './use_checks.mjs';

const [folder, chromium] = process.argv.slice(2);
const inPackage = (name) => readFileSync(join(folder, 'package', name));
const about = JSON.parse(inPackage('package.json'));
const [, example] = /```js\n(.*?)```/s.exec(inPackage('README.md').toString()) ?? assert.fail('README.md has no example');
const use = printed(folder);
const imports = Object.fromEntries(Object.entries(about.exports).map(([name, to]) => [`${about.name}${name.slice(1)}`, `/package/${(to.default ?? to).slice(2)}`]));
Object.assign(imports, use.imports);
const files = new Map([
  ['/', ['text/html', `<!doctype html><meta charset="utf-8"><title>t</title><link rel="icon" href="data:,"><script type="importmap">${JSON.stringify({ imports })}</script>
    <canvas id="canvas" width="300" height="300"></canvas>`]],
  ...use.files, ['/pictures.mjs', ['text/javascript', readFileSync(new URL('pictures.mjs', import.meta.url))]],
  ['/example.mjs', ['text/javascript', example]], ['/hare.obj', ['text/plain', readFileSync(join(folder, 'hare.obj'))]],
  ...about.files.map((name) => [`/package/${name}`, [name.endsWith('.wasm') ? 'application/wasm' : 'text/javascript', inPackage(name)]])]);
const server = createServer((request, answer) => {
  const [type, content] = files.get(request.url) ?? [];
  answer.writeHead(type ? 200 : 404, { 'content-type': type ?? 'text/plain' }).end(content);
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));

const browser = await Browser.start(chromium, ...gpuFlags);
try {
  const page = await browser.page(400, 400);
  await page.open(`http://127.0.0.1:${server.address().port}/`);
  const found = await page.run(async (name) => {
    const { show } = await import('/example.mjs');
    const { differ, picture, useFlatProgram } = await import('/pictures.mjs');
    const { loadReaders } = await import(`${name}/formats`);
    const { readMesh } = await loadReaders();
    const { points, triangles } = await readMesh('hare.obj', await (await fetch('/hare.obj')).arrayBuffer());
    const gl = document.getElementById('canvas').getContext('webgl2', { antialias: false });
    useFlatProgram(gl);
    // The example and the list have separate bindings.
    const own = gl.createVertexArray();
    gl.bindVertexArray(own);
    const vertices = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(triangles), gl.STATIC_DRAW);
    const list = picture(gl, () => gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0));
    const empty = picture(gl, () => {});
    gl.bindVertexArray(null);

    const calls = { bufferData: 0, bufferSubData: 0 };
    for (const name of Object.keys(calls)) {
      const call = gl[name].bind(gl);
      gl[name] = (...given) => (++calls[name], call(...given));
    }
    const draw = await show(gl, points, triangles);
    const before = calls.bufferData;
    const coarse = picture(gl, () => draw(0));
    const grown = picture(gl, () => draw(1));
    const storages = calls.bufferData - before;
    const uploads = calls.bufferSubData;
    const lower = picture(gl, () => draw(0.9));
    const again = picture(gl, () => draw(1));
    return { list: differ(list, empty), coarse: differ(coarse, list), grown: differ(grown, list), lower: differ(lower, list), again: differ(again, list),
      storages, ranges: calls.bufferSubData - uploads, ended: calls.bufferData - before - storages, error: gl.getError() };
  }, about.name);
  assert.ok(found.list > 5000, `the list covers ${found.list} pixels`);
  assert.ok(found.coarse > 1000 && found.lower > 100, `levels look alike: ${found.coarse} and ${found.lower} pixels differ`);
  // Colours that are interpolated from another corner of a triangle may round differently.
  assert.ok(Math.max(found.grown, found.again) <= found.list / 1000, JSON.stringify(found));
  assert.equal(found.error, 0);
  assert.ok(found.storages === 1 && found.ranges > 2 && found.ended === 0, JSON.stringify(found));
  await checkUse(page);
  assert.deepEqual(page.faults, []);
} finally {
  await browser.stop();
  server.close();
}
