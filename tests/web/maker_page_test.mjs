// The page "Make a rule" in headless Chromium. A flip, a 4-to-2 and the removal of a vertex are drawn from an empty outline, by
// keyboard alone and by mouse; each is impossible at first, which is drawn, proved after the button that allows strips to be cut,
// and applied to the page's sheet. Each step can be undone and redone, and the focus stays in the drawing. The files are those of
// the program; the downloaded header and the code that the page shows are compiled and run. A changed rule is judged beside the
// best one. The address shows the operation again, in an open tab and after a reload; a damaged one says so. A mistake in the
// typed file is shown at its place; work is stopped. Vertices are dragged by mouse and touch. The page is accessible, from
// telephones to desktops, in light and dark, and has at most 580 kB in gzip.
//   node maker_page_test.mjs WEB_FOLDER CHROMIUM RESTRIP_GENERATE COMPILER LIBRARY SCRATCH; screenshots are written into SCRATCH
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { faultsOf } from './accessible.mjs';
import { Browser } from './browser.mjs';

const [folder, chromium, generate, compiler, library, scratch] = process.argv.slice(2);
const root = fileURLToPath(new URL('../../', import.meta.url));
rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
const address = pathToFileURL(join(folder, 'maker.html')).href;
assert.ok(gzipSync(readFileSync(join(folder, 'maker.html')), { level: 9 }).length <= 580_000);

/// The middle of what is drawn.
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
const said = (on, id) => on.run((name) => document.getElementById(name).textContent, id);
/// Until the programs have answered for the text that is there.
const done = (on, wanted) => on.until((words) => window.restripMaker?.working === false && new RegExp(words).test(document.getElementById('state').textContent), wanted);

