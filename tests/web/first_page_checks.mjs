// Claims about the first page: its hare is drawn in strips, follows the slider and turns, with the figures of the package;
// without WebGL or JavaScript the picture is there instead. Code in the documents has the text of its document, coloured
// in light and dark so that it can be read, and a button that copies it. What is wrong for readers of all abilities is
// what accessible.mjs finds.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { faultsOf } from './accessible.mjs';

export async function firstPageHolds(browser, folder, scratch) {
  const address = (page) => pathToFileURL(join(folder, page)).href;
  const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
  const hare = (await load(readFileSync(join(folder, 'package/restrip.wasm')))).baked(readFileSync(join(folder, 'hare.baked'))).begin();
  for (const [width, height, dark] of [[1280, 800, false], [390, 844, true]]) {
    const page = await browser.page(width, height, { dark });
    await page.open(address('index.html'));
    await page.until(() => window.restripHare?.settled);
    const drawn = () => page.run(() => {
      const pixels = restripHare.pane.scene.pixels();
      const seen = pixels.filter((_, i) => i % 4 === 0 && (pixels[i] !== pixels[0] || pixels[i + 1] !== pixels[1])).length;
      return { seen, sum: pixels.reduce((all, n, i) => (all * 31 + n * i) % 1000003, 7), text: document.getElementById('level-text').textContent };
    });
    const first = await drawn();
    await page.run(() => {
      const slider = document.getElementById('level');
      slider.value = slider.max;
      slider.dispatchEvent(new Event('input'));
    });
    await page.until(() => restripHare.settled);
    const finest = await drawn();
    await page.run(() => document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' })));
    await page.until(() => restripHare.settled);
    const turned = await drawn();
    hare.begin();
    for (const [level, { text, seen }] of [[Math.round(0.1 * hare.levels), first], [hare.levels, finest]]) {
      hare.moveTo(level);
      const { triangles, strips } = hare.figures;
      const [shown, drawnStrips, each] = text.replaceAll(',', '').match(/\d+(\.\d+)?/g).map(Number);
      assert.deepEqual([shown, drawnStrips, each], [triangles, strips, +(hare.plainIndices / triangles).toFixed(2)]);
      assert.ok(seen > 8000, `${seen} pixels of the hare`);
    }
    assert.ok(first.sum !== finest.sum && turned.sum !== finest.sum && turned.text === finest.text);
    assert.deepEqual(await faultsOf(page), []);
    assert.equal(await page.run('document.documentElement.scrollWidth'), width);
    writeFileSync(join(scratch, `first-${width}.png`), await page.screenshot());
    const blocks = await page.run(() => [...document.querySelectorAll('pre')].map((block) => block.textContent));
    const readme = [...readFileSync(new URL('../../README.md', import.meta.url), 'utf8').matchAll(/^```\w*\n([^]*?)^```$/gm)].map(([, code]) => code);
    assert.deepEqual(blocks.map((text) => text.trimEnd()), readme.map((text) => text.trimEnd()));
    const colours = await page.run(() => new Set([...document.querySelectorAll('pre span')].map((word) => getComputedStyle(word).color)).size);
    assert.ok(colours >= 5, `${colours} colours of code`);
    const copied = await page.run(async () => {
      let text = null;
      navigator.clipboard.writeText = async (given) => { text = given; };
      document.querySelectorAll('.copy')[1].click();
      await null;
      return [text, document.querySelectorAll('.copy').length];
    });
    assert.deepEqual(copied, [blocks[1], blocks.length]);
    assert.deepEqual(page.faults, []);
  }
  const still = () => [document.getElementById('still').checkVisibility() && document.getElementById('still').naturalWidth === 1200, document.getElementById('live').checkVisibility()];
  const flat = await browser.page(900, 600);
  await flat.send('Page.addScriptToEvaluateOnNewDocument', { source: 'HTMLCanvasElement.prototype.getContext = () => { window.asked = true; return null; };' });
  await flat.open(address('index.html'));
  await flat.until(() => window.asked && document.getElementById('live').hidden);
  const plain = await browser.page(900, 600, { scripts: false });
  await plain.open(address('index.html'));
  assert.deepEqual([await flat.run(still), await plain.run(still)], [[true, false], [true, false]]);
  assert.deepEqual(flat.faults, []);
}
