// The pages of the atlas: filters and sorts rows, and shows the row of a link.

const table = document.getElementById('rules');
if (table) {
  const rows = [...table.tBodies[0].rows];
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
  // In the order of the certificate, or by how often real meshes use a rule.
  document.getElementById('often')?.addEventListener('input', (event) => {
    const met = (row) => +(row.dataset.met ?? 0);
    const order = event.target.checked ? rows.toSorted((a, b) => met(b) - met(a)) : rows;
    table.tBodies[0].append(...order);
  });
  form.hidden = false;
  form.addEventListener('input', filter);
  form.addEventListener('submit', (event) => event.preventDefault());
  filter();
  // A link names the first page of a section: the rule may be on another.
  const go = () => {
    const name = location.hash.slice(1);
    const row = document.getElementById(name);
    if (row) return row.scrollIntoView({ block: 'center' });
    const ports = name.split('-').at(-2)?.match(/^[0-9a-f]+$/)?.[0] ?? '0';
    const solid = [...parseInt(ports, 16).toString(2)].filter((bit) => bit === '1').length;
    const page = document.querySelector(`#pages [data-ports~="${solid}"]`);
    if (page) location.replace(page.href + location.hash);
  };
  addEventListener('hashchange', go);
  if (location.hash) go();
}