const browser = await Browser.start(chromium);
try {
  const page = await browser.page(1200, 900);
  const text = (id) => said(page, id);
  const shown = (name) => page.screenshot().then((picture) => writeFileSync(join(scratch, `${name}.png`), picture));
  const mouse = (type, [x, y]) => page.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1 });
  const click = async (selector) => {
    const at = await middle(page, selector);
    await mouse('mousePressed', at);
    await mouse('mouseReleased', at);
  };
  const codes = { Tab: 9, Enter: 13, Delete: 46, ArrowRight: 39 };
  const key = async (name, modifiers = 0) => {
    const code = codes[name] ?? name.toUpperCase().charCodeAt(0);
    const character = name === 'Enter' ? '\r' : name.length === 1 && modifiers === 0 ? name : undefined;
    await page.send('Input.dispatchKeyEvent', { type: 'keyDown', key: name, windowsVirtualKeyCode: code, modifiers, text: character });
    await page.send('Input.dispatchKeyEvent', { type: 'keyUp', key: name, windowsVirtualKeyCode: code, modifiers });
  };
  const tabTo = async (selector) => {
    for (let n = 0; n < 150; ++n) {
      if (await page.run((where) => document.activeElement.matches(where), selector)) return;
      await key('Tab');
    }
    assert.fail(`Tab does not reach ${selector}`);
  };
  /// Clicks on a place of the sheet where the operation fits.
  const tryIt = async () => {
    const place = await page.run(() => {
      const svg = document.querySelector('#sheet svg');
      svg.scrollIntoView({ block: 'center' });
      const { x, y } = new DOMPoint(...restripMaker.trial.places[0].center).matrixTransform(svg.getScreenCTM());
      return [x, y];
    });
    await mouse('mousePressed', place);
    await mouse('mouseReleased', place);
  };
  const outline = async (corners) => {
    await page.run(() => document.getElementById('corners').focus());
    await key(String(corners));
    await page.until((n) => restripMaker.drawing?.operation.name === 'my-operation' && restripMaker.drawing.vertices('after').length === n, corners);
  };
  const sizes = () => page.run('[restripMaker.drawing.operation.before.length, restripMaker.drawing.operation.after.length]');
  const choose = (id, value) => page.run((name, to) => {
    document.getElementById(name).value = to;
    document.getElementById(name).dispatchEvent(new Event('change'));
  }, id, value);
  const press = (selector) => page.run((where) => document.querySelector(where).dispatchEvent(new MouseEvent('click', { bubbles: true })), selector);

  await page.open(address);
  await done(page, '^✓ proved, 25 cases');

  // ---- three operations are drawn from an empty outline, made possible, proved and tried, by keyboard alone and by mouse
  const pressed = { mouse: click, keyboard: async (selector) => {
    await tabTo(selector);
    await key('Enter');
  } };
  const tried = { mouse: tryIt, keyboard: async () => {
    await tabTo('#sheet svg');
    await key('ArrowRight');
    await key('Enter');
  } };
  const flips = (side, ...edges) => edges.map((edge) => `#draw-${side} [aria-label="flip the edge ${edge}"]`);
  const wanted = [
    { corners: 4, steps: flips('after', 'a c'), become: [2, 2], cases: '25' },
    { corners: 4, steps: ['#draw-before [data-triangle="0"]', ...flips('before', 'a c')], become: [4, 2], cases: '160' },
    { corners: 6, steps: ['#draw-before [data-triangle="1"]', ...flips('before', 'a c', 'a d', 'a e')], become: [6, 4], cases: '2,040' }];
  for (const hand of ['keyboard', 'mouse'])
    for (const { corners, steps, become, cases } of wanted) {
      await outline(corners);
      for (const selector of steps) await pressed[hand](selector);
      assert.deepEqual(await sizes(), become);
      await done(page, '^No rule: in some case');
      await page.until('document.querySelectorAll("#hindrance svg").length > 1');
      assert.ok(await page.run('document.querySelectorAll("#hindrance .solid").length > 1 && !document.getElementById("impossible").hidden && document.getElementById("take").hidden'));
      if (hand === 'keyboard') assert.ok(await page.run('document.activeElement.closest("#drawing") !== null'));
      await shown(`impossible-${become.join('-')}`);
      await pressed[hand]('#allow');
      await done(page, `^✓ proved, ${cases} cases.*at worst \\d+ strips? more`);
      assert.equal(await page.run('JSON.parse(document.getElementById("text").value).give_up'), 'all');
      await page.until('/^The best rule leaves/.test(document.getElementById("case").textContent)');
      await tried[hand]();
      await page.until('/^Applied: \\d+ → \\d+ strips/.test(document.getElementById("tried").textContent)');
      assert.ok(await page.run('restripMaker.trial.mesh.valid'));
      await shown(`tried-${become.join('-')}`);
      await pressed[hand]('#back');
      assert.match(await text('tried'), /^Undone: \d+ strips/);
    }

  // ---- undone and redone; what has the focus keeps it; a vertex moved by arrows is one step
  await outline(4);
  await pressed.keyboard('#draw-after [data-flip]');
  assert.match(await page.run('document.activeElement.getAttribute("aria-label")'), /^flip the edge (b d|d b)$/);
  await key('z', 2);
  assert.equal(await page.run('restripMaker.drawing.operation.after.flat().join("")'), 'abcacd');
  await key('z', 2 + 8);
  assert.deepEqual(await page.run('[document.getElementById("redo").disabled, restripMaker.at + 1 === restripMaker.states.length]'), [true, true]);
  await page.run(() => document.querySelector('#draw-before [data-vertex=a]').focus());
  const places = () => page.run('restripMaker.drawing.places.a[0]');
  const was = await places();
  for (let n = 0; n < 3; ++n) await key('ArrowRight');
  assert.deepEqual([await places() - was, await page.run('document.activeElement.dataset.vertex')], [24, 'a']);
  await key('z', 2);
  assert.equal(await places(), was);
  // Delete takes a vertex away.
  await click('#draw-before [data-triangle="0"]');
  await page.run(() => document.querySelector('#draw-before [data-vertex=m]').focus());
  await key('Delete');
  assert.deepEqual([await sizes(), await page.run('document.activeElement.closest("#draw-before") !== null')], [[2, 2], true]);
  await key('y', 2);  // nothing to be redone
  await key('z', 2);
  assert.deepEqual(await sizes(), [4, 2]);

  // ---- the hexagon fan again, with a name
  await outline(6);
  for (const selector of wanted[2].steps) await click(selector);
  await click('#name');
  await key('a', 2);
  for (const letter of 'hex') await key(letter);
  await key('Enter');
  await done(page, '^No rule');
  await click('#allow');
  await done(page, '^✓ proved, 2,040 cases');
  assert.match(await text('counted'), /^306 rules; \d+ claims of the verifier, of which all hold\./);
  const operation = await text('text') || await page.run('document.getElementById("text").value');
  assert.deepEqual(new Set(JSON.parse(operation).before.map((t) => [...t].sort().join(''))), new Set(['abm', 'bcm', 'cdm', 'dem', 'efm', 'afm']));
  assert.equal(JSON.parse(operation).name, 'hex');

  // ---- take it: the files of the program; a header that compiles
  const files = await page.run(async () => Object.fromEntries(await Promise.all([...document.querySelectorAll('#downloads a')]
    .map(async (link) => [link.download, await (await fetch(link.href)).text()]))));
  assert.equal(files['hex.json'], operation);
  writeFileSync(join(scratch, 'hex.json'), operation);
  execFileSync(generate, ['rules', '--operation', 'hex.json', '--out', 'rules'], { cwd: scratch });
  assert.equal(files['hex.cert'], readFileSync(join(scratch, 'rules/certificates/operations/hex.cert'), 'utf8'));
  assert.equal(files['hex.hpp'], readFileSync(join(scratch, 'rules/include/restrip/tables/operations/hex.hpp'), 'utf8'));
  writeFileSync(join(scratch, 'hex.hpp'), files['hex.hpp']);
  const [includes, ...code] = (await text('use')).split('\n\n');
  writeFileSync(join(scratch, 'use.cpp'), `${includes}
#include <cstdint>
#include <vector>
int main() {
  std::vector<std::uint32_t> triangles;
  [[maybe_unused]] const std::uint32_t vertices = 7, a = 0, b = 1, c = 2, d = 3, e = 4, f = 5, m = 6;
  for (std::uint32_t i = 0; i < 6; ++i) triangles.insert(triangles.end(), {i, (i + 1) % 6, m});
  const auto upload = [](const auto&) {};
${code.join('\n')}
  std::puts(result ? "applied" : "refused");
}
`);
  execFileSync(compiler, ['-std=c++20', '-Wall', '-Wextra', '-Werror', '-I', join(root, 'tables/include'), '-I', join(root, 'runtime/include'), 'use.cpp', library, '-o', 'use'], { cwd: scratch });
  assert.equal(execFileSync(join(scratch, 'use'), { encoding: 'utf8' }), 'applied\n');

  // ---- look, and break it: two solid ports that are not joined before are joined after
  await page.run(() => { restripMaker.case = { inner: 0, ports: 9 }; return restripMaker.look(); });
  const best = await text('case');
  const turned = await page.run(() => [...document.querySelectorAll('#case-after [data-inner]')]
    .filter((edge) => (edge.getAttribute('aria-pressed') === 'true') !== (+edge.dataset.inner < 2)).map(({ dataset }) => dataset.inner));
  assert.ok(turned.length > 0);
  for (const [n, edge] of turned.entries()) await press(`#case-${n === 0 ? 'after' : 'mine'} [data-inner="${edge}"]`);
  await page.until(() => document.querySelector('#why .marked') && /^Your rule is unsound/.test(document.getElementById('verdict').textContent));
  assert.match(await text('verdict'), /^Your rule is unsound: .*a cycle with ports 0-3 connected outside/);
  assert.deepEqual(await page.run('[document.querySelectorAll("#why .outside").length > 0, document.querySelectorAll("#case-after svg, #case-mine svg").length, document.getElementById("case").textContent === "" ]'), [true, 2, false]);
  assert.ok(best.startsWith(await text('case')));
  await page.run(() => document.getElementById('mine').scrollIntoView());
  await shown('broken');
  await click('#repair');
  await page.until(() => document.getElementById('verdict').textContent === '' && document.getElementById('mine').hidden);

  // ---- the address follows; a link in an open tab, a reload, a damaged link
  const link = await page.run('restripMaker.address().then(() => location.href)');
  await click('#gallery [value="Face split"]');
  await done(page, '^✓ proved, 7 cases.*never more strips');
  await page.run((hash) => { location.hash = hash; }, link.replace(/.*#/, '#'));
  await done(page, '^✓ proved, 2,040 cases');
  assert.equal(await page.run('document.getElementById("text").value'), operation);
  const other = await browser.page(1200, 900);
  await other.open(link);
  await done(other, '^✓ proved, 2,040 cases');
  assert.equal(await other.run('document.getElementById("text").value'), operation);
  await other.run((hash) => { location.hash = hash; }, `#operation=${link.replace(/.*#operation=/, '').slice(0, 40)}`);
  await other.until('/^The link is damaged/.test(document.getElementById("drawn").textContent)');
  assert.equal(await other.run('document.getElementById("text").value'), operation);
  assert.deepEqual(other.faults, []);

  // ---- a mistake at its place
  const selected = await page.run(async (wrong) => {
    const field = document.getElementById('text');
    field.value = wrong;
    field.dispatchEvent(new Event('input'));
    while (document.getElementById('fault').hidden) await new Promise((resolve) => setTimeout(resolve, 50));
    document.querySelector('#fault button').click();
    return field.value.slice(field.selectionStart, field.selectionStart + 6);
  }, operation.replace('"give_up": "all"', '"give_up": "some"'));
  assert.match(await text('fault'), /^hex\.json:\d+:\d+: give_up/);
  assert.equal(selected, '"some"');

  // ---- a family: its positions, a case of one; then it is stopped
  await click('#gallery [value="Family"]');
  await done(page, '^✓ proved, 35,972 cases');
  assert.equal(await page.run('document.getElementById("drawing").hidden'), true);
  await choose('position', '3');
  await page.until(() => /^The best rule leaves/.test(document.getElementById('case').textContent));
  assert.deepEqual(await page.run('[restripMaker.shown.operation.before.length, restripMaker.shown.operation.after.length, restripMaker.cases.length]'), [6, 4, 2040]);
  assert.match(await text('which'), /^case 2 of 2,040$/);
  assert.match(await text('use'), /position_of\(restrip::tables::my_vertex_removals_rules, \{6\}\), live\.edge\(v, u0\)/);
  await choose('name', 'other');
  await page.until(() => {  // clicks until the run, which begins a moment later, has been there to be stopped
    document.getElementById('stop').click();
    return /^Stopped/.test(document.getElementById('state').textContent);
  });

  // ---- the mouse drags a vertex
  await click('#gallery [value="Face split"]');
  await done(page, '^✓ proved, 7 cases');
  const from = await middle(page, '#draw-after [data-vertex=m] circle');
  const before = await page.run('restripMaker.drawing.places.m[0]');
  await mouse('mousePressed', from);
  for (const far of [10, 30]) await mouse('mouseMoved', [from[0] + far, from[1]]);
  await mouse('mouseReleased', [from[0] + 30, from[1]]);
  assert.ok(await page.run('restripMaker.drawing.places.m[0]') > before + 15);
  await click('#undo');
  assert.equal(await page.run('restripMaker.drawing.places.m[0]'), before);
  assert.deepEqual(page.faults, []);

  // ---- wide and light, narrow and dark
  for (const [width, dark] of [[1280, false], [360, true]]) {
    const sized = await browser.page(width, 800, { dark });
    await sized.open(address);
    await sized.until(() => /proved/.test(document.getElementById('state').textContent) && document.getElementById('case').textContent !== '');
    assert.deepEqual(await faultsOf(sized), [], `${width} pixels wide`);
    assert.equal(await sized.run('document.documentElement.scrollWidth'), width);
    if (width < 800) {
      const small = await sized.run(() => [...document.querySelectorAll('button, select, summary, nav a')]
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44).map((element) => element.textContent || element.id));
      assert.deepEqual(small, []);
      // Fingers: a vertex is dragged, an edge flipped by a tap.
      const touch = (type, ...points) => sized.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
      const [x, y] = await middle(sized, '#draw-after [data-vertex=a] circle');
      const start = await sized.run('restripMaker.drawing.places.a[0]');
      await touch('touchStart', [x, y]);
      for (const far of [8, 16, 24]) await touch('touchMove', [x - far, y]);
      await touch('touchEnd');
      assert.ok(await sized.run('restripMaker.drawing.places.a[0]') < start - 10);
      await touch('touchStart', await middle(sized, '#draw-after [data-flip]'));
      await touch('touchEnd');
      await sized.until(() => restripMaker.states.length === 3);
    }
    writeFileSync(join(scratch, `maker-${width}.png`), await sized.screenshot());
    assert.deepEqual(sized.faults, []);
  }
} finally {
  await browser.stop();
}
console.log('drawn, proved, broken, taken');
