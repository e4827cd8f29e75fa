// Every link and picture of every page leads to a file of the pages, and to an element of it that has the name after #.
// A page with a dead link or a dead anchor is noticed. Documents are pages: no Markdown is shown as it is written.
//   node links_test.mjs WEB_FOLDER
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join, posix } from 'node:path';

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
assert.ok(pages.size > 60 && count > 500, `${pages.size} pages, ${count} links`);
const spoiled = '<a href="strips.html#nowhere">x</a> <img src="lost.png"> <a href="../index.html">y</a> <a href="#here" id="here">z</a>';
assert.deepEqual(deadLinks('docs/spoiled.html', spoiled, new Map([...pages, ['docs/spoiled.html', spoiled]])).dead, ['strips.html#nowhere', 'lost.png']);
console.log(`${count} links of ${pages.size} pages`);
