#!/usr/bin/env node
// The picture of README.md and of links to the viewer: the built-in mesh at three levels, each one strip, as the viewer draws it
// in headless Chromium ($CHROMIUM, else chromium).  scripts/ribbon_picture.mjs WEB_FOLDER OUT.png
// Build the target `web` first; WEB_FOLDER is its build/<preset>/web.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';
import { Browser } from '../tests/web/browser.mjs';

const shares = [0.02, 0.2, 0.75];  // of the vertex splits that are done
const [paneWidth, height, wide] = [400, 630, 440];  // of each, and of the window from which it is cut

/// The pixels, four bytes each, and the number of strips of each mesh in it.
export async function ribbonPicture(browser, address) {
  const page = await browser.page(wide + 372, height, { sharp: 2 });  // next to the panel
  await page.open(`${address}#policy=baked`);
  await page.until(() => window.restripViewer?.settled);
  const sheet = await page.run((width, high) => {
    const canvas = new OffscreenCanvas(width, high);
    window.sheet = canvas.getContext('2d', { willReadFrequently: true });
    window.sheet.imageSmoothingQuality = 'high';
    return [restripViewer.scene.canvas.width, restripViewer.scene.canvas.height];
  }, paneWidth * shares.length, height);
  if (sheet.join() !== [2 * wide, 2 * height].join()) throw new Error(`the canvas has ${sheet.join(' x ')} pixels`);
  const figures = [];
  for (const [n, share] of shares.entries()) {
    await page.run((part) => restripViewer.moveTo(Math.round(part * restripViewer.mesh.levels)), share);
    await page.until(() => restripViewer.settled);
    figures.push(await page.run((from, to) => {
      const { camera, home, scene } = restripViewer;
      camera.place = { ...home, pitch: 0.16, distance: 1.04 * home.distance * scene.canvas.width / scene.canvas.height };
      restripViewer.draw();
      window.sheet.drawImage(scene.canvas, ...from, ...to);
      return restripViewer.figures;
    }, [wide - paneWidth, 0, 2 * paneWidth, 2 * height], [n * paneWidth, 0, paneWidth, height]));
  }
  const pixels = Buffer.from(await page.run((width, high) => {
    const { data } = window.sheet.getImageData(0, 0, width, high);
    let text = '';
    for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
    return btoa(text);
  }, paneWidth * shares.length, height), 'base64');
  return { width: paneWidth * shares.length, height, pixels, figures };
}

/// The best 256 colours, by halving the box of colours that spreads most, and the one of each pixel.
function palette(pixels) {
  const counts = new Map();
  for (let i = 0; i < pixels.length; i += 4) {
    const color = pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2];
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const channel = (color, c) => color >> 8 * (2 - c) & 255;
  const boxOf = (colors) => {
    let box = { spread: -1 };
    const all = colors.reduce((sum, color) => sum + counts.get(color), 0);
    for (let c = 0; c < 3; ++c) {
      const mean = colors.reduce((sum, color) => sum + counts.get(color) * channel(color, c), 0) / all;
      const spread = colors.reduce((sum, color) => sum + counts.get(color) * (channel(color, c) - mean) ** 2, 0);
      if (spread > box.spread) box = { colors, all, c, mean, spread };
    }
    return box;
  };
  const boxes = [boxOf([...counts.keys()])];
  while (boxes.length < 256) {
    const widest = boxes.reduce((best, box, n) => (box.spread > boxes[best].spread ? n : best), 0);
    const { colors, c, mean, spread } = boxes[widest];
    if (spread === 0) break;
    boxes.splice(widest, 1, ...[true, false].map((low) => boxOf(colors.filter((color) => (channel(color, c) <= mean) === low))));
  }
  const index = new Map();
  const colors = Buffer.alloc(3 * boxes.length);
  boxes.forEach((box, n) => {
    for (let c = 0; c < 3; ++c) colors[3 * n + c] = Math.round(box.colors.reduce((sum, color) => sum + counts.get(color) * channel(color, c), 0) / box.all);
    for (const color of box.colors) index.set(color, n);
  });
  return { colors, at: (i) => index.get(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]) };
}

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = crc >>> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

export function pngOf({ width, height: high, pixels }) {
  const { colors, at } = palette(pixels);
  const rows = Buffer.alloc(high * (width + 1));
  for (let y = 0; y < high; ++y) for (let x = 0; x < width; ++x) rows[y * (width + 1) + 1 + x] = at(4 * (y * width + x));
  const chunk = (name, data) => {
    const out = Buffer.alloc(12 + data.length);
    out.writeUInt32BE(data.length);
    out.write(name, 4, 'latin1');
    data.copy(out, 8);
    out.writeUInt32BE(crc32(out.subarray(4, 8 + data.length)), 8 + data.length);
    return out;
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width);
  head.writeUInt32BE(high, 4);
  head.set([8, 3, 0, 0, 0], 8);  // a byte each, of a palette
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('PLTE', colors),
    chunk('IDAT', deflateSync(rows, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, out] = process.argv.slice(2);
  if (!out) {
    console.error('usage: scripts/ribbon_picture.mjs WEB_FOLDER OUT.png');
    process.exit(2);
  }
  const browser = await Browser.start(process.env.CHROMIUM ?? 'chromium');
  try {
    const picture = await ribbonPicture(browser, pathToFileURL(join(folder, 'viewer.html')).href);
    const bytes = pngOf(picture);
    writeFileSync(out, bytes);
    console.log(`${picture.figures.map(({ triangles, strips }) => `${triangles} triangles in ${strips} strip`).join(', ')}; ${bytes.length} bytes`);
  } finally {
    await browser.stop();
  }
}
