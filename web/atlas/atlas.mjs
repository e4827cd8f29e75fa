// The pages of the atlas: pictures are drawn when their rows come into sight, rows are filtered, a link's row is shown.
import { fanPicture, named, ringPicture } from '../viewer/patch.mjs';
import { anyFan, flipPicture, openSplitPicture } from './drawings.mjs';

function drawRow(row, { family, n, at }) {
  const [p, q, r, s] = row.dataset.k.split(' ').map(Number);
  const k = +n;
  const places = at === '' ? [] : at.split(' ').map(Number);
  if (family === 'flip') return flipPicture(false, q === 1, p, 'before') + flipPicture(true, s === 1, r, 'after');
  if (family === 'split') return fanPicture(k, places[0], r, p, 'before') + ringPicture(k, places[0], s, p, 'after');
  const closed = family === 'collapse';
  if (closed || family === 'fan-collapse') {
    const [inner, ...gaps] = row.dataset.before.split(' ').map(Number);
    const before = 'a patch before, with the fewest solid edges';
    const ring = closed ? ringPicture(k, gaps[0], inner, p, before) : openSplitPicture(k, gaps, inner, p, before);
    return ring + anyFan({ closed, k, a: gaps[0] }, s, p, 'after');
  }
  return anyFan({ closed: false, k }, r, p, 'before') + openSplitPicture(k, places, s, p, 'after');
}

/// All dashed, with names: what the numbers in the table mean.
function numbering({ family, n, at }) {
  const k = +n;
  const places = at === '' ? [] : at.split(' ').map(Number);
  if (family === 'flip') return '';
  if (family === 'split') return ringPicture(k, places[0], 0, 0, 'the names of edges and ports');
  if (family.endsWith('collapse')) return anyFan({ closed: family === 'collapse', k }, 0, 0, 'the names of edges and ports');
  return openSplitPicture(k, places, 0, 0, 'the names of edges and ports');
}

const table = document.getElementById('rules');
if (table) {
  const rows = [...table.tBodies[0].rows];
  const watcher = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      watcher.unobserve(target);
      if (target.cells[0].innerHTML === '') target.cells[0].innerHTML = drawRow(target, table.dataset);
    }
  }, { rootMargin: '600px' });
  rows.forEach((row) => watcher.observe(row));

  const names = document.getElementById('names');
  if (names) names.innerHTML = named(() => numbering(table.dataset));

  const form = document.getElementById('filter');
  const filter = () => {
    const kinds = [...form.querySelectorAll('[name]:checked')].map((box) => box.name);
    const wanted = form.ports?.value.match(/\d+/g)?.reduce((mask, i) => mask | 1 << i, 0);
    let shown = 0;
    for (const row of rows) {
      row.hidden = !kinds.every((kind) => row.classList.contains(kind)) ||
        (wanted !== undefined && +row.dataset.k.split(' ')[0] !== wanted);
      shown += row.hidden ? 0 : 1;
    }
    form.querySelector('output').textContent = shown === rows.length ? `${shown} rules` : `${shown} of ${rows.length} rules`;
  };
  // In the order of the certificate, or by how often a rule is met.
  document.getElementById('often')?.addEventListener('input', (event) => {
    const met = (row) => +(row.dataset.met ?? 0);
    const order = event.target.checked ? rows.toSorted((a, b) => met(b) - met(a)) : rows;
    table.tBodies[0].append(...order);
  });
  form.hidden = false;
  form.addEventListener('input', filter);
  form.addEventListener('submit', (event) => event.preventDefault());
  filter();
  const go = () => document.getElementById(location.hash.slice(1))?.scrollIntoView({ block: 'center' });
  addEventListener('hashchange', go);
  if (location.hash) go();
}
