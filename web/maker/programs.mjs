// Generator and verifier: the module of module/, started once for each, answering one request at a time.

/// What WASI offers to a program without files, arguments and environment: time, and a place for complaints.
function system(module, memory, complain) {
  const [ok, badFile, notSupported] = [0, 8, 52];
  const calls = {
    clock_time_get: (_clock, _precision, at) => {
      new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return ok;
    },
    fd_write: (file, vectors, count, written) => {
      const view = new DataView(memory().buffer);
      let bytes = 0;
      for (let i = 0; i < count; ++i) {
        const [at, size] = [view.getUint32(vectors + 8 * i, true), view.getUint32(vectors + 8 * i + 4, true)];
        complain(new TextDecoder().decode(new Uint8Array(memory().buffer, at, size)));
        bytes += size;
      }
      view.setUint32(written, bytes, true);
      return file === 1 || file === 2 ? ok : badFile;
    },
    fd_prestat_get: () => badFile,
    proc_exit: (code) => { throw new Error(`the program ended with ${code}`); },
  };
  const wanted = WebAssembly.Module.imports(module).filter((one) => one.module === 'wasi_snapshot_preview1');
  return Object.fromEntries(wanted.map(({ name }) => [name, calls[name] ?? (() => notSupported)]));
}

/// A function from requests to answers. `command`: "generate" or "judge"; `heard`: progress ({ label, done, total }) and
/// claims ({ claim, … }) while it works. An answer with `error` has the sentence that the program would print.
export async function program(compiled, command, heard = () => {}) {
  let complaints = '';
  let exports = null;
  const text = (at, size) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at, size));
  const start = async () => {
    complaints = '';
    const instance = await WebAssembly.instantiate(compiled, {
      wasi_snapshot_preview1: system(compiled, () => exports.memory, (words) => { complaints += words; }),
      maker: {
        progress: (label, size, done, total) => heard({ label: text(label, size), done, total }),
        claim: (at, size) => heard({ claim: JSON.parse(text(at, size))[0] }),
      },
    });
    exports = instance.exports;
    exports._initialize();
  };
  await start();
  return async (request) => {
    try {
      const bytes = new TextEncoder().encode(JSON.stringify(request));
      const at = exports.maker_take(bytes.length);
      new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
      exports[`maker_${command}`](at, bytes.length);
      return JSON.parse(text(exports.maker_text(), exports.maker_size()));
    } catch (error) {
      const why = complaints.trim() || error.message;
      await start();  // its memory may be in any state
      return { error: /memory|allocat|unreachable/.test(why) ? `this operation needs more memory than a page has (${why})` : why };
    }
  };
}

/// One file through the generator and the verifier: { files, report, verdict }, or { error }. `options`: max_k for families,
/// and the languages.
export async function made({ generate, judge }, name, text, { languages = ['c++'], ...options } = {}) {
  const tables = await generate({ files: { [name]: text }, languages, ...options });
  if (tables.error) return tables;
  const ending = (extension) => Object.keys(tables.files).find((file) => file.endsWith(extension));
  return { ...tables, certificate: tables.files[ending('.cert')], header: tables.files[ending('.hpp')],
    verdict: await judged(judge, name, text, { certificate: tables.files[ending('.cert')], header: tables.files[ending('.hpp')] }, options) };
}

/// What the verifier says of these texts, of which one may be missing.
export function judged(judge, name, text, { certificate, header }, options = {}) {
  const files = { [name]: text };
  if (certificate) files['rules.cert'] = certificate;
  if (header) files['rules.hpp'] = header;
  return judge({ files, operation: name, certificate: certificate ? 'rules.cert' : '', header: header ? 'rules.hpp' : '', ...options });
}
