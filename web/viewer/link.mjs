// The parts of the page, and its state as the part of the address after #, so that a link shows it to others.

/// A part, and what can be done on the picture while it is shown.
const usual = 'Drag to turn. Drop a mesh file on the page.';
const parts = { ribbon: usual, cut: 'Click to cut. Drag to turn.', turn: '', race: 'Drag to turn both.', use: usual };

/// Choices that an address names, unless they have these values.
const usualChoices = { policy: 'quick', cost: 'indices', mode: 'level', style: 'strips', rival: 'scratch', 'race-policy': 'quick', 'race-cost': 'indices', stride: '0.01' };

/// The state that an address names; numbers and lists are checked where they are used.
export const readLink = (hash) => Object.fromEntries(new URLSearchParams(hash.replace(/^#/, '')));

/// Puts a state into the address; empty values are left out.
function writeLink(state) {
  const named = Object.entries(state).filter(([, value]) => value !== undefined && value !== '');
  const hash = `#${new URLSearchParams(named).toString().replaceAll('%2C', ',')}`;
  if (hash !== location.hash) history.replaceState(null, '', hash);
}

/// A camera's place as text, and back; null if the text is not a place.
const placeText = ({ yaw, pitch, distance, target }) => [yaw, pitch, distance, ...target].map((n) => n.toFixed(3)).join(',');
function placeOf(text) {
  const numbers = (text ?? '').split(',').map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite) || numbers[2] <= 0) return null;
  const [yaw, pitch, distance, ...target] = numbers;
  return { yaw, pitch: Math.max(-1.5, Math.min(1.5, pitch)), distance, target };
}

/// Shows a part, the first if there is none of that name; returns its name.
export function showPart(by, name) {
  const shown = Object.hasOwn(parts, name ?? '') ? name : 'ribbon';
  for (const part of Object.keys(parts)) {
    by(`part-${part}`).hidden = part !== shown;
    const link = by('parts').querySelector(`[href="#part=${part}"]`);
    if (part === shown) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  document.body.dataset.part = shown;
  by('hint').textContent = parts[shown];
  if (['ribbon', 'race'].includes(shown)) by(`part-${shown}`).querySelector('[data-level]').after(by('level-row'));
  return shown;
}

export class Link {
  #writing = 0;
  #known = '';  // the address as last followed or written

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    addEventListener('hashchange', () => this.follow());
  }

  /// Shows the state that the address names; the rest does not change.
  follow() {
    const { by, viewer } = this;
    this.#known = location.hash;
    const state = readLink(this.#known);
    // The close look at a cut ends with its part.
    if (viewer.part === 'cut' && state.part !== 'cut' && viewer.cut.shown) viewer.camera.fly(viewer.home, viewer.moves ? 700 : 0);
    viewer.part = showPart(by, state.part);
    for (const id of Object.keys(usualChoices)) {
      const option = state[id] === undefined ? null : [...by(id).options].find(({ value, disabled }) => value === state[id] && !disabled);
      if (!option || by(id).value === option.value) continue;
      by(id).value = option.value;
      by(id).dispatchEvent(new Event('change'));
    }
    const level = Number(state.level ?? NaN);
    if (Number.isInteger(level) && level >= 0 && level <= viewer.mesh.levels && level !== viewer.level) viewer.moveTo(level);
    for (const record of (state.cut ?? '').split(',').filter(Boolean).map(Number))
      if (!viewer.clicks.includes(record) && viewer.canSplit(record)) viewer.splitRecord(record);
    const place = placeOf(state.view);
    if (place) viewer.camera.place = place;
    viewer.turn.goTo(state);
    viewer.ask();
  }
  /// Writes the settled state to the address, but not often: with the light on every frame calls this.
  write() {
    this.#writing ||= setTimeout(() => {
      const { by, viewer } = this;
      this.#writing = 0;
      if (!viewer.settled || location.hash !== this.#known) return;  // another address is about to be followed
      const view = placeText(viewer.camera.place);
      const choices = Object.entries(usualChoices).map(([id, ordinary]) => [id, by(id).value === ordinary ? undefined : by(id).value]);
      writeLink({ part: viewer.part, level: viewer.level, ...Object.fromEntries(choices), cut: viewer.clicks.join(','),
        view: view === placeText(viewer.home) ? undefined : view, ...viewer.turn.state });
      this.#known = location.hash;
    }, 400);
  }
}
