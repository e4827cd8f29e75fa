// The pages of the atlas: pictures are drawn when their rows come into sight, rows are filtered, a link's row is shown.
import { Patch, has, middle } from '../viewer/patch.mjs';

/// One of the page's patches (scripts/surfaces.py) in these colours.
function sidePicture({ corners, triangles, edges, ports }, inner, solid, description) {
  const patch = new Patch();
  for (const [a, b, c, style] of triangles) patch.add(corners[a], corners[b], corners[c], style);
  edges.forEach(([u, v, a, b], i) => patch.join(u, v, middle(corners[a], corners[b]), has(inner, i)));
  ports.forEach(([u, a, b], i) => patch.port(u, corners[a], corners[b], has(solid, i)));
  return patch.svg(description);
}

function drawRow(row, { before, after }) {
  const [ports, , colors, kept] = row.dataset.rule.split(' ').map(Number);
  const [position, inner] = row.dataset.before.split(' ').map(Number);
  return sidePicture(before[position], inner, ports, 'before') + sidePicture(after, colors, kept, 'after');
}

const table = document.getElementById('rules');
if (table) {
  const patches = JSON.parse(document.getElementById('patches').textContent);
  const rows = [...table.tBodies[0].rows];
  const draw = (row) => {
    watcher.unobserve(row);
    if (row.cells[0].innerHTML === '') row.cells[0].innerHTML = drawRow(row, patches);
  };
  const watcher = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) if (isIntersecting) draw(target);
  }, { rootMargin: '600px' });
  rows.forEach((row) => watcher.observe(row));
  addEventListener('beforeprint', () => rows.filter((row) => !row.hidden).forEach(draw));

  const form = document.getElementById('filter');
  const filter = () => {
    const kinds = [...form.querySelectorAll('[name]:checked')].map((box) => box.name);
    const wanted = form.ports?.value.match(/\d+/g)?.reduce((mask, i) => mask | 1 << i, 0);
    let shown = 0;
    for (const row of rows) {
      row.hidden = !kinds.every((kind) => row.classList.contains(kind)) ||
        (wanted !== undefined && +row.dataset.rule.split(' ')[0] !== wanted);
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
