// Bytes and modules, from whatever a program has them in. Objects may be of another realm, such as a frame, so their kind
// is asked for by name.
const kindOf = (value) => Object.prototype.toString.call(value).slice(8, -1);

/// The bytes of an ArrayBuffer, a SharedArrayBuffer or a view; null of anything else. Shared ones are copied, because
/// most functions of engines refuse them.
function bytesIn(value) {
  const view = ArrayBuffer.isView(value);
  if (!view && !['ArrayBuffer', 'SharedArrayBuffer'].includes(kindOf(value))) return null;
  const bytes = view ? new Uint8Array(value.buffer, value.byteOffset, value.byteLength) : new Uint8Array(value);
  return kindOf(bytes.buffer) === 'SharedArrayBuffer' ? bytes.slice() : bytes;
}
/// The same, or an error that says what was given for `what`.
export function bytesOf(what, value) {
  const bytes = bytesIn(value);
  if (bytes !== null) return bytes;
  const kind = kindOf(value);
  const remedy = ['Blob', 'File', 'Response'].includes(kind) ? 'await its arrayBuffer()' : kind === 'Promise' ? 'await it'
    : kind === 'Array' ? 'make it Uint8Array.from(…)' : 'it must be an ArrayBuffer or a view of one';
  throw new TypeError(`${what}: ${kind === 'String' ? 'a text' : `a value of the kind ${kind}`} is not bytes; ${remedy}`);
}
/// The content of a file: bytes, text, a Blob, a Response, or a promise of one of them.
export async function contentOf(what, content) {
  const value = await content;
  if (typeof value === 'string') return new TextEncoder().encode(value);
  return bytesOf(what, typeof value?.arrayBuffer === 'function' ? await answered(what, value).arrayBuffer() : value);
}
function answered(what, response) {
  if (response.ok === false) throw new Error(`${response.url || what}: ${response.status} ${response.statusText}`);
  return response;
}

/// A compiled module of WebAssembly: the module, its bytes, a Response, a Blob, an address, or a promise of one of them.
export async function compiled(source) {
  let value = await source;
  if (value instanceof WebAssembly.Module || kindOf(value) === 'WebAssembly.Module') return value;
  if (typeof value === 'string' || kindOf(value) === 'URL') value = await fetched(value);
  // Engines compile what still arrives only if the server says what it is, in these words.
  const streams = value instanceof Response && WebAssembly.compileStreaming && value.headers.get('content-type') === 'application/wasm';
  return streams ? WebAssembly.compileStreaming(answered('the module', value)) : WebAssembly.compile(await contentOf('the module', value));
}
async function fetched(address) {
  let url;
  try {
    url = new URL(address, globalThis.document?.baseURI ?? globalThis.location?.href);
  } catch {
    throw new TypeError(`the module: '${address}' is not an address; give new URL('…', import.meta.url), or the bytes of the file`);
  }
  if (url.protocol !== 'file:') return fetch(url);
  if (typeof process !== 'object' || !process.versions?.node)
    throw new Error(`${url}: a page that was opened as a file cannot read files; serve it, for example by python3 -m http.server, or give the bytes of the module`);
  const files = 'node:fs/promises';  // a name that bundlers for browsers do not look for
  const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
  return readFile(url);
}
