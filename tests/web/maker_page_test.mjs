// The page "Make a rule" in headless Chromium. The hexagon fan is drawn from nothing, by the mouse: an outline of six
// corners, a vertex, three flips. It is generated and verified; its files are those of the program. A changed rule is
// refused, with the world that breaks it and by the verifier. The downloaded header and the code that the page shows are
// compiled: the table has a rule for each case that the page counts, and is applied to a mesh. A mistake in the typed
// file is shown at its place. A link leads back to the operation. A family shows its positions, and work is stopped.
// Vertices are dragged by mouse and touch. The page is accessible, from telephones to desktops, in light and dark, and
// has at most 500 KB in gzip.
//   node maker_page_test.mjs WEB_FOLDER CHROMIUM RESTRIP_GENERATE COMPILER SCRATCH; screenshots are written into SCRATCH
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { faultsOf } from './accessible.mjs';
import { Browser } from './browser.mjs';

const [folder, chromium, generate, compiler, scratch] = process.argv.slice(2);
const root = fileURLToPath(new URL('../../', import.meta.url));
rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
const address = pathToFileURL(join(folder, 'maker.html')).href;
assert.ok(gzipSync(readFileSync(join(folder, 'maker.html')), { level: 9 }).length <= 500_000);

const browser = await Browser.start(chromium);
try {
  const page = await browser.page(1200, 900);
  await page.open(address);
  const text = (id) => page.run((name) => document.getElementById(name).textContent, id);
  const done = () => page.until(() => window.restripMaker?.working === false && /verified|Stopped|Not an/.test(document.getElementById('state').textContent));
  const picture = async (name) => {
    const height = await page.run('document.documentElement.scrollHeight');
    await page.send('Emulation.setDeviceMetricsOverride', { width: 1200, height, deviceScaleFactor: 1, mobile: false });
    writeFileSync(join(scratch, `${name}.png`), await page.screenshot());
  };
  /// A click at the middle of what is drawn.
  const middle = (on, selector) => on.run((where) => {
    const element = document.querySelector(where);
    element.scrollIntoView({ block: 'center' });
    const numbers = (element.getAttribute('d') ?? '').match(/-?[\d.]+/g)?.map(Number);
    const box = element.getBoundingClientRect();
    if (!numbers) return [box.x + box.width / 2, box.y + box.height / 2];
    const mean = (from) => numbers.filter((_, i) => i % 2 === from).reduce((sum, c, _, all) => sum + c / all.length, 0);
    const { x, y } = new DOMPoint(mean(0), mean(1)).matrixTransform(element.getScreenCTM());
    return [x, y];
  }, selector);
  const mouse = (type, [x, y]) => page.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1 });
  const click = async (selector) => {
    const at = await middle(page, selector);
    await mouse('mousePressed', at);
    await mouse('mouseReleased', at);
  };
  const press = (selector) => page.run((where) => document.querySelector(where).dispatchEvent(new MouseEvent('click', { bubbles: true })), selector);
  const choose = (id, value) => page.run((name, to) => {
    document.getElementById(name).value = to;
    document.getElementById(name).dispatchEvent(new Event('change'));
  }, id, value);
  await done();
  assert.match(await text('state'), /^✓ verified in .*: 7 cases, 7 rules, never more strips than before/);

  // ---- draw from nothing
  await choose('corners', '6');
  await click('#draw-before [data-triangle="1"]');
  for (const edge of ['a c', 'a d', 'a e']) await click(`#draw-before [aria-label="flip the edge ${edge}"]`);
  await choose('name', 'drawn-hexagon');
  await choose('give_up', 'all');
  await done();
  assert.match(await text('state'), /^✓ verified in .*: 2040 cases, 306 rules/);
  const operation = await page.run('document.getElementById("text").value');
  assert.deepEqual(new Set(JSON.parse(operation).before.map((t) => [...t].sort().join(''))), new Set(['abm', 'bcm', 'cdm', 'dem', 'efm', 'afm']));
  await picture('drawn');

  // ---- take it: the files of the program; a header that compiles
  const files = await page.run(async () => Object.fromEntries(await Promise.all([...document.querySelectorAll('#downloads a')]
    .map(async (link) => [link.download, await (await fetch(link.href)).text()]))));
  assert.equal(files['drawn-hexagon.json'], operation);
  writeFileSync(join(scratch, 'drawn-hexagon.json'), operation);
  execFileSync(generate, ['rules', '--operation', 'drawn-hexagon.json', '--out', 'rules'], { cwd: scratch });
  assert.equal(files['drawn-hexagon.cert'], readFileSync(join(scratch, 'rules/certificates/operations/drawn-hexagon.cert'), 'utf8'));
  assert.equal(files['drawn_hexagon.hpp'], readFileSync(join(scratch, 'rules/include/restrip/tables/operations/drawn_hexagon.hpp'), 'utf8'));
  writeFileSync(join(scratch, 'drawn_hexagon.hpp'), files['drawn_hexagon.hpp']);
  const [includes, ...code] = (await text('use')).split('\n\n');
  writeFileSync(join(scratch, 'use.cpp'), `${includes}
#include <cstdint>
#include <vector>
int main() {
  int valid = 0;
  for (unsigned inner = 0; inner < 64; ++inner)
    for (unsigned ports = 0; ports < 64; ++ports) valid += rule_of(restrip::tables::drawn_hexagon_rules, inner, ports).valid ? 1 : 0;
  std::printf("%d\\n", valid);
  std::vector<std::uint32_t> triangles;
  [[maybe_unused]] const std::uint32_t vertices = 7, a = 0, b = 1, c = 2, d = 3, e = 4, f = 5, m = 6;
  for (std::uint32_t i = 0; i < 6; ++i) triangles.insert(triangles.end(), {i, (i + 1) % 6, m});
  const auto upload = [](const auto&) {};
${code.join('\n')}
  std::puts(result ? "applied" : "refused");
}
`);
  execFileSync(compiler, ['-std=c++20', '-Wall', '-Wextra', '-Werror', '-I', join(root, 'tables/include'), '-I', join(root, 'runtime/include'), 'use.cpp', '-o', 'use'], { cwd: scratch });
  assert.equal(execFileSync(join(scratch, 'use'), { encoding: 'utf8' }), '2040\napplied\n');

  // ---- look, and break it: two solid ports that are not joined before are joined after
  await page.run(() => { restripMaker.case = { inner: 0, ports: 9 }; return restripMaker.look(); });
  assert.match(await text('case'), /^This rule leaves/);
  await picture('look');
  const turned = await page.run(() => [...document.querySelectorAll('#case-after [data-inner]')]
    .filter((edge) => (edge.getAttribute('aria-pressed') === 'true') !== (+edge.dataset.inner < 2)).map(({ dataset }) => dataset.inner));
  assert.ok(turned.length > 0);
  for (const edge of turned) await press(`#case-after [data-inner="${edge}"]`);
  await page.until(() => document.querySelector('#why .marked') && /^Your rule is/.test(document.getElementById('case').textContent));
  assert.match(await text('case'), /^Your rule is unsound: .*a cycle with ports 0-3 connected outside/);
  assert.ok(await page.run('document.querySelectorAll("#why .outside").length') > 0);
  await page.run(() => document.getElementById('judge').click());
  await page.until(() => /^NOT verified/.test(document.getElementById('broken').textContent));
  assert.match(await text('broken'), /NOT verified: drawn-hexagon\.json: [^]*✗ [^]*rules\.cert:\d+: "(rule|copy) 9 /);
  await picture('broken');
  await page.run(() => document.getElementById('repair').click());
  await page.until(() => /^This rule leaves/.test(document.getElementById('case').textContent));

  // ---- a link, and a mistake at its place
  const link = await page.run('restripMaker.link()');
  const other = await browser.page(1200, 900);
  await other.open(link);
  await other.until(() => /verified/.test(document.getElementById('state').textContent));
  assert.equal(await other.run('document.getElementById("text").value'), operation);
  assert.deepEqual(other.faults, []);
  const selected = await page.run(async (wrong) => {
    const field = document.getElementById('text');
    field.value = wrong;
    field.dispatchEvent(new Event('input'));
    for (let n = 0; n < 200 && document.getElementById('fault').hidden; ++n) await new Promise((resolve) => setTimeout(resolve, 50));
    document.querySelector('#fault button').click();
    return field.value.slice(field.selectionStart, field.selectionStart + 8);
  }, operation.replace('"give_up": "all"', '"give_up": "some"'));
  assert.match(await text('fault'), /^drawn-hexagon\.json:\d+:\d+: give_up/);
  assert.equal(selected, '"some"\n'.slice(0, 6) + selected.slice(6));

  // ---- a family: its positions, a case of one, a broken rule; then it is stopped
  await choose('example', 'family');
  await done();
  assert.match(await text('state'), /^✓ verified in .*: 35972 cases, 3471 rules/);
  assert.equal(await page.run('document.getElementById("drawing").hidden'), true);
  await choose('position', '3');
  await page.until(() => /^This rule leaves/.test(document.getElementById('case').textContent));
  assert.deepEqual(await page.run('[restripMaker.shown.operation.before.length, restripMaker.shown.operation.after.length, restripMaker.cases.length]'), [6, 4, 2040]);
  assert.match(await text('which'), /^case 2 of 2,040$/);
  assert.match(await text('use'), /position_of\(restrip::tables::my_vertex_removal_rules, \{6\}\), live\.edge\(v, u0\)/);
  await picture('family');
  await page.run(() => { restripMaker.case = { inner: 0, ports: 9 }; return restripMaker.look(); });
  const solid = await page.run(() => [...document.querySelectorAll('#case-after [data-inner][aria-pressed=true]')].map((edge) => edge.dataset.inner));
  for (const edge of solid) await press(`#case-after [data-inner="${edge}"]`);
  await page.until(() => /^Your rule is/.test(document.getElementById('case').textContent));
  await choose('example', 'family');
  await page.until(() => {  // clicks until the run, which begins a moment later, has been there to be stopped
    document.getElementById('stop').click();
    return /^Stopped/.test(document.getElementById('state').textContent);
  });

  // ---- the mouse drags a vertex; Enter in the name does not leave the page
  await choose('example', 'Face split');
  await done();
  const from = await middle(page, '#draw-after [data-vertex=m] circle');
  const was = await page.run('restripMaker.drawing.places.m');
  await mouse('mousePressed', from);
  for (const far of [10, 30]) await mouse('mouseMoved', [from[0] + far, from[1]]);
  await mouse('mouseReleased', [from[0] + 30, from[1]]);
  assert.ok((await page.run('restripMaker.drawing.places.m'))[0] > was[0] + 15);
  await page.run('document.getElementById("name").select()');
  for (const key of ['n', '4']) await page.send('Input.dispatchKeyEvent', { type: 'char', text: key });
  for (const type of ['keyDown', 'keyUp']) await page.send('Input.dispatchKeyEvent', { type, key: 'Enter', code: 'Enter', windowsVirtualKeyCode: 13, text: '\r' });
  await done();
  assert.equal(await page.run('JSON.parse(document.getElementById("text").value).name'), 'n4');

  // ---- keyboard: a flip by Enter, a vertex moved and removed
  await choose('example', 'Vertex removal');
  await done();
  const keys = await page.run(() => {
    const key = (where, name) => document.querySelector(where).dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true }));
    const [x] = restripMaker.drawing.places.m;
    key('#draw-before [data-vertex=m]', 'ArrowRight');
    const moved = restripMaker.drawing.places.m[0] - x;
    key('#draw-before [data-vertex=m]', 'Delete');
    key('#draw-after [data-flip]', 'Enter');
    return [moved, restripMaker.drawing.operation.before.length, restripMaker.drawing.operation.after.flat().join('')];
  });
  assert.deepEqual(keys.slice(0, 2), [8, 2]);
  await page.run(() => document.getElementById('undo').click());
  await done();
  assert.deepEqual(page.faults, []);

  // ---- wide and light, narrow and dark
  for (const [width, dark] of [[1280, false], [360, true]]) {
    const sized = await browser.page(width, 800, { dark });
    await sized.open(address);
    await sized.until(() => /verified/.test(document.getElementById('state').textContent) && document.getElementById('case').textContent !== '');
    assert.deepEqual(await faultsOf(sized), [], `${width} pixels wide`);
    assert.equal(await sized.run('document.documentElement.scrollWidth'), width);
    const small = await sized.run(() => [...document.querySelectorAll('button, select, summary, nav a')]
      .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44).map((element) => element.textContent || element.id));
    if (width < 800) assert.deepEqual(small, []);
    if (width < 800) {  // fingers: a vertex is dragged, an edge flipped by a tap
      const touch = (type, ...points) => sized.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
      const [x, y] = await middle(sized, '#draw-after [data-vertex=m] circle');
      await touch('touchStart', [x, y]);
      for (const far of [8, 16, 24]) await touch('touchMove', [x + far, y]);
      await touch('touchEnd');
      assert.ok(await sized.run('restripMaker.drawing.places.m[0] > 215'));
      await sized.run(() => { document.getElementById('example').value = 'Edge flip'; document.getElementById('example').onchange(); });
      const tapped = await middle(sized, '#draw-after [data-flip]');
      await touch('touchStart', tapped);
      await touch('touchEnd');
      await sized.until(() => restripMaker.past.length === 3);
    }
    writeFileSync(join(scratch, `maker-${width}.png`), await sized.screenshot());
    assert.deepEqual(sized.faults, []);
  }
} finally {
  await browser.stop();
}
console.log('drawn, proven, broken, taken');
