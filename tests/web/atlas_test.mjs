// The atlas in headless Chromium. Its rules are the same as in the native dump: every valid configuration of a split
// with k <= 6 leads, by the key that the page's own script computes, to a row whose answer, moved back by the symmetry,
// costs what the library's answer costs; and each rule of each certificate, of families and operations, has its row.
// The patch drawn before has, by the library, the rule of its row. The tables are complete without JavaScript. Tables
// show all of each reason, from telephones to desktops, and are printed with all their pictures. A configuration
// painted by clicks has the answer of the library, or a reason why it is not valid, in every family; a link shows it
// again.
//   node atlas_test.mjs WEB_FOLDER CHROMIUM DUMP_TABLES SCRATCH; screenshots are written into SCRATCH
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';
import { firstPageHolds } from './first_page_checks.mjs';

const [folder, chromium, dumpProgram, scratch] = process.argv.slice(2);
const root = fileURLToPath(new URL('../../', import.meta.url));
const { load } = await import(pathToFileURL(join(folder, 'package/restrip.mjs')));
const { representative } = await import(pathToFileURL(join(root, 'web/viewer/patch.mjs')));
mkdirSync(scratch, { recursive: true });
const address = (page) => pathToFileURL(join(folder, page)).href;
const count = (mask) => mask.toString(2).replaceAll('0', '').length;

const text = (page) => readFileSync(join(folder, 'atlas', page), 'utf8');
/// The pages of a section: the one of its name, and what follows it.
const pagesOf = (page) => [page, ...readdirSync(join(folder, 'atlas')).filter((name) => name.startsWith(page.replace('.html', '-from-')))];
/// The rows of a section: by name, its rule (P J R K), and the patch drawn before it, as its position and inner edges.
const rowsOf = (page) => new Map([...pagesOf(page).map(text).join('').matchAll(/<tr id="([^"]*)" class="([^"]*)" data-rule="([^"]*)" data-before="([^"]*)"(.*)/g)]
  .map(([, name, kinds, rule, before, rest]) => [name, { kinds, rule: rule.split(' ').map(Number), before: before.split(' ').map(Number), rest }]));

// ---- rows against certificates: each rule has its row, with its answer
const families = ['split', 'collapse', 'flip'];
const operations = readdirSync(join(root, 'tables/operations')).map((name) => name.replace('.json', ''));
const counted = new Map();
for (const name of [...families, ...operations]) {
  let rows;
  let place = '';
  let left = 0;
  for (const line of readFileSync(join(root, `tables/certificates/${families.includes(name) ? '' : 'operations/'}${name}.cert`), 'latin1').split('\n')) {
    const words = line.split(' ');
    if (words[0] === 'section' || words[0] === 'end') {
      assert.equal(left, 0, `${place}: rows that no rule has`);
      if (words[0] === 'end') break;
      place = [name, ...words.filter((word) => /^\d+$/.test(word))].join('-');
      rows = rowsOf(`${place}.html`);
      left = rows.size;
    }
    if (words[0] !== 'rule') continue;
    const row = rows.get(`${place}-${words[1]}-${words[2]}`);
    assert.ok(row, `${place}: no row for ${line}`);
    assert.deepEqual(row.rule, words.slice(1, 5).map((word) => parseInt(word, 16)), line);
    counted.set(name, (counted.get(name) ?? 0) + 1);
    --left;
  }
}
assert.deepEqual(families.map((name) => counted.get(name)), [5919, 351, 9], 'the certificates have other rules; correct the numbers here');
assert.ok(operations.length >= 10 && operations.every((name) => counted.get(name) > 2));

