// The part Your turn in Chromium: lines are clicked with the mouse and by keys until no colouring is better; what is
// wrong is named and marked on the way; each set of the reason is shown, and then the visitor's colours again; the link
// has puzzle and colours; a patch that was cut becomes a puzzle.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { faultsOf } from './accessible.mjs';

const verdict = (page) => page.run('document.getElementById("turn-text").textContent');
const turn = (page) => page.run(() => {
  const { puzzle, inner, best, number } = restripViewer.turn;
  return { name: puzzle.name, k: puzzle.k, a: puzzle.a, inner: Number(inner), best: Number(best), edges: puzzle.edges.length, number };
});
/// Clicks the middle of a line as a mouse does: between its first triangle and the side that it crosses.
async function click(page, edge) {
  const [x, y] = await page.run((name) => {
    const line = document.querySelector(`#turn-after [data-edge="${name}"]`);
    const [from, to] = [0, 1].map((n) => line.points[n]);
    const place = new DOMPoint((from.x + 2 * to.x) / 3, (from.y + 2 * to.y) / 3).matrixTransform(line.getScreenCTM());
    return [place.x, place.y];
  }, `inner ${edge}`);
  for (const type of ['mousePressed', 'mouseReleased']) await page.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1 });
}

export async function checkTurn(browser, address, scratch) {
  const page = await browser.page(360, 640, { dark: true });
  await page.open(`${address}#part=turn`);
  await page.until(() => window.restripViewer?.turn.puzzle && window.restripViewer.settled);
  const first = await turn(page);
  assert.equal(first.number, 0);
  assert.match(await verdict(page), /^Click an edge: .* as few strips as you can\.$/);
  writeFileSync(join(scratch, 'turn-phone.png'), await page.screenshot());

  // Mouse and keys in turn, up to the rule. The line keeps the focus.
  for (let edge = 0; edge < first.edges; ++edge) {
    if ((first.inner ^ first.best) >> edge & 1) {
      if (edge % 2 === 0) await click(page, edge);
      else {
        await page.run((name) => document.querySelector(`#turn-after [data-edge="${name}"]`).focus(), `inner ${edge}`);
        for (const type of ['keyDown', 'keyUp'])
          await page.send('Input.dispatchKeyEvent', { type, key: 'Enter', code: 'Enter', windowsVirtualKeyCode: 13 });
      }
      assert.equal(await page.run('document.activeElement.dataset.edge'), `inner ${edge}`);
    }
  }
  assert.equal((await turn(page)).inner, first.best);
  assert.match(await verdict(page), /^best\. Yours: .* No recolouring is better\. Solved in \d clicks?!$/);
  assert.ok(await page.run('document.getElementById("turn-on").checkVisibility() && /, 1 solved$/.test(document.getElementById("turn-count").textContent)'));
  assert.equal(await page.run('document.querySelectorAll("#turn-after .marked").length'), 0);
  // The browser remembers it: another visit begins with the next one.
  const again = await browser.page(390, 844);
  await again.open(`${address}#part=turn`);
  await again.until(() => !!window.restripViewer?.turn.puzzle && window.restripViewer.settled);
  assert.equal((await turn(again)).number, 1);
  assert.match(await again.run('document.getElementById("turn-count").textContent'), /, 1 solved$/);
  // The puzzle of a day, each day another; its result is offered when it is solved by hand, and only then.
  const daily = await again.run(() => {
    const { turn: own } = restripViewer;
    document.getElementById('turn-daily').click();
    const press = () => [...document.querySelectorAll('#turn-after .hit')].forEach((line, edge) => {
      if ((own.inner ^ own.best) >> BigInt(edge) & 1n) document.querySelectorAll('#turn-after .hit')[edge].dispatchEvent(new MouseEvent('click', { bubbles: true }));
    });
    const share = document.getElementById('turn-share');
    const found = { number: own.number, k: own.puzzle.k, days: new Set(Array.from({ length: 100 }, (_, n) => own.puzzles.daily(own.day + n))).size, same: own.number === own.puzzles.daily(own.day), hidden: [share.hidden] };
    document.getElementById('turn-rule').click();
    found.hidden.push(share.hidden);
    document.getElementById('turn-again').click();
    press();
    found.hidden.push(share.hidden);
    return { ...found, text: document.getElementById('turn-result').textContent, name: own.puzzle.name };
  });
  assert.deepEqual([daily.same, daily.days, ...daily.hidden], [true, 100, true, true, false]);
  assert.ok(daily.k >= 5 && daily.text.includes(`#part=turn&puzzle=${daily.name}`) && /solved in \d+ clicks?\./.test(daily.text), daily.text);
  assert.deepEqual(again.faults, []);
  await page.send('Page.bringToFront');

  // Its reason, set by set.
  await page.run(() => { document.querySelector('#part-turn details').open = true; });
  const sets = await page.run(() => [...document.querySelectorAll('#turn-reason [data-set]')].map((button) => {
    button.click();
    const found = { pressed: document.querySelectorAll('#turn-reason [aria-pressed=true]').length, own: button.getAttribute('aria-pressed'),
      marked: document.querySelectorAll('#turn-after .marked').length, clickable: document.querySelectorAll('#turn-after .hit').length,
      text: document.getElementById('turn-text').textContent };
    return found;
  }));
  assert.ok(sets.length >= 2);
  for (const set of sets) {
    assert.deepEqual([set.pressed, set.own, set.clickable], [1, 'true', 0]);
    assert.equal(set.marked, 1);
    assert.match(set.text, /^Not your colours\. (not valid: .*: (triangle \w+ has 3 solid edges|a cycle)|unsound: .*: a cycle with ports \d-\d connected outside, and none before)\.$/);
  }
  writeFileSync(join(scratch, 'turn-reason.png'), await page.screenshot());
  assert.equal(await page.run('document.documentElement.scrollWidth'), 360);
  assert.deepEqual(await faultsOf(page), []);
  await page.run(() => [...document.querySelectorAll('#turn-reason [data-set]')].at(-1).click());
  assert.equal((await turn(page)).inner, first.best);
  assert.equal(await page.run('document.querySelectorAll("#turn-after .hit").length'), first.edges);

  // Faults by name: the two new triangles and an adjacent one closed; three edges of one of them; ports joined. explain_test.mjs
  // compares more of them with the verifier.
  const say = async (puzzle, mine) => {
    await page.run((hash) => { location.hash = hash; }, `#part=turn&puzzle=${puzzle}&mine=${mine.toString(16)}`);
    await page.until((name, inner) => restripViewer.turn.puzzle.name === name && Number(restripViewer.turn.inner) === inner, puzzle, mine);
    return verdict(page);
  };
  assert.match(await say('3-1-0-0', 0b100011), /^not valid: A=t0 t0=D A=D: a cycle\.$/);
  assert.match(await say('3-1-0-0', 0b110001), /^not valid: A=t0 t2=A A=D: triangle A has 3 solid edges\.$/);
  assert.match(await say('4-2-0-3', 0b10), /^unsound: t0=t1, ports 0 1: a cycle with ports 0-1 connected outside, and none before\.$/);
  assert.deepEqual(await page.run(() => ['after .marked', 'after .outside', 'before .outside'].map((what) => document.querySelectorAll(`#turn-${what}`).length)), [1, 1, 1]);
  await page.until(() => location.hash.includes('puzzle=4-2-0-3&mine=2'));

  // From one puzzle to the next, and by number; a vertex too large for certificates.
  await say('3-1-0-0', 0b100011);
  await page.run(() => { document.getElementById('turn-next').click(); });
  const next = await turn(page);
  await page.run(() => { document.getElementById('turn-back').click(); });
  assert.equal((await turn(page)).number, next.number - 1);
  await page.run(() => {
    const number = document.getElementById('turn-number');
    number.value = 9999999;
    number.dispatchEvent(new Event('change'));
  });
  assert.equal((await turn(page)).number, await page.run('restripViewer.turn.puzzles.count') - 1);
  await say('10-4-7-0', 1);
  assert.match(await page.run('document.getElementById("turn-reason").textContent'), /end at vertices of 8 triangles/);
  assert.deepEqual(page.faults, []);

  // The patch that was cut, wide and light.
  const wide = await browser.page(1280, 800);
  await wide.open(`${address}#part=cut`);
  await wide.until(() => window.restripViewer?.figures !== undefined && window.restripViewer.settled);
  await wide.run('restripViewer.moveTo(700)');  // by collapses
  await wide.until('restripViewer.settled && document.getElementById("take").disabled');
  const last = await wide.run(() => {
    document.getElementById('anywhere').click();
    const { k, a, before, ports } = restripViewer.mesh.last;
    return { k, a, strips: restripViewer.restrip.rule({ family: 'split', k, a, edges: before, ports }).strips };
  });
  await wide.until('restripViewer.settled');
  await wide.run(() => document.getElementById('take').click());
  await wide.until('restripViewer.turn.puzzle && restripViewer.part === "turn"');
  const taken = await turn(wide);
  assert.deepEqual([taken.k, taken.a], [last.k, Math.min(last.a, last.k - last.a)]);
  assert.equal(await wide.run('restripViewer.turn.puzzle.after(restripViewer.turn.best) - restripViewer.turn.puzzle.before'), last.strips);
  assert.match(await wide.run('document.getElementById("turn-where").textContent'), /^The patch that you cut/);
  await wide.run(() => { location.hash = '#part=turn'; });
  await wide.until('document.body.dataset.part === "turn" && restripViewer.settled');
  writeFileSync(join(scratch, 'turn.png'), await wide.screenshot());
  assert.deepEqual(wide.faults, []);
}
