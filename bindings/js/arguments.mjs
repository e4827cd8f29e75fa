// Arguments, checked against the manual (restrip.d.ts); an error has one sentence.
/// No vertex, no halfedge.
export const absent = 0xffffffff;
const costWeights = { strips: { restart: 1, swap: 0, isolated: 0 }, indices: { restart: 3, swap: 1, isolated: 0 } };

/// As it is written in a program: strings in quotes, 5n.
export function quoted(value) {
  return typeof value === 'string' ? `'${value}'` : typeof value === 'bigint' ? `${value}n` : Array.isArray(value) ? 'a list' : String(value);
}
/// The options given, without others than `names`.
export function known(what, options, names) {
  if (typeof options !== 'object' || options === null) throw new TypeError(`${what} is given ${quoted(options)}; it takes an object with ${names.join(', ')}`);
  const other = Object.keys(options).find((name) => !names.includes(name));
  if (other === undefined) return options;
  throw new RangeError(`${what} has no option ${quoted(other)}: expected ${names.join(', ')}`);
}
/// One of the words, as its place in the list.
export function oneOf(what, word, words) {
  if (words.includes(word)) return words.indexOf(word);
  throw new RangeError(`unknown ${what} ${quoted(word)}: expected one of ${words.join(', ')}`);
}
/// A whole number from 0 to `most`.
export function whole(what, n, most = 0xffffffff) {
  if (Number.isInteger(n) && n >= 0 && n <= most) return n;
  throw new RangeError(`${what} is ${quoted(n)}; it must be a whole number from 0 to ${most}`);
}
/// The largest number of operations; without a limit more than any mesh has.
export function limit(most) {
  if (typeof most === 'number' && most >= 0) return Math.min(Math.floor(most), 0xffffffff);
  throw new RangeError(`the number of operations is ${quoted(most)}; it must be 0 or more`);
}
/// The lists of an argument object, which the method needs.
export function lists(method, source, names) {
  const missing = names.find((name) => source?.[name] === undefined || source[name] === null);
  if (missing === undefined) return names.map((name) => source[name]);
  throw new TypeError(`${method} needs { ${names.join(', ')} }; ${typeof source === 'object' && source !== null ? `${missing} is missing` : 'nothing of it is given'}`);
}
/// A flat list with `width` numbers for each item.
function flat(what, list, width) {
  if (typeof list?.length !== 'number' || typeof list === 'string') throw new TypeError(`${what}: ${quoted(list)} is not a list of numbers`);
  if (typeof list[0] === 'object' && list[0] !== null) throw new TypeError(`${what}: its elements are lists; give the numbers in one list: ${what}.flat()`);
  if (list.length % width !== 0) throw new RangeError(`${what}: ${list.length} numbers; they must be ${width} for each`);
}
export function coordinates(list) {
  flat('points', list, 3);
  const out = Float32Array.from(list);
  const wrong = out.findIndex((coordinate) => !Number.isFinite(coordinate));
  if (wrong >= 0) throw new RangeError(`points: vertex ${Math.floor(wrong / 3)} has the coordinate ${quoted(list[wrong])}, which no float can hold`);
  return out;
}
export function point(...place) {
  place.forEach((coordinate, n) => {
    if (!Number.isFinite(Math.fround(coordinate)) || typeof coordinate !== 'number') throw new RangeError(`${'xyz'[n]} is ${quoted(coordinate)}; it must be a finite number that a float can hold`);
  });
  return place;
}
/// Vertices below `count`, `width` for each item of the list; `or`: a number that may stand for none of them.
export function vertices(what, list, width, count, or = NaN) {
  flat(what, list, width);
  for (let i = 0; i < list.length; ++i)
    if (!(Number.isInteger(list[i]) && list[i] >= 0 && list[i] < count) && list[i] !== or)
      throw new RangeError(`${what}: number ${Math.floor(i / width)} names vertex ${quoted(list[i])}; there are ${count}`);
  return Uint32Array.from(list);
}
export function weights(cost) {
  const own = typeof cost === 'string' && Object.hasOwn(costWeights, cost) ? costWeights[cost] : cost;
  if (typeof own !== 'object' || own === null)
    throw new RangeError(`unknown cost ${quoted(cost)}: expected ${Object.keys(costWeights).join(', ')} or custom weights`);
  const { restart, swap, isolated = 0 } = own;
  if (restart === 0) throw new RangeError('the weight restart is 0; it must be a whole number from 1 to 1000');
  return Uint16Array.from(Object.entries({ restart, swap, isolated }), ([name, weight]) => whole(`the weight ${name}`, weight, 1000));
}
export function mask(what, bits) {
  let out;
  try {
    out = BigInt(bits);
  } catch {
    throw new TypeError(`${what} is ${quoted(bits)}; it must be a whole number`);
  }
  if (BigInt.asUintN(64, out) !== out) throw new RangeError(`${what} is ${out}; it must have bits 0 to 63 only`);
  return out;
}
