// What the page shows, as the part of its address behind #, so that a link shows it to others.

/// The state that an address names; numbers and lists are checked where they are used.
export const readLink = (hash) => Object.fromEntries(new URLSearchParams(hash.replace(/^#/, '')));

/// Puts a state into the address; what is empty is left out.
export function writeLink(state) {
  const told = Object.entries(state).filter(([, value]) => value !== undefined && value !== '');
  const hash = `#${new URLSearchParams(told).toString().replaceAll('%2C', ',')}`;
  if (hash !== location.hash) history.replaceState(null, '', hash);
}

/// A camera's place as text, and back; null where the text is none.
export const placeText = ({ yaw, pitch, distance, target }) => [yaw, pitch, distance, ...target].map((n) => n.toFixed(3)).join(',');
export function placeOf(text) {
  const numbers = (text ?? '').split(',').map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite) || numbers[2] <= 0) return null;
  const [yaw, pitch, distance, ...target] = numbers;
  return { yaw, pitch: Math.max(-1.5, Math.min(1.5, pitch)), distance, target };
}
