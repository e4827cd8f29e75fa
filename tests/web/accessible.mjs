// Checks of accessibility that a program can make. Each control that can be seen has a name, by the browser's own tree.
// Ids are unique, and labels are for something. Headings leave out no level. Text has a contrast of 4.5 to 1.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

const roles = ['button', 'link', 'textbox', 'spinbutton', 'slider', 'combobox', 'checkbox', 'DisclosureTriangle', 'img', 'image', 'Canvas'];

/// All that is wrong with what is seen of a page, as sentences.
export async function faultsOf(page) {
  await page.send('Accessibility.enable');
  const { nodes } = await page.send('Accessibility.getFullAXTree');
  const controls = nodes.filter(({ ignored, role }) => !ignored && roles.includes(role?.value));
  const nameless = controls.filter(({ name }) => !name?.value.trim()).map(({ role }) => `a ${role.value} has no name`);
  const others = await page.run(() => {
    const faults = [];
    const seen = [...document.querySelectorAll('body *')].filter((element) => element.checkVisibility({ visibilityProperty: true }));
    const ids = [...document.querySelectorAll('[id]')].map(({ id }) => id);
    for (const id of ids) if (ids.indexOf(id) !== ids.lastIndexOf(id)) faults.push(`two elements are called ${id}`);
    for (const { htmlFor } of document.querySelectorAll('label[for]'))
      if (!ids.includes(htmlFor)) faults.push(`a label is for ${htmlFor}, which is not there`);
    let level = 0;
    for (const heading of seen.filter(({ tagName }) => /^H[1-6]$/.test(tagName))) {
      const next = +heading.tagName[1];
      if (next > level + 1) faults.push(`heading "${heading.textContent}" of level ${next} follows level ${level}`);
      level = next;
    }
    const paint = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const parts = (color) => {  // as red, green, blue and alpha, however the browser writes it
      paint.clearRect(0, 0, 1, 1);
      paint.fillStyle = color;
      paint.fillRect(0, 0, 1, 1);
      return [...paint.getImageData(0, 0, 1, 1).data];
    };
    const light = (color) => color.slice(0, 3).map((c) => c / 255).map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, n) => sum + c * [0.2126, 0.7152, 0.0722][n], 0);
    let texts = 0;
    for (const element of seen) {
      const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
      if (!own || element.closest('svg, option, :disabled') || element.namespaceURI !== 'http://www.w3.org/1999/xhtml') continue;
      let behind = element;
      while (behind && parts(getComputedStyle(behind).backgroundColor)[3] < 255) behind = behind.parentElement;
      const colors = [getComputedStyle(element).color, getComputedStyle(behind ?? document.body).backgroundColor];
      const [ink, paper] = colors.map(parts).map(light);
      const share = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
      ++texts;
      if (share < 4.5) faults.push(`"${element.textContent.trim().slice(0, 30)}" differs by ${share.toFixed(1)} to 1`);
    }
    return { faults, texts };
  });
  assert.ok(controls.length > 5 && others.texts > 10, `${controls.length} controls, ${others.texts} texts`);
  return [...nameless, ...others.faults];
}

/// Every part of the viewer: wide and light, narrow and dark; there nothing sticks out sideways, and the page ends with its content.
export async function checkParts(browser, address, scratch) {
  const page = await browser.page(1280, 800);
  await page.open(address);
  await page.until(() => window.restripViewer?.figures !== undefined && window.restripViewer.settled);
  const parts = await page.run(() => [...document.querySelectorAll('#parts a')].map((link) => link.hash.replace('#part=', '')));
  assert.ok(parts.length >= 4);
  for (const [width, height, dark] of [[1280, 800, false], [360, 640, true]]) {
    await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
    await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
      { name: 'prefers-reduced-motion', value: 'reduce' }] });
    for (const part of parts) {
      await page.run((name) => { location.hash = `#part=${name}`; }, part);
      await page.until((name) => document.body.dataset.part === name && restripViewer.settled, part);
      assert.deepEqual(await faultsOf(page), [], `${part}, ${width} pixels wide`);
      // Fingers need room.
      const small = await page.run(() => [...document.querySelectorAll('button, select, summary, input:not(.file input), nav a')]
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44).map((element) => element.textContent || element.id));
      if (width < 800) assert.deepEqual(small, [], `${part}: too small for a finger`);
      const sizes = await page.run(() => [document.documentElement.scrollWidth,
        Math.abs(document.documentElement.scrollHeight - document.querySelector('main').getBoundingClientRect().bottom - scrollY) <= 1]);
      assert.deepEqual(sizes, [width, true], part);
      writeFileSync(join(scratch, `part-${part}-${width}.png`), await page.screenshot());
    }
  }
  await noticesFaults(page);
  assert.deepEqual(page.faults, []);
}

/// The checks notice what they are for.
async function noticesFaults(page) {
  await page.run(() => {
    document.querySelector('aside').insertAdjacentHTML('beforeend', `<div id="wrong"><button></button><h6>deep</h6>
      <p style="color: #999; background: #fff">pale</p><label for="nowhere">lost</label><i id="wrong"></i></div>`);
  });
  const faults = await faultsOf(page);
  await page.run(() => document.getElementById('wrong').remove());
  for (const what of [/button has no name/, /heading "deep" of level 6/, /"pale" differs by 2\.8 to 1/, /for nowhere, which is not there/,
    /two elements are called wrong/])
    assert.ok(faults.some((fault) => what.test(fault)), `${what} goes unseen: ${faults}`);
}
