// The viewer in headless Chromium, opened from the file system. The picture drawn from the live strips is the one drawn
// from a plain list of the mesh's triangles, but for one pixel in ten thousand (two triangles that meet at the outline
// have the same depth there, and the first one drawn wins): at several levels, under policies and costs, in the
// view-dependent modes, after 20 cuts and after a random walk of the slider. The copy of the index buffer on the
// graphics card is the live one. The live buffer does not depend on the processor's speed. The figures on the page are
// the same as from `restrip replay` for the same way. Strips in colours take one draw call. A dropped mesh is prepared
// in a worker and shown, also from gzip and with the buffers of a .gltf; a file that is not a mesh is refused with a
// sentence. Without WebGL or JavaScript, and when the context is lost, the page says so. The race holds what
// race_check.mjs says, the picture of README.md what picture_check.mjs says. Nothing is said on the console.
//   node viewer_test.mjs WEB_FOLDER CHROMIUM RESTRIP SCRATCH; screenshots are written into SCRATCH
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { checkParts } from './accessible.mjs';
import { Browser } from './browser.mjs';
import { pictureIsFresh } from './picture_check.mjs';
import { raceHolds } from './race_check.mjs';
import { checkTurn } from './turn_checks.mjs';

const [folder, chromium, program, scratch] = process.argv.slice(2);
mkdirSync(scratch, { recursive: true });
const address = pathToFileURL(join(folder, 'viewer.html')).href;

const choose = (page, choices) => page.run((wanted) => {
  for (const [id, value] of Object.entries(wanted)) {
    const element = document.getElementById(id);
    element.value = value;
    if (element.value !== String(value)) throw new Error(`${id} has no ${value}`);
    element.dispatchEvent(new Event(element.type === 'range' ? 'input' : 'change'));
  }
}, choices);
const settled = (page) => page.until(() => window.restripViewer?.settled === true);
/// How many pixels differ between strips and list, how many show the mesh, and whether the card has the live buffer.
const compare = (page) => page.run(() => {
  const viewer = window.restripViewer;
  viewer.draw({ style: 'shaded', patch: false });
  const strips = viewer.scene.pixels();
  viewer.draw({ style: 'shaded', patch: false, list: true });
  const list = viewer.scene.pixels();
  let different = 0;
  let shown = 0;
  for (let i = 0; i < strips.length; i += 4) {
    if (strips[i] !== list[i] || strips[i + 1] !== list[i + 1] || strips[i + 2] !== list[i + 2]) ++different;
    if (list[i] !== list[0] || list[i + 1] !== list[1] || list[i + 2] !== list[2]) ++shown;
  }
  const live = viewer.mesh.indices;
  const card = viewer.scene.copyOnCard(live.length);
  return { different, shown, sameBuffer: card.every((index, n) => index === (live[n] & 0xffff)), ...viewer.figures };
});
async function agrees(page, what) {
  await settled(page);
  const found = await compare(page);
  assert.ok(found.different <= found.shown / 10000, `${what}: ${found.different} of ${found.shown} pixels differ`);
  assert.ok(found.shown > 10000, `${what}: only ${found.shown} pixels show the mesh`);
  assert.ok(found.sameBuffer, `${what}: the card has another buffer`);
  return found;
}
/// The hare as a .glb file.
const glb = () => {
  const file = join(scratch, 'hare.glb');
  execFileSync(program, ['convert', join(folder, 'hare.obj'), '-o', file]);
  return file;
};
const quiet = (page) => assert.deepEqual(page.faults, []);