// ---- rows against the dump
let configurations = 0;
const reached = new Set();
{
  let position = null;
  let rows;
  for (const line of execFileSync(dumpProgram, ['--max-k', '6'], { maxBuffer: 1 << 30, encoding: 'latin1' }).split('\n')) {
    const words = line.split(' ');
    if (words[0] === 'table') {
      position = words[1] === 'split' && 2 * words[5] <= +words[3] ? { k: +words[3], a: +words[5] } : null;
      if (position) rows = rowsOf(`split-${position.k}-${position.a}.html`);
      continue;
    }
    if (!position || words.length !== 6) continue;
    const [loop, ports, inner] = words.slice(0, 3).map((word) => BigInt(`0x${word}`));
    const { k, a } = position;
    const key = representative(k, a, loop, ports);
    const name = `split-${k}-${a}-${key.ports.toString(16)}-${key.joined.toString(16)}`;
    const row = rows.get(name);
    assert.ok(row, `${line}: no row ${name}`);
    assert.equal(count(row.rule[2]), count(inner), `${line}: row ${name} keeps another number of edges`);
    if (2 - count(inner) + count(loop) > 0) {
      assert.match(row.kinds, /\bcosts\b/);
      reached.add(name);
    }
    ++configurations;
  }
  assert.equal(configurations, 44 + 2 * 160 + 2 * 572 + 3 * 2040);
  for (const page of readdirSync(join(folder, 'atlas')).filter((name) => /^split-[3-6]-/.test(name)))
    for (const [name, { kinds }] of rowsOf(page)) assert.equal(/\bcosts\b/.test(kinds), reached.has(name), name);
}
console.log(`${[...counted.values()].reduce((a, b) => a + b)} rules, ${configurations} configurations`);

// ---- patches before an operation: their rules by the library
{
  const restrip = await load();
  const drawn = new Map();
  for (const page of readdirSync(join(folder, 'atlas')).filter((name) => /-\d+\.html$|^flip\.html$/.test(name) && !name.includes('-from-'))) {
    const positions = JSON.parse(/data-positions="([^"]*)"/.exec(text(page))[1].replaceAll('&quot;', '"'));
    for (const [name, { rule: [ports, , colors, kept], before: [position, edges] }] of rowsOf(page)) {
      const [family, ...words] = positions[position].split(' ');
      const [k, first, second] = words.filter((word) => /^\d+$/.test(word)).map(Number);
      const rule = restrip.rule({ family, k, ...(second === undefined && first !== undefined ? { a: first } : {}), i: first, j: second, edges, ports });
      assert.deepEqual([rule.valid, rule.colors, rule.ports], [true, BigInt(colors), BigInt(kept)], name);
      drawn.set(family, (drawn.get(family) ?? 0) + 1);
    }
  }
  assert.equal(drawn.get('split'), 5919);
  assert.equal([...drawn.values()].reduce((a, b) => a + b), families.reduce((sum, name) => sum + counted.get(name), 0));

}

