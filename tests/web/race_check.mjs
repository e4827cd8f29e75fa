// Claims about the part "The race" of the viewer: after the same steps its figures are what the package tells in Node; both
// pictures are those of the mesh's triangles, drawn from what the steps have written alone; what the last step has written is
// lit; a run takes its steps and comes back.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/// `page`: of the viewer, with the built-in mesh. The part "One ribbon" is shown again afterwards.
export async function raceHolds(page, { folder, scratch, choose, settled }) {
  await page.run(() => { location.hash = '#part=race&level=0'; });
  await page.until(() => restripViewer.part === 'race');
  await settled(page);
  const steps = [40, 41, 500, 760, 1500, 1490, 1489, 1490];
  const raced = await page.run((wanted) => {
    const { race } = restripViewer;
    for (const { pane } of race.tracks) pane.scene.bytesUploaded = 0;
    for (const level of wanted) race.step(level);
    restripViewer.moveTo(wanted.at(-1));
    return { uploaded: race.tracks.map(({ pane }) => pane.scene.bytesUploaded),
      lanes: Object.fromEntries(Object.entries(race.lanes).map(([way, { last, total, strips, indices }]) => [way, { last: last.bytes, all: total.bytes, strips, indices: indices.length }])) };
  }, steps);
  const { load, restartIndex } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
  const restrip = await load(readFileSync(join(folder, 'package/restrip.wasm')));
  const hare = restrip.baked(readFileSync(join(folder, 'hare.baked'))).begin({ policy: 'local' });
  const source = { points: hare.points, base: hare.triangles, splits: hare.splits };
  const sums = { kept: { last: 0, all: 0 }, scratch: { last: 0, all: 0 }, whole: { last: 0, all: 0 }, slots: { last: 0, all: 0 } };
  const opened = (policy) => restrip.progressive(source).begin({ policy, cost: 'indices' });
  const [keeping, renewing, rewriting, placing] = ['quick', 'bare', 'bare', 'bare'].map(opened);
  const written = (ranges) => ranges.reduce((sum, { count }) => sum + 4 * count, 0);
  keeping.update();
  placing.updateList();
  for (const level of steps) {
    for (const mesh of [keeping, renewing, rewriting, placing]) mesh.moveTo(level);
    const anew = renewing.fromScratch({ cost: 'indices' });
    const now = { kept: written(keeping.update()), scratch: anew.byteLength, whole: written(rewriting.updateList({ whole: true })), slots: written(placing.updateList()) };
    for (const [way, bytes] of Object.entries(now)) Object.assign(sums[way], { last: bytes, all: sums[way].all + bytes });
    Object.assign(sums.scratch, { strips: anew.filter((index) => index === restartIndex).length + 1, indices: anew.length });
  }
  Object.assign(sums.kept, { strips: keeping.figures.strips, indices: keeping.figures.bufferIndices });
  for (const [way, mesh] of [['whole', rewriting], ['slots', placing]]) Object.assign(sums[way], { strips: 0, indices: 3 * mesh.figures.triangles });
  assert.deepEqual(raced.lanes, sums);
  assert.deepEqual(raced.uploaded, [sums.scratch.all, sums.kept.all]);
  assert.ok(sums.kept.last < sums.scratch.last && sums.slots.last < sums.kept.last && sums.kept.indices < sums.slots.indices, JSON.stringify(sums));
  await settled(page);
  const told = await page.run(() => [...document.querySelectorAll('#lanes tr')].map((row) => [...row.cells].map((cell) => cell.textContent)));
  const kilobytes = (n) => (n < 1000 ? (n / 1000).toFixed(2) : n < 1e5 ? (n / 1000).toFixed(1) : `${Math.round(n / 1000)}`);
  for (const [n, { last, all, strips, indices }] of Object.values(sums).entries())
    assert.deepEqual([told[n][1], told[n][2], ...told[n].slice(4)], [kilobytes(last), kilobytes(all), strips ? strips.toLocaleString('en') : '–', indices.toLocaleString('en')]);
  for (const rival of ['scratch', 'whole', 'slots']) {
    await choose(page, { rival });
    await page.run(() => restripViewer.step(1));
    await settled(page);
    const seen = await page.run(() => restripViewer.race.tracks.map((track) => {
      const { lane, written, pane: { scene, camera, colors } } = track;
      const picture = (how) => {
        scene.draw(camera, { style: lane.isList ? 'list' : 'shaded', length: lane.indices.length, ...colors, ...how });
        return scene.pixels();
      };
      const [own, list, lit] = [{}, { list: lane.mesh.triangles }, { glow: { triangles: written, strength: 1 } }].map(picture);
      const count = (differs) => { let sum = 0; for (let i = 0; i < own.length; i += 4) sum += differs(i) ? 1 : 0; return sum; };
      const other = (one, two, i) => one[i] !== two[i] || one[i + 1] !== two[i + 1] || one[i + 2] !== two[i + 2];
      // As it is shown, in ribbons or not, the picture has the same outline.
      track.draw(0);
      const ribbons = scene.pixels();
      const inside = (picture, i) => picture[i] !== picture[0] || picture[i + 1] !== picture[1] || picture[i + 2] !== picture[2];
      const card = scene.copyOnCard(lane.indices.length);
      return { different: count((i) => other(own, list, i)), shown: count((i) => inside(own, i)), outline: count((i) => inside(own, i) !== inside(ribbons, i)),
        lit: count((i) => other(own, lit, i)), same: lane.indices.every((index, i) => index === card[i]) };
    }));
    for (const { different, outline, shown, same } of seen) assert.ok(different === 0 && outline === 0 && shown > 5000 && same, `${rival}: ${JSON.stringify(seen)}`);
    const [all, some] = [seen[0].lit > 0.95 * seen[0].shown, seen[1].lit < 0.5 * seen[1].shown];
    assert.deepEqual([all, some], [rival !== 'slots', true], `${rival}: ${JSON.stringify(seen)}`);
  }
  writeFileSync(join(scratch, 'viewer-race.png'), await page.screenshot());
  await page.until(() => /part=race.*rival=slots/.test(location.hash));
  await choose(page, { stride: 0 });
  await page.run(() => document.getElementById('run').click());
  await settled(page);
  assert.deepEqual(await page.run(() => [restripViewer.race.lanes.kept.total.steps, restripViewer.race.at]), [200, 1493]);
  await page.run(() => { location.hash = '#part=ribbon'; });
  await page.until(() => restripViewer.part === 'ribbon');
}