/// Without WebGL puzzles are solved, and the code is shown, with nothing in front of them.
async function flatParts(page) {
  await page.run(() => { location.hash = '#part=turn'; });
  await page.until(() => window.restripPlain.turn.puzzle !== null && window.restripPlain.part === 'turn');
  const solved = await page.run(() => {
    const { turn } = window.restripPlain;
    const lines = () => [...document.querySelectorAll('#turn-after .hit')];
    const wrong = lines().map((_, edge) => edge).filter((edge) => (turn.inner ^ turn.best) >> BigInt(edge) & 1n);
    const { left, top, width, height } = document.getElementById('turn-after').getBoundingClientRect();
    const front = document.elementFromPoint(left + width / 2, top + height / 2).closest('#board') !== null;
    for (const edge of wrong) lines()[edge].dispatchEvent(new MouseEvent('click', { bubbles: true }));
    return { wrong: wrong.length, front, verdict: document.getElementById('turn-verdict').textContent, fault: document.getElementById('fault').checkVisibility() };
  });
  assert.ok(solved.wrong > 0 && solved.front && !solved.fault && /^best\./.test(solved.verdict), JSON.stringify(solved));
  await page.run(() => { location.hash = '#part=use'; });
  await page.until(() => document.getElementById('part-use').checkVisibility() && !document.getElementById('fault').checkVisibility());
  assert.ok(await page.run(() => document.querySelectorAll('#part-use pre').length > 4));
  await page.run(() => { location.hash = '#part=cut'; });
  await page.until(() => document.getElementById('fault').checkVisibility());
  await page.run(() => localStorage.removeItem('restrip-solved'));  // later pages of this browser begin with the first puzzle
}