const browser = await Browser.start(chromium);
try {
  // Without JavaScript: every rule of the page in words, and every link of the index leads somewhere.
  const plain = await browser.page(1100, 800, { scripts: false });
  await plain.open(address('atlas/split-8-4.html'));
  writeFileSync(join(scratch, 'atlas-plain.png'), await plain.screenshot());

  const page = await browser.page(1200, 900);
  for (const start of ['index.html', 'atlas/index.html']) {
    await page.open(address(start));
    const links = await page.run('[...document.links].map((link) => link.href).concat([...document.images].map((image) => image.src))');
    assert.ok(links.length >= 6, `${start}: ${links.length} links`);
    for (const link of links.filter((to) => to.startsWith('file:'))) assert.ok(existsSync(new URL(link.replace(/#.*/, ''))), link);
    writeFileSync(join(scratch, `${start.replace('/', '-').replace('.html', '')}.png`), await page.screenshot());
  }
  assert.equal(await page.run('document.querySelectorAll("table.index tbody tr").length'), 15 + 6 + 1 + operations.length);
  assert.equal(await page.run('document.querySelectorAll("table.index .thumb svg").length'), 2 * (15 + 6 + 1 + operations.length));

  // A link to a rule shows it, with its pictures; the filters leave what they say.
  await page.open(`${address('atlas/split-8-4.html')}#split-8-4-15-2`);
  const linked = await page.run(() => {
    const row = document.querySelector('tr:target');
    const { top, bottom } = row.getBoundingClientRect();
    return { seen: top >= 0 && bottom <= innerHeight, height: bottom - top };
  });
  assert.ok(linked.seen, 'the linked row is not in sight');
  await page.until('document.querySelectorAll("tr:target svg.patch").length === 2');
  const filtered = await page.run(() => {
    const form = document.getElementById('filter');
    form.querySelector('[name=costs]').click();
    const wanted = document.querySelector('#rules tr.costs').cells[2].textContent;
    form.ports.value = wanted;
    form.dispatchEvent(new Event('input'));
    return [...document.querySelectorAll('#rules tbody tr:not([hidden])')].map((row) => [row.className, row.cells[2].textContent, wanted]);
  });
  assert.ok(filtered.length > 0);
  for (const [kinds, ports, wanted] of filtered) {
    assert.match(kinds, /\bcosts\b/);
    assert.equal(ports, wanted);
  }
  // A long section has several pages, and a link to the first finds each rule.
  assert.ok(pagesOf('split-8-1.html').length > 1);
  for (const each of readdirSync(join(folder, 'atlas')).filter((name) => /-\d+\.html$/.test(name))) assert.ok(text(each).length < 500_000, `${each}: ${text(each).length} characters`);
  const rules = [...rowsOf('split-8-1.html').keys()];
  for (const at of [0, Math.floor(rules.length / 2), rules.length - 1]) {
    await page.open(`${address('atlas/split-8-1.html')}#${rules[at]}`);
    await page.until(`document.querySelector("tr:target")?.id === "${rules[at]}"`);
  }
  // The rules met most often come first, as met.csv has them, and filtered are those that are met.
  const met = new Map(readFileSync(join(root, 'web/atlas/met.csv'), 'latin1').trim().split('\n').slice(1).map((line) => line.split(','))
    .map(([name, ...counts]) => [name, counts.reduce((sum, n) => sum + +n, 0)]));
  await page.open(address('atlas/split-6-3.html'));
  const byMet = await page.run(() => {
    document.getElementById('often').click();
    document.querySelector('#filter [name=met]').click();
    return [...document.querySelectorAll('#rules tbody tr:not([hidden])')].map((row) => row.id);
  });
  assert.ok(byMet.length > 50, `${byMet.length} rules are met`);
  assert.deepEqual(new Set(byMet), new Set([...met.keys()].filter((name) => name.startsWith('split-6-3-'))));
  byMet.reduce((before, name) => assert.ok(met.get(before) >= met.get(name)) ?? name);
  assert.equal(await page.run(() => (document.getElementById('often').click(), document.querySelector('#rules tbody tr').id)), 'split-6-3-0-0');

  for (const other of ['collapse-6', 'flip', 'bisect', 'refine-face']) {
    await page.open(address(`atlas/${other}.html`));
    await page.until('document.querySelectorAll("#rules tbody tr:first-child svg.patch").length === 2');
    assert.equal(await page.run('[...document.querySelectorAll("path")].some((path) => /NaN|undefined/.test(path.getAttribute("d")))'), false, other);
  }

  // Nothing of a table is cut off or has to be scrolled for, and each word of a page is explained there.
  for (const width of [1280, 360]) {
    const sized = await browser.page(width, 800);
    for (const [each, words] of [['split-8-4', ['k', 'a', 'A and D', 'orbit']],
      ['collapse-6', ['k', 'A and D', 'orbit']], ['flip', ['A and D']], ['refine-face', []]]) {
      await sized.open(address(`atlas/${each}.html`));
      const found = await sized.run(() => {
        const table = document.querySelector('.wide');
        return { words: [...document.querySelectorAll('.words dt')].map((word) => word.textContent).filter((word) => !['p', 'e, f'].includes(word)),
          over: Math.max(table.scrollWidth - table.clientWidth, document.documentElement.scrollWidth - innerWidth),
          right: Math.max(...[...document.querySelectorAll('#rules td:last-child')].map((cell) => cell.getBoundingClientRect().right)) };
      });
      assert.ok(found.over <= 0 && found.right <= width, `${each} at ${width}: ${JSON.stringify(found)}`);
      if (each !== 'flip' && each !== 'refine-face') assert.deepEqual(found.words, words, each);
    }
    await sized.open(address('atlas/split-8-4.html'));
    writeFileSync(join(scratch, `atlas-${width}.png`), (await sized.run('document.getElementById("rules").scrollIntoView()'), await sized.screenshot()));
    assert.deepEqual(sized.faults, []);
  }
  // Each row has its two pictures without JavaScript. They have the solid edges of its rule, by the lines that are painted.
  await page.open(address('atlas/split-6-3.html'));
  const painted = await page.run(() => [...document.querySelectorAll('#rules tbody tr')].map((row) => [...row.querySelectorAll('svg.patch')].map((picture) => {
    const parts = [...picture.querySelectorAll('use')].map((part) => document.querySelector(part.getAttribute('href')));
    const box = picture.getBBox();
    return { solid: parts.slice(1).map(({ id }) => id).join(' '), stroked: parts.slice(1).every((part) => part.firstElementChild.classList.contains('solid')), wide: box.width > 200 };
  })));
  const bitsOf = (mask) => [...mask.toString(2)].reverse().flatMap((bit, n) => (bit === '1' ? [n] : []));
  const named = (name, edges, ports) => [...bitsOf(edges).map((i) => `${name}e${i}`), ...bitsOf(ports).map((i) => `${name}p${i}`)].join(' ');
  const expected = [...rowsOf('split-6-3.html').values()].map(({ rule: [ports, , colors, kept], before: [position, inner] }) =>
    [named(`b${position}`, inner, ports), named('a', colors, kept)].map((solid) => ({ solid, stroked: true, wide: true })));
  assert.ok(expected.length > 50);
  assert.deepEqual(painted, expected);

  // Painting.
  await page.open(address('atlas/paint.html'));
  await page.until('!!window.restripPainter');
  const paint = (k, a, loop, ports) => page.run((n, m, clicks) => {
    for (const [id, value] of [['k', n], ['a', m]]) {
      document.getElementById(id).value = value;
      document.getElementById(id).dispatchEvent(new Event('input'));
    }
    document.getElementById('clear').click();
    for (const edge of clicks) document.querySelector(`[data-edge="${edge}"]`).dispatchEvent(new MouseEvent('click', { bubbles: true }));
    return { verdict: document.getElementById('verdict').textContent, after: document.querySelectorAll('#after svg').length };
  }, k, a, [...loop.map((i) => `loop ${i}`), ...ports.map((i) => `port ${i}`)]);
  const good = await paint(4, 2, [0, 1], [3]);
  assert.match(good.verdict, /Rule split-4-2-/);
  assert.equal(good.after, 1);
  assert.match((await paint(4, 2, [0, 1], [1])).verdict, /No strips have these colours: triangle 1 has three solid lines/);
  assert.match((await paint(5, 1, [0, 1, 2, 3, 4], [])).verdict, /closes a cycle/);
  assert.match((await paint(20, 9, [0, 1, 4, 5, 6], [3, 8])).verdict, /the automaton computed this rule/);
  // Every family, at several positions: the page and the library agree on what is valid, or the page throws; a link shows the same.
  const painted_ = await page.run(() => [...document.getElementById('family').options].map(({ value }) => value));
  assert.deepEqual(painted_, ['split', 'collapse', 'open-split', 'open-collapse', 'boundary-split', 'boundary-collapse', 'flip']);
  const shown = (name) => page.run((family) => {
    const element = document.getElementById('family');
    element.value = family;
    element.dispatchEvent(new Event('change'));
    const found = [];
    for (const at of [0, 0.5, 1]) {
      const position = document.getElementById('position');
      position.selectedIndex = Math.floor(at * (position.options.length - 1));
      position.dispatchEvent(new Event('change'));
      for (let n = 0; n < 4; ++n) {
        document.getElementById('random').click();
        found.push([document.getElementById('after').innerHTML.includes('<svg'), document.getElementById('verdict').textContent.length > 10]);
      }
    }
    return { found, hash: location.hash, drawn: document.querySelector('.paint').innerHTML };
  }, name);
  for (const name of painted_) {
    const { found, hash, drawn } = await shown(name);
    assert.ok(found.length === 12 && found.flat().every(Boolean), name);
    await page.run((to) => { document.getElementById('clear').click(); location.hash = to; }, hash);
    await page.until((want) => document.querySelector('.paint').innerHTML === want, drawn);
  }
  writeFileSync(join(scratch, 'paint.png'), await page.screenshot());
  assert.deepEqual(page.faults, []);

  await firstPageHolds(browser, folder, scratch);

  const phone = await browser.page(400, 760);
  for (const each of ['index.html', 'docs/README.html', 'docs/results.html', 'atlas/index.html', 'atlas/split-5-2.html', 'atlas/paint.html']) {
    await phone.open(address(each));
    assert.equal(await phone.run('document.documentElement.scrollWidth'), 400, `${each} sticks out sideways`);
  }
  assert.deepEqual(phone.faults, []);
} finally {
  await browser.stop();
}
