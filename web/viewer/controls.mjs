// Input of the visitor: pointers, keys, buttons and choices.

export function listen(viewer, by) {
  by('light').setAttribute('aria-pressed', String(viewer.light));
  by('light').addEventListener('click', () => {
    viewer.light = !viewer.light;
    by('light').setAttribute('aria-pressed', String(viewer.light));
    viewer.ask();
  });
  by('unpeel').addEventListener('click', () => viewer.unpeel());
  by('peel').addEventListener('input', () => viewer.peelTo(+by('peel').value));
  by('fault-gone').addEventListener('click', () => viewer.found());
  by('picture').addEventListener('click', () => viewer.savePicture());
  viewer.camera.listen(by('canvas'), () => viewer.changed(), (event) => {
    if (viewer.part === 'cut') viewer.cut.click(viewer.pane.rayAt(event));
  });
  by('canvas').addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && viewer.part === 'cut') viewer.cut.click(viewer.pane.ray(0, 0));
  });
  by('canvas').addEventListener('pointermove', (event) => {
    viewer.cursor = viewer.pane.placeOf(event);
    if (event.buttons === 0 && by('mode').value === 'cursor') viewer.changed();
  });
  by('level').addEventListener('input', () => viewer.moveTo(+by('level').value));
  by('down').addEventListener('click', () => viewer.step(-1));
  by('up').addEventListener('click', () => viewer.step(1));
  by('single').addEventListener('click', () => {
    by('policy').value = viewer.mesh.figures.baked ? 'quick' : 'baked';
    if (by('policy').value === 'baked') by('mode').value = 'level';
    viewer.begin();
  });
  // Baked strips are of levels in order, which view-dependent modes do not keep.
  const exclude = (id, other, usual) => by(id).addEventListener('change', () => {
    const both = by('policy').value === 'baked' && by('mode').value !== 'level';
    if (both) by(other).value = usual;
    if (id === 'policy' || both) viewer.begin();
    else viewer.changed();
  });
  exclude('policy', 'mode', 'level');
  exclude('mode', 'policy', 'quick');
  by('cost').addEventListener('change', () => viewer.begin());
  by('style').addEventListener('change', () => viewer.ask());
  document.addEventListener('keydown', (event) => {
    if (['SELECT', 'INPUT'].includes(event.target.tagName)) return;
    if (event.key === '.') viewer.step(1);
    if (event.key === ',') viewer.step(-1);
  });
}