const browser = await Browser.start(chromium);
try {
  const page = await browser.page(840, 520);
  await page.open(address);
  await settled(page);
  writeFileSync(join(scratch, 'viewer.png'), await page.screenshot());
  const levels = await page.run('restripViewer.mesh.levels');

  // The page begins with the cost of indices. Its strips and its buffer have the package's numbers of indices, with an
  // update after every 64 operations, whatever number of operations fits into a frame.
  const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
  const restrip = await load(readFileSync(join(folder, 'package/restrip.wasm')));
  const stepped = restrip.baked(readFileSync(join(folder, 'hare.baked'))).begin({ policy: 'quick', cost: 'indices' });
  stepped.update();
  for (let done = 64; done === 64;) {
    done = stepped.moveTo(768, 64);
    stepped.update();
  }
  const read = () => page.run(() => ({ rows: [...document.querySelectorAll('#reads tr')].map(({ cells }) => +cells[2].textContent), buffer: restripViewer.mesh.indices.length }));
  const per = (indices) => +(indices / stepped.figures.triangles).toFixed(2);
  const expected = { rows: [3, ...[stepped.fromScratch({ cost: 'indices' }).length, stepped.plainIndices, stepped.indices.length].map(per)], buffer: stepped.indices.length };
  assert.ok(expected.rows[2] < expected.rows[3] && expected.rows[3] < 1.6, `${expected.rows}`);
  assert.deepEqual(await read(), expected);
  for (const most of [50, 5000]) {
    await page.run((most) => {
      restripViewer.begin();
      restripViewer.pace = { most, begin() {}, learn() {} };
    }, most);
    await settled(page);
    assert.deepEqual(await read(), expected, `${most} operations a frame`);
  }
  const single = async () => {
    await page.run(() => document.getElementById('single').click());
    await settled(page);
    return page.run(() => [restripViewer.figures.strips, document.getElementById('single').getAttribute('aria-pressed')]);
  };
  assert.deepEqual([await single(), await single()], [[1, 'true'], [stepped.figures.strips, 'false']]);
  writeFileSync(join(scratch, 'viewer-indices.png'), await page.screenshot());

  // Levels, policies, costs; the figures compared with the native program, which goes the same way from the base.
  let compared = 0;
  for (const [policy, cost] of [['baked', 'strips'], ['quick', 'strips'], ['quick', 'indices']]) {
    const reported = join(scratch, 'replay.json');
    execFileSync(program, ['replay', join(folder, policy === 'baked' ? 'hare.baked' : 'hare.pm'), '--policy', policy, '--cost', cost, '--repeats', '0', '--levels', '3', '--json', reported]);
    const native = JSON.parse(readFileSync(reported, 'utf8'));
    const first = native.levels[0].triangles;
    await choose(page, { level: 0, policy, cost });
    await settled(page);
    for (const level of native.levels) {
      await choose(page, { level: (level.triangles - first + 1 >> 1) });
      const found = await agrees(page, `${policy}, ${cost}, ${level.triangles} triangles`);
      const shown = await page.run(() => ['f-triangles', 'f-strips', 'f-length'].map((id) => document.getElementById(id).textContent));
      assert.deepEqual(shown, [level.triangles, level.strips, +(level.triangles / level.strips).toFixed(1)].map((n, i) => n.toLocaleString('en', { minimumFractionDigits: i === 2 ? 1 : 0 })));
      assert.equal(found.strips, level.strips);
      assert.equal(await page.run('restripViewer.mesh.plainIndices'), level.indices);
      ++compared;
    }
  }
  assert.equal(compared, 9);

  // The comparison can fail: with half of the strips missing from the card it sees that in both.
  const spoiled = await page.run(() => {
    const { scene, mesh } = window.restripViewer;
    const wrong = mesh.indices.slice();
    wrong.fill(0xffffffff, 0, wrong.length / 2);
    scene.upload(wrong, [{ first: 0, count: wrong.length }]);
  }).then(() => compare(page));
  assert.ok(spoiled.different > 0 && !spoiled.sameBuffer, `missing strips go unseen: ${spoiled.different} pixels`);
  await page.run(() => {
    const { scene, mesh } = window.restripViewer;
    scene.upload(mesh.indices, [{ first: 0, count: mesh.indices.length }]);
  });
  await agrees(page, 'mended');

  // A random walk of the slider (seed 7).
  let seed = 7;
  const random = (n) => (seed = seed * 48271 % 2147483647) % n;
  for (let i = 0; i < 5; ++i) {
    await choose(page, { level: random(levels + 1) });
    await settled(page);
  }
  const walked = await agrees(page, 'after a random walk');
  assert.ok(walked.operations > levels, `only ${walked.operations} operations`);
  assert.ok(walked.inOrder);

  await choose(page, { level: 1000 });
  await settled(page);
  // Strips in colours: one draw call, the pixels of the surface, and a colour for each strip that is seen.
  const coloured = await page.run(() => {
    const viewer = window.restripViewer;
    const gl = document.getElementById('canvas').getContext('webgl2');
    let calls = 0;
    const drawing = ['drawArrays', 'drawElements', 'drawArraysInstanced'];
    for (const name of drawing) gl[name] = (...given) => (++calls, Object.getPrototypeOf(gl)[name].apply(gl, given));
    const covered = () => {
      const pixels = viewer.scene.pixels();
      return pixels.filter((_, n) => n % 4 === 0).map((_, n) => (pixels[4 * n] !== pixels[0] || pixels[4 * n + 1] !== pixels[1] || pixels[4 * n + 2] !== pixels[2] ? 1 : 0));
    };
    viewer.draw({ style: 'strips', patch: false });
    const made = calls;
    for (const name of drawing) delete gl[name];
    const one = covered();
    viewer.draw({ style: 'shaded', patch: false, list: true });
    const other = covered();
    return { made, different: one.reduce((sum, n, i) => sum + (n !== other[i] ? 1 : 0), 0), shown: one.reduce((sum, n) => sum + n, 0),
      strips: viewer.figures.strips, ribbons: viewer.ribbon.strips.length };
  });
  assert.ok(coloured.strips > 10 && coloured.ribbons === coloured.strips && coloured.shown > 10000);
  assert.deepEqual([coloured.made, coloured.different], [1, 0]);

  // A strip keeps its colour.
  await choose(page, { policy: 'quick', cost: 'strips', level: 101 });
  await settled(page);
  const names = await page.run('[...restripViewer.ribbon.names]');
  await choose(page, { level: 100 });
  await settled(page);
  const kept = await page.run((before) => {
    const { names } = restripViewer.ribbon;
    return names.filter((name, t) => name >= 0 && name === before[t]).length / names.filter((name) => name >= 0).length;
  }, names);
  assert.ok(kept > 0.6, `${kept} of the triangles keep their colour`);
  writeFileSync(join(scratch, 'viewer-ribbon.png'), await page.screenshot());

  // Cut it: after each of 20 clicks the two new triangles are in view while the strips are cut, and not before.
  await choose(page, { policy: 'baked', level: 768 });
  await settled(page);
  const cuts = await page.run(() => {
    const viewer = window.restripViewer;
    const { width, height } = viewer.scene.canvas;
    const fresh = () => {
      const p = viewer.scene.pixels();
      let count = 0;
      for (let i = 0; i < p.length; i += 4) if (p[i] > 70 && Math.abs(p[i + 1] / p[i] - 0.76) < 0.08 && p[i + 2] / p[i] < 0.25) ++count;
      return count;
    };
    let seed = 11;
    const random = () => (seed = seed * 48271 % 2147483647) / 2147483647;
    const found = [];
    while (found.length < 20) {
      viewer.camera.place = viewer.home;
      if (!viewer.cut.click(viewer.camera.ray(2 * random() - 1, 2 * random() - 1, width / height))) continue;
      const counts = ['before', 'cut'].map((step) => {
        viewer.cut.show(step);
        viewer.draw({ now: 0 });
        return fresh();
      });
      found.push(counts);
    }
    return { found, valid: viewer.mesh.valid, clicks: viewer.clicks.length, ...viewer.mesh.figures };
  });
  const out = cuts.found.filter(([before, cut]) => before > 0 || cut < 60);
  assert.deepEqual(out, [], `${out.length} of 20 cuts are not in view`);
  assert.ok(cuts.valid && cuts.played === 768 + 20 && cuts.clicks === 20);
  assert.ok(cuts.strips <= 1 + 20 && !cuts.baked);
  await page.run(() => { location.hash = '#part=cut'; });
  await page.until(() => !document.getElementById('part-cut').hidden);
  assert.equal(await page.run('document.querySelectorAll("#steps svg .old[style]").length > 0 && document.querySelectorAll("#steps [aria-pressed=true]").length'), 1);
  writeFileSync(join(scratch, 'viewer-cut.png'), await page.screenshot());
  await page.run(() => document.querySelector('#steps [value=mended]').click());
  await agrees(page, 'after 20 cuts');
  // The link of what is seen shows the same.
  await page.until(() => location.hash.includes('cut='));
  const state = await page.run(() => ({ hash: location.hash, strips: restripViewer.figures.strips, clicks: restripViewer.clicks, place: restripViewer.camera.place }));
  const again = await browser.page(840, 520);
  await again.open(address + state.hash);
  await settled(again);
  const there = await again.run(() => ({ strips: restripViewer.figures.strips, clicks: restripViewer.clicks, yaw: restripViewer.camera.yaw, cut: !document.getElementById('part-cut').hidden }));
  assert.deepEqual([there.strips, there.clicks, there.cut], [state.strips, state.clicks, true]);
  assert.ok(Math.abs(there.yaw - state.place.yaw) < 0.01);
  quiet(again);
  await page.send('Page.bringToFront');  // a covered page does not get frames
  await page.run(() => { document.getElementById('whole').click(); location.hash = '#part=ribbon'; });
  await settled(page);
  assert.equal(await page.run('restripViewer.figures.strips'), 1);

  await raceHolds(page, { folder, scratch, choose, settled });
  await agrees(page, 'after the race');

  // View-dependent.
  for (const mode of ['cursor', 'silhouette']) {
    await page.run(() => { restripViewer.cursor = [0.1, 0]; });
    await choose(page, { level: 400, mode });
    const found = await agrees(page, mode);
    assert.ok(!found.inOrder && found.played > 500, `${mode}: ${found.played} records played`);
    writeFileSync(join(scratch, `viewer-${mode}.png`), await page.screenshot());
  }

  // One operation: its patch is marked, little is uploaded. A split that is clicked has three drawings, in the colours of the mesh, with
  // their numbers of strips, and names its rule.
  await choose(page, { mode: 'level', policy: 'local', cost: 'strips', level: 1500 });
  await settled(page);
  await page.run(() => {
    restripViewer.scene.bytesUploaded = 0;
    document.getElementById('up').click();
  });
  await settled(page);
  const one = await page.run(() => ({ operations: restripViewer.lastDone, bytes: restripViewer.scene.bytesUploaded, whole: 2 * restripViewer.mesh.indices.length, marked: restripViewer.marked?.length,
    text: document.getElementById('last-text').textContent }));
  assert.equal(one.operations, 1);
  assert.ok(one.bytes > 0 && one.bytes < one.whole / 4, `${one.bytes} of ${one.whole} bytes`);
  assert.ok(one.marked >= 3 && one.text === '');
  await page.run(() => { location.hash = '#part=cut'; });
  await page.until(() => restripViewer.part === 'cut');
  const splits = await page.run(async () => {
    const { cut, mesh } = restripViewer;
    const found = [];
    for (let n = 0; n < 8; ++n) {
      cut.anywhere();
      const { k, before, after, strips } = mesh.last;
      const counts = [...document.querySelectorAll('#steps button')].map((button) => +/(\d+) strips?$/.exec(button.textContent)[1]);
      const bits = (mask) => mask.toString(2).replaceAll('0', '').length;
      found.push({ counts, expected: [k - bits(before), k + 2 - bits(after)], drawings: document.querySelectorAll('#steps svg').length, strips,
        text: document.getElementById('last-text').textContent });
    }
    return found;
  });
  for (const { counts, expected, drawings, strips, text } of splits) {
    assert.deepEqual([counts[0], counts[2], counts.length, drawings], [...expected, 3, 3]);
    assert.ok(counts[1] > counts[0] && counts[2] - counts[0] >= strips);
    assert.match(text, /^A vertex with k = \d+ triangles\. (Repaired by its rule( split-[-\w]+)?\.|Its rule.* leaves \d+ strips? in the patch; the policy then searched further\.)$/);
  }
  assert.ok(splits.some(({ text }) => /rule split-/.test(text)));
  // The vertices that can be split are marked, and no others; at the finest level the page says that it has none.
  const dots = await page.run(() => {
    const { cut, mesh, splits: records } = restripViewer;
    cut.show('mended');
    const wanted = [...mesh.ready].filter((record) => records[4 * record + 2] !== 0xffffffff && records[4 * record + 3] !== 0xffffffff).map((record) => records[4 * record]);
    const { pane: { scene, camera, colors } } = restripViewer;
    restripViewer.camera.place = restripViewer.home;
    restripViewer.draw();
    const pixels = scene.pixels();
    let white = 0;
    for (let i = 0; i < pixels.length; i += 4) white += pixels[i] === 255 && pixels[i + 1] === 255 && pixels[i + 2] === 255 ? 1 : 0;
    return { same: [...cut.places].join() === wanted.join(), count: wanted.length, white };
  });
  assert.ok(dots.same && dots.count > 50 && dots.white > 200, JSON.stringify(dots));
  await page.run(() => restripViewer.moveTo(restripViewer.mesh.levels));
  await settled(page);
  const said = () => ({ places: restripViewer.cut.places, text: document.getElementById('cut-none').checkVisibility(), any: (restripViewer.cut.anywhere(), restripViewer.clicks.length) });
  assert.deepEqual(await page.run(said), { places: null, text: true, any: 0 });
  await page.run(() => document.querySelector('#cut-none a').click());
  await page.until('restripViewer.level === restripViewer.mesh.levels >> 1 && restripViewer.settled');
  assert.ok(await page.run('document.getElementById("cut-none").hidden && restripViewer.cut.places.length > 50'));
  await page.run(() => { location.hash = '#part=ribbon'; });
  await page.until(() => restripViewer.part === 'ribbon');

  // Baked strips and view-dependent detail exclude each other: button, address and strips say the same.
  const exclusive = () => page.run(() => [document.getElementById('policy').value, document.getElementById('mode').value,
    document.getElementById('single').getAttribute('aria-pressed'), document.getElementById('one-why').hidden, restripViewer.figures.baked]);
  await choose(page, { policy: 'baked', level: 600 });
  await settled(page);
  assert.deepEqual(await exclusive(), ['baked', 'level', 'true', false, true]);
  await choose(page, { mode: 'cursor' });
  await agrees(page, 'out of order');
  assert.deepEqual(await exclusive(), ['quick', 'cursor', 'false', true, false]);
  await choose(page, { policy: 'baked' });
  await agrees(page, 'baked again');
  assert.deepEqual(await exclusive(), ['baked', 'level', 'true', false, true]);

  // Meshes of a visitor.
  const open = (name, text) => page.run((file, content) => restripViewer.files.open(new File([content], file)), name, text);
  await open('nothing.obj', 'v 0 0 0\n');
  assert.match(await page.run('document.getElementById("fault-text").textContent'), /nothing.obj: 1 vertex but no triangles/);
  await page.run(() => document.getElementById('fault-gone').click());
  assert.ok(await page.run('document.getElementById("fault").hidden'));
  await open('own.obj', readFileSync(join(folder, 'hare.obj'), 'utf8'));
  const own = await agrees(page, 'a mesh of the visitor');
  assert.ok(own.triangles > 500);
  assert.ok(await page.run('document.getElementById("working").hidden'));
  // In gzip; a format that the page cannot unpack, and one that it does not know.
  await page.run(async (text) => {
    const packed = await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer();
    return restripViewer.files.open(new File([packed], 'packed.obj.gz'));
  }, readFileSync(join(folder, 'hare.obj'), 'utf8'));
  await page.until('restripViewer.source.name === "packed.obj" && restripViewer.settled');
  for (const [name, words] of [['hare.obj.xz', /^hare\.obj\.xz: browsers do not unpack xz/], ['hare.abc', /unknown extension '\.abc'; this page reads \.obj/]]) {
    await open(name, 'x');
    assert.match(await page.run('document.getElementById("fault-text").textContent'), words);
  }
  // A .gltf with its buffer in a file of its own.
  const binary = readFileSync(glb());
  const gltf = JSON.parse(binary.subarray(20, 20 + binary.readUInt32LE(12)).toString());
  gltf.buffers[0].uri = 'parts/hare.bin';
  await page.run(async (scene, bytes) => {
    const files = [new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], 'hare.bin'), new File([scene], 'scene.gltf')];
    const data = new DataTransfer();
    for (const file of files) data.items.add(file);
    document.querySelector('aside').dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: data }));
  }, JSON.stringify(gltf), binary.subarray(28 + binary.readUInt32LE(12)).toString('base64'));
  await page.until('restripViewer.source.name === "scene.gltf" && restripViewer.settled');
  await page.run(() => document.getElementById('fault-gone').click());
  // Dropped on the panel; the page continues while the worker is at work, and says how far it is.
  await page.run((text) => {
    const files = new DataTransfer();
    files.items.add(new File([text], 'dropped.obj'));
    const seen = window.seen = { shares: [], frames: 0 };
    const frame = () => { ++seen.frames; if (window.restripViewer.source.name !== 'dropped.obj') requestAnimationFrame(frame); };
    const watch = new MutationObserver(() => seen.shares.push(document.getElementById('progress').value));
    watch.observe(document.getElementById('progress'), { attributes: true });
    document.querySelector('aside').dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: files }));
    frame();
  }, readFileSync(join(folder, 'hare.obj'), 'utf8'));
  await page.until('restripViewer.source.name === "dropped.obj"');
  const dropped = await page.run(() => ({ shares: window.seen.shares.filter((share) => share > 0), frames: window.seen.frames }));
  assert.ok(dropped.shares.length >= 2 && dropped.frames >= 2, JSON.stringify(dropped));
  dropped.shares.reduce((before, share) => assert.ok(share >= before && share <= 1) ?? share);
  await agrees(page, 'a dropped mesh');
  assert.deepEqual(await page.run(() => [document.querySelector('[value=baked]').disabled, document.getElementById('policy').value]), [true, 'quick']);
  const openBytes = (name, bytes) => page.run((file, content) => restripViewer.files.open(new File([Uint8Array.from(atob(content), (c) => c.charCodeAt(0))], file)),
    name, bytes.toString('base64'));
  const bytes = readFileSync(join(folder, 'hare.baked'));
  await openBytes('cut.baked', bytes.subarray(0, 5000));
  assert.match(await page.run('document.getElementById("fault-text").textContent'), /^cut.baked: its checksum does not fit/);
  await openBytes('own.baked', bytes);
  await choose(page, { policy: 'baked' });
  assert.ok((await agrees(page, 'a baked mesh of the visitor')).baked);
  assert.ok(await page.run('document.getElementById("fault").hidden'));
  quiet(page);

  // The context is lost, the level moves meanwhile, and the context comes back.
  assert.match(await page.run(async () => {
    const canvas = document.getElementById('canvas');
    const event = (name) => new Promise((done) => canvas.addEventListener(name, done, { once: true }));
    const extension = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    const lost = event('webglcontextlost');
    extension.loseContext();
    await lost;
    const said = document.getElementById('fault-text').textContent;
    window.restripViewer.step(-1);
    await new Promise((done) => setTimeout(done, 100));
    const restored = event('webglcontextrestored');
    extension.restoreContext();
    await restored;
    return said;
  }), /^The browser has taken the graphics card/);
  await agrees(page, 'the context restored');
  assert.ok(await page.run('document.getElementById("fault").hidden'));
  assert.deepEqual(page.faults.filter((fault) => !/CONTEXT_LOST_WEBGL|context lost/i.test(fault)), []);

  await pictureIsFresh(browser, page, address);

  // No WebGL, and no JavaScript: a sentence and a picture.
  const still = () => [...document.images].filter((image) => image.checkVisibility() && image.naturalWidth > 100).length;
  const flat = await browser.page(900, 600);
  await flat.send('Page.addScriptToEvaluateOnNewDocument', { source: 'HTMLCanvasElement.prototype.getContext = () => null;' });
  await flat.open(address);
  await flat.until(() => !document.getElementById('fault').hidden);
  assert.match(await flat.run('document.getElementById("fault-text").textContent'), /does not offer WebGL 2/);
  assert.equal(await flat.run(still), 1);
  await flatParts(flat);
  const plain = await browser.page(900, 600, { scripts: false });
  await plain.open(address);
  writeFileSync(join(scratch, 'viewer-plain.png'), await plain.screenshot());
  assert.equal(await plain.run(still), 1);
  assert.match(await plain.run('document.getElementById("stage").innerText'), /needs JavaScript and WebGL 2/);

  // A telephone, in the dark: nothing sticks out sideways, one finger turns the mesh.
  const phone = await browser.page(400, 760, { dark: true });
  await phone.open(address);
  await settled(phone);
  assert.equal(await phone.run('document.documentElement.scrollWidth'), 400);
  const yaw = await phone.run('restripViewer.camera.yaw');
  const touch = (type, x) => phone.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y: 150 }] });
  await touch('touchStart', 100);
  await touch('touchMove', 200);
  await touch('touchEnd');
  assert.notEqual(await phone.run('restripViewer.camera.yaw'), yaw);
  await agrees(phone, 'on a telephone');
  await phone.run(() => { location.hash = '#part=ribbon'; });
  writeFileSync(join(scratch, 'viewer-phone.png'), await phone.screenshot());
  quiet(phone);

  await checkTurn(browser, address, scratch);
  await checkParts(browser, address, scratch);
} finally {
  await browser.stop();
}
