// Claims about the first page. At 1280 x 800 it shows, without scrolling, what a strip is, the gain in two figures,
// where the source is and what to type. Its hare fills the canvas; it is peeled into one ribbon and rolled up once, and
// not if the visitor wants no motion; then it follows the slider, with the figures of the package. The cards are drawn.
// Without WebGL or JavaScript the picture is there instead. Code in the documents has the text of its document,
// coloured in light and dark so that it can be read, and a button that copies it; documents have contents, neighbours
// and a search. What is wrong for readers of all abilities is what accessible.mjs finds.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { faultsOf } from './accessible.mjs';

export async function firstPageHolds(browser, folder, scratch) {
  const address = (page) => pathToFileURL(join(folder, page)).href;
  const compressed = gzipSync(readFileSync(join(folder, 'index.html')), { level: 9 }).length;
  assert.ok(compressed <= 330_000, `the first page has ${compressed} bytes`);
  const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')).href);
  const hare = (await load(readFileSync(join(folder, 'package/restrip.wasm')))).baked(readFileSync(join(folder, 'hare.baked'))).begin();
  const ready = () => window.restripHare?.settled && document.getElementById('card-sculpt-text') !== null && window.restripCards;
  for (const [width, height, dark] of [[1280, 800, false], [390, 844, true]]) {
    const page = await browser.page(width, height, { dark });
    await page.open(address('index.html'));
    await page.until(ready);
    const shown = () => page.run(() => {
      const { pane: { scene }, peel } = restripHare.stage;
      const pixels = scene.pixels();
      const { width, height } = scene.canvas;
      const rows = Array.from({ length: height }, (_, y) => y).filter((y) => pixels.subarray(4 * y * width, 4 * (y + 1) * width).some((c, i) => c !== pixels[i % 4]));
      return { filled: (rows.at(-1) - rows[0]) / height, sum: pixels.reduce((all, n, i) => (all * 31 + n * i) % 1000003, 7), peel,
        figures: [...document.getElementById('level-text').textContent.replaceAll(',', '').match(/\d+/g), document.getElementById('now').textContent].map(Number) };
    });
    const first = await shown();
    await page.run(() => {
      document.getElementById('level').value = document.getElementById('level').max;
      document.getElementById('level').dispatchEvent(new Event('input'));
    });
    await page.until(() => restripHare.settled);
    const finest = await shown();
    await page.run(() => document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' })));
    await page.until(() => restripHare.settled);
    assert.notEqual((await shown()).sum, finest.sum);
    hare.begin();
    for (const [level, { figures, filled, peel }] of [[Math.round(0.1 * hare.levels), first], [hare.levels, finest]]) {
      hare.moveTo(level);
      const { triangles, strips } = hare.figures;
      assert.deepEqual([figures, peel], [[triangles, strips, +(hare.plainIndices / triangles).toFixed(2)], 0]);
      assert.ok(filled > 0.85 && filled < 1, `the hare fills ${filled} of the canvas`);
    }
    const unseen = await page.run(() => ['gain', 'strip', 'get', 'canvas'].filter((id) => {
      const { top, bottom } = document.getElementById(id).getBoundingClientRect();
      return top < 0 || bottom > innerHeight;
    }));
    if (width === 1280) assert.deepEqual(unseen, [], 'below the fold');
    const tabs = await page.run(() => [...document.querySelectorAll('#get input')].map((tab) => {
      tab.click();
      return [...document.querySelectorAll('#get pre')].filter((block) => block.checkVisibility()).map((block) => block.textContent.split('\n').length);
    }));
    assert.deepEqual(tabs, [[2], [2], [2], [2]]);
    await page.run(() => document.getElementById('cards').scrollIntoView());
    await page.until(() => [...document.querySelectorAll('#cards small')].every(({ textContent }) => /^[\d,]+ triangles, 1\.\d\d indices each$/.test(textContent)));
    assert.deepEqual(await faultsOf(page), []);
    assert.equal(await page.run('document.documentElement.scrollWidth'), width);
    writeFileSync(join(scratch, `first-${width}.png`), await page.screenshot());
    assert.deepEqual(page.faults, []);
  }
  const moving = await browser.page(1280, 800, { moves: true });
  await moving.open(address('index.html'));
  await moving.until(() => window.restripHare?.stage.peel > 0.5 && /in one strip$/.test(document.getElementById('level-text').textContent));
  await moving.run(() => document.getElementById('level').dispatchEvent(new Event('input')));
  await moving.until(() => restripHare.stage.peel === 0 && /in \d+ strips$/.test(document.getElementById('level-text').textContent));
  assert.deepEqual(moving.faults, []);

  const page = await browser.page(1280, 800);
  await page.open(address('README.html'));
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

  // A document: its contents and anchors lead to its headings, its neighbours to it; the search finds a heading from two words.
  await page.open(address('docs/reference/policies.html'));
  const inside = await page.run(() => ['.contents a', 'h2 .anchor'].map((what) => [...document.querySelectorAll(what)].map((link) => link.hash)));
  assert.ok(inside[0].length > 4 && inside[0].join() === inside[1].join());
  const next = await page.run('document.querySelector(".steps [rel=next]").href');
  await page.run(() => {
    const field = document.querySelector('#search input');
    field.value = 'strips scratch';
    field.dispatchEvent(new Event('input'));
  });
  await page.until('document.querySelectorAll("#found a").length > 2');
  assert.ok(await page.run('[...document.querySelectorAll("#found a")].some(({ href }) => href.endsWith("docs/reference/policies.html#strips-from-scratch"))'));
  await page.run(() => document.querySelector('#search').requestSubmit());
  await page.until('!location.href.endsWith("policies.html") && document.readyState === "complete"');
  await page.open(next);
  assert.equal(await page.run('document.querySelector(".steps [rel=prev]").href'), address('docs/reference/policies.html'));
  assert.deepEqual(page.faults, []);

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
