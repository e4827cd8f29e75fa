// Claim: docs/ribbon.png, the picture of README.md, is what its command draws now, except for rounding by this
// Chromium. A turned picture differs.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { pngOf, ribbonPicture } from '../../scripts/ribbon_picture.mjs';

/// `page`: any, to read pictures in. `address`: of the viewer.
export async function pictureIsFresh(browser, page, address) {
  const picture = await ribbonPicture(browser, address);
  assert.deepEqual(picture.figures.map(({ strips }) => strips), [1, 1, 1]);
  const [near, far] = await page.run(async (...files) => {
    const [a, b] = await Promise.all(files.map(async (file) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${file}`)).blob());
      const sheet = new OffscreenCanvas(image.width, image.height).getContext('2d');
      sheet.drawImage(image, 0, 0);
      return sheet.getImageData(0, 0, image.width, image.height);
    }));
    const mean = (other) => (a.width !== b.width || a.height !== b.height ? Infinity
      : a.data.reduce((sum, n, i) => sum + Math.abs(n - b.data[other(i)]), 0) / a.data.length);
    return [mean((i) => i), mean((i) => a.data.length - 4 - i + 2 * (i % 4))];
  }, pngOf(picture).toString('base64'), readFileSync(fileURLToPath(new URL('../../docs/ribbon.png', import.meta.url))).toString('base64'));
  assert.ok(near < 1 && far > 5, `docs/ribbon.png: colours differ by ${near}, and by ${far} from a turned picture; scripts/ribbon_picture.mjs rebuilds it`);
}
