// Every link and picture of every page leads to a file of the pages, and to an element of it that has the name after #.
// A page with a dead link or a dead anchor is noticed. Documents are pages: no Markdown is shown as it is written. Each
// page leads to the first page, the viewer, Make a rule, the atlas and the documents, and marks the one that it is; it has a
// title of its own and a description. With
// an address the picture of a link to a page has an absolute address.
//   node links_test.mjs WEB_FOLDER
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder] = process.argv.slice(2);
const pages = new Map(['', 'docs', 'docs/tutorials', 'docs/how-to', 'docs/reference', 'docs/explanation', 'atlas'].flatMap((below) => readdirSync(join(folder, below)).filter((name) => name.endsWith('.html'))
  .map((name) => posix.join(below, name))).map((name) => [name, readFileSync(join(folder, name), 'utf8')]));

/// The links of a page that lead nowhere, and how many it has.
function deadLinks(name, text, files) {
  // The contents of scripts are not part of the page; they make links with parts of the address that they read
  // themselves.
  const shown = text.replace(/<script[^]*?<\/script>/g, '');
  const links = [...shown.matchAll(/\s(?:href|src|content)="([^"]*)"/g)].map(([, link]) => link.replaceAll('&amp;', '&'))
    .filter((link) => !/^(https?|data|mailto):/.test(link) && /^#|\.\w+(#|$)/.test(link));
  const dead = links.filter((link) => {
    const [path, anchor] = link.split('#');
    const to = path === '' ? name : posix.join(posix.dirname(name), path);
    if (!files.has(to) && !existsSync(join(folder, to))) return true;
    return anchor !== undefined && !/^part=/.test(anchor) && !(files.get(to) ?? '').includes(`id="${anchor}"`);
  });
  return { dead, count: links.length };
}

let count = 0;
for (const [name, text] of pages) {
  const found = deadLinks(name, text, pages);
  assert.deepEqual(found.dead, [], name);
  count += found.count;
  assert.doesNotMatch(text.replace(/<(pre|code|script|style)[^]*?<\/\1>/g, ''), /\]\([\w./#-]+\)|^\| --- \|/m, `${name} shows Markdown as it is written`);
}
const titles = new Map();
const main = ['index.html', 'maker.html', 'viewer.html', 'atlas/index.html', 'docs/README.html'];
for (const [name, text] of pages) {
  const navigation = /<nav aria-label="Pages">(.*?)<\/nav>/s.exec(text)?.[1] ?? '';
  const links = [...navigation.matchAll(/href="([^"]*)"( aria-current="page"| aria-current="true")?/g)];
  assert.deepEqual(links.map(([, link]) => posix.join(posix.dirname(name), link)), main, name);
  assert.deepEqual(links.flatMap(([, , own], n) => (own?.includes('page') ? [main[n]] : [])), main.filter((each) => each === name), name);
  assert.equal(/aria-current="true">Documents/.test(navigation), /^docs\/|^[A-Z]+\.html/.test(name) && name !== 'docs/README.html', name);
  titles.set(name, /<title>(.*)<\/title>\n<meta name="description" content="(.+)">/.exec(text)?.[1]);
}
assert.equal(new Set(titles.values()).size, pages.size - [...pages.keys()].filter((name) => name.includes('-from-')).length, 'titles');
const made = mkdtempSync(join(tmpdir(), 'restrip-links-'));
const pictureOf = (text) => /property="og:image" content="([^"]*)"/.exec(text)[1];
const source = (name) => fileURLToPath(new URL(`../../web/${name}`, import.meta.url));
execFileSync('python3', [source('bundle.py'), source('viewer/viewer.html'), join(made, 'viewer.html'), '--place', 'viewer.html', '--address', 'https://example.org/restrip/']);
assert.equal(pictureOf(readFileSync(join(made, 'viewer.html'), 'utf8')), 'https://example.org/restrip/docs/ribbon.png');
rmSync(made, { recursive: true });
if (!/^https:/.test(pictureOf(pages.get('viewer.html'))))
  assert.deepEqual(['viewer.html', 'index.html', 'docs/how-to/c.html'].map((name) => pictureOf(pages.get(name))), ['docs/ribbon.png', 'docs/ribbon.png', '../ribbon.png']);
assert.ok(pages.size > 60 && count > 500, `${pages.size} pages, ${count} links`);
const spoiled = '<a href="strips.html#nowhere">x</a> <img src="lost.png"> <a href="../index.html">y</a> <a href="#here" id="here">z</a>';
assert.deepEqual(deadLinks('docs/spoiled.html', spoiled, new Map([...pages, ['docs/spoiled.html', spoiled]])).dead, ['strips.html#nowhere', 'lost.png']);
console.log(`${count} links of ${pages.size} pages`);
