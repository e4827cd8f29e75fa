// The pages from their archive, in a browser: from the file system, and from a server below a path. Each opens, has a heading,
// says nothing on its console, asks for no file that does not exist, and links to none.
//   node pages.mjs FOLDER CHROMIUM
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, extname, join, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Browser } from '../web/browser.mjs';
import { gpuFlags } from '../web/use_checks.mjs';

const [folder, chromium] = process.argv.slice(2).map((path) => resolve(path));
const types = { '.html': 'text/html', '.svg': 'image/svg+xml', '.png': 'image/png', '.js': 'text/javascript', '.css': 'text/css' };
const below = '/some/where/restrip/';
const server = createServer((request, answer) => {
  const path = decodeURIComponent(new URL(request.url, 'http://x').pathname);
  const file = join(folder, path.slice(below.length));
  if (path === '/favicon.ico') return answer.writeHead(204).end();
  if (!path.startsWith(below) || !file.startsWith(folder) || !statSync(file, { throwIfNoEntry: false })?.isFile()) return answer.writeHead(404).end();
  return answer.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream' }).end(readFileSync(file));
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));

const pages = readdirSync(folder, { recursive: true }).map(String).filter((name) => name.endsWith('.html')).sort();
for (const page of ['index.html', 'viewer.html', 'maker.html', 'atlas/index.html']) assert.ok(pages.includes(page), page);

/// The links of a page to files that are not in the archive.
const deadLinks = (name) => [...readFileSync(join(folder, name), 'utf8').replace(/<script[^]*?<\/script>/g, '').matchAll(/\s(?:href|src)="([^"#]+)/g)]
  .map(([, link]) => link).filter((link) => !/^[a-z]+:/.test(link)).filter((link) => {
    const to = resolve(folder, dirname(name), link);
    return !to.startsWith(folder + sep) || !existsSync(to);
  });
for (const name of pages) assert.deepEqual(deadLinks(name), [], name);

const browser = await Browser.start(chromium, ...gpuFlags);
try {
  for (const base of [`${pathToFileURL(folder)}/`, `http://127.0.0.1:${server.address().port}${below}`])
    for (const name of pages) {
      const page = await browser.page(800, 600);
      await page.open(base + name);
      assert.ok(await page.run(() => document.title.length > 0 && document.querySelector('h1') !== null), `${name}: no title or heading`);
      assert.deepEqual(page.faults, [], base + name);
      await browser.send('Target.closeTarget', { targetId: page.target });
    }
} finally {
  await browser.stop();
  server.close();
}
console.log(`pages.mjs: ${pages.length} pages, from files and from a server`);
