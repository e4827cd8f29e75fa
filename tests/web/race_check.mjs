// Claims about the part "The race" of the viewer: after the same steps its bytes are what the package returns in Node, to the byte,
// on a processor of any speed, and a step that takes several frames counts once; the sums, the break-even and the winner on the page
// follow from these bytes for every place of the slider; both pictures show the mesh's triangles, drawn only from what
// the steps have written; what the last step has written is highlighted; a run takes its steps and ends where it began.
// The times on the page are in docs/results.md.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/// `page`: of the viewer, with the built-in mesh. The part "Ribbons" is shown again afterwards.
export async function raceHolds(page, { folder, scratch, choose, settled }) {
  await page.run(() => { location.hash = '#part=race&level=0'; });
  await page.until(() => restripViewer.part === 'race');
  await settled(page);
  const steps = [40, 41, 7683, ...Array.from({ length: 18 }, (_, n) => 7683 - 76 * (n + 1)), 1490, 1489];
  await page.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  await page.run(() => {
    for (const { pane } of restripViewer.race.tracks) pane.scene.bytesUploaded = 0;
    window.frames = 0;
    const { frame } = restripViewer.race;
    restripViewer.race.frame = function (now) { ++window.frames; return frame.call(this, now); };
  });
  for (const level of steps) {
    await page.run((to) => restripViewer.moveTo(to), level);
    await settled(page);
  }
  const { lanes, uploaded, frames } = await page.run(() => {
    const { race } = restripViewer;
    delete race.frame;
    return { uploaded: race.tracks.map(({ pane }) => pane.scene.bytesUploaded), frames: window.frames,
      lanes: Object.fromEntries(Object.entries(race.lanes).map(([way, { total }]) => [way, total])) };
  });
  await page.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  assert.ok(frames > steps.length, 'no step took more than a frame');
  const times = await page.run(() => [...document.querySelectorAll('#times tr')].map(({ cells }) => [...cells].map(({ textContent }) => textContent)));
  const measured = /^## Moving the level of detail by 1 %$([^]*?)^## /m.exec(readFileSync(new URL('../../docs/results.md', import.meta.url), 'utf8'))[1];
  const rows = ['`TriangleListBuffer`, no strips', '`local`', '`quick`', '`full`', 'from scratch: `stripify`, fast'];
  assert.deepEqual(times.map(([, ratio]) => ratio), rows.map((row) => measured.split(`\n| ${row} | `)[1].split(' | ')[1]));
  assert.deepEqual(times.map(([name]) => name), ['List with slots', ...['local', 'quick', 'full'].map((policy) => `Maintained strips, ${policy}`), 'Strips from scratch']);
  assert.ok(times[0][1] === '1.00x' && times.every(([, ratio]) => parseFloat(ratio) >= 1), `${times}`);
  const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
  const restrip = await load(readFileSync(join(folder, 'package/restrip.wasm')));
  const hare = restrip.baked(readFileSync(join(folder, 'hare.baked'))).begin({ policy: 'local' });
  const source = { points: hare.points, base: hare.triangles, splits: hare.splits };
  const width = 2;  // bytes of an index: the hare has fewer than 65,535 vertices
  const sums = Object.fromEntries(['kept', 'scratch', 'whole', 'slots'].map((way) => [way, { steps: 0, operations: 0, written: 0, drawn: 0 }]));
  const opened = (policy, n) => restrip.progressive(source).begin({ policy, cost: 'indices', form: n < 2 ? 'restart' : 'list' });
  const [keeping, renewing, placing] = ['quick', 'bare', 'bare'].map(opened);
  const written = (ranges) => ranges.reduce((sum, { count }) => sum + count, 0);
  keeping.update();
  placing.update();
  let before = 0;
  for (const level of steps) {
    for (const mesh of [keeping, renewing, placing]) mesh.moveTo(level);
    const rebuilt = renewing.fromScratch({ cost: 'indices' }).length;
    const list = 3 * placing.figures.triangles;
    const now = { kept: [written(keeping.update()), keeping.indices.length], scratch: [rebuilt, rebuilt],
      whole: [list, list], slots: [written(placing.update()), list] };
    for (const [way, [write, read]] of Object.entries(now)) {
      const { written: all, drawn, operations } = sums[way];
      sums[way] = { steps: sums[way].steps + 1, operations: operations + Math.abs(level - before), written: all + width * write, drawn: drawn + width * read };
    }
    before = level;
  }
  assert.deepEqual(lanes, sums);
  assert.deepEqual(uploaded, [sums.scratch.written, sums.kept.written]);
  assert.ok(sums.slots.written < sums.kept.written && sums.kept.written < sums.scratch.written && sums.kept.drawn < sums.slots.drawn, JSON.stringify(sums));

  // What is said: the sum at each place of the slider, and who wins. On one side of the break-even it is another one.
  const winners = new Set();
  const even = (sums.kept.written - sums.slots.written) / (sums.slots.drawn - sums.kept.drawn);
  for (const exponent of [-3, Math.log10(even) - 0.06, Math.log10(even) + 0.06, 0, 2]) {
    await page.run((value) => {
      const slider = document.getElementById('frames');
      slider.value = value;
      slider.dispatchEvent(new Event('input'));
    }, exponent);
    const found = await page.run(() => ({ frames: 10 ** document.getElementById('frames').value, text: document.getElementById('race-text').textContent,
      rows: [...document.querySelectorAll('#lanes tr')].map((row) => [row.className, ...[...row.cells].slice(1).map((cell) => cell.textContent)]) }));
    const all = Object.values(sums).map(({ written: write, drawn, steps: n }) => [write / n, drawn / n, (write + found.frames * drawn) / n]);
    const kilobytes = (n) => `${n < 1000 ? (n / 1000).toFixed(2) : n < 99950 ? (n / 1000).toFixed(1) : Math.round(n / 1000).toLocaleString('en')} kB`;
    const least = all.reduce((one, [, , sum], n) => (sum < all[one][2] ? n : one), 0);
    assert.deepEqual(found.rows, all.map((row, n) => [n === least ? 'least' : '', ...row.map(kilobytes)]));
    assert.match(found.text, least === 0 ? /^Maintained strips move the fewest bytes/ : /^Here the .* the fewest bytes/);
    winners.add(`${found.frames > even} ${least}`);
  }
  assert.deepEqual([...winners].sort(), ['false 3', 'true 0', 'true 1'], `break-even at ${even}`);
  const operations = sums.kept.operations / sums.kept.steps / even;
  assert.match(await page.run('document.getElementById("even-text").textContent'), new RegExp(`fewer than ${Math.round(operations).toLocaleString('en')} operations`));
  const marks = await page.run(() => [...document.querySelectorAll('#frames-row i')].map((mark) => {
    const [{ left, width }, row] = [mark, mark.parentElement].map((element) => element.getBoundingClientRect());
    return (left + width / 2 - row.left - 9) / (row.width - 18);
  }));
  const rebuilt = (sums.kept.written - sums.scratch.written) / (sums.scratch.drawn - sums.kept.drawn);
  for (const [n, frames] of [even, rebuilt].entries()) assert.ok(Math.abs(marks[n] - (Math.log10(frames) + 3) / 5) < 0.01, `marks at ${marks} for ${even}, ${rebuilt}`);
  for (const rival of ['scratch', 'whole', 'slots']) {
    await choose(page, { rival });
    await page.run(() => restripViewer.step(1));
    await settled(page);
    const seen = await page.run(() => restripViewer.race.tracks.map((track) => {
      const { lane, written, pane: { scene, camera, colors } } = track;
      const picture = (how) => {
        scene.draw(camera, { style: lane.isList ? 'list' : 'shaded', length: lane.length, ...colors, ...how });
        return scene.pixels();
      };
      const [own, list, lit] = [{}, { list: lane.mesh.triangles }, { glow: { triangles: written, strength: 1 } }].map(picture);
      const count = (differs) => { let sum = 0; for (let i = 0; i < own.length; i += 4) sum += differs(i) ? 1 : 0; return sum; };
      const other = (one, two, i) => one[i] !== two[i] || one[i + 1] !== two[i + 1] || one[i + 2] !== two[i + 2];
      // As it is shown, in ribbons or not, the picture has the same outline.
      track.draw(0, true);
      const ribbons = scene.pixels();
      const inside = (picture, i) => picture[i] !== picture[0] || picture[i + 1] !== picture[1] || picture[i + 2] !== picture[2];
      const card = scene.copyOnCard(lane.indices.length);
      return { different: count((i) => other(own, list, i)), shown: count((i) => inside(own, i)), outline: count((i) => inside(own, i) !== inside(ribbons, i)),
        lit: count((i) => other(own, lit, i)), same: lane.indices.every((index, i) => (index & 0xffff) === card[i]) };
    }));
    for (const { different, outline, shown, same } of seen) assert.ok(different === 0 && outline === 0 && shown > 5000 && same, `${rival}: ${JSON.stringify(seen)}`);
    const [all, some] = [seen[0].lit > 0.95 * seen[0].shown, seen[1].lit < 0.5 * seen[1].shown];
    assert.deepEqual([all, some], [rival !== 'slots', true], `${rival}: ${JSON.stringify(seen)}`);
  }
  writeFileSync(join(scratch, 'viewer-race.png'), await page.screenshot());
  await page.until(() => /part=race.*rival=slots/.test(location.hash));
  for (const [level, stride, count] of [[768, 0.01, 180]]) {
    await choose(page, { stride, level });
    await settled(page);
    await page.run(() => document.getElementById('run').click());
    await settled(page);
    assert.deepEqual(await page.run(() => [restripViewer.race.lanes.kept.total.steps, restripViewer.race.at, restripViewer.level]), [count, level, level]);
  }
  await page.run(() => { location.hash = '#part=ribbon'; });
  await page.until(() => restripViewer.part === 'ribbon');
}
