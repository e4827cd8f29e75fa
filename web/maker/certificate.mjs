// Certificates (docs/reference/certificate.md): their rows, and the last line.

/// The text with its last line made again: the number of rows, the sum of all bytes, and the sum of each byte times its
/// number.
export function sealed(text) {
  const body = text.replace(/end [^\n]*\n$/, '');
  const bytes = new TextEncoder().encode(body);
  let [plain, numbered] = [0n, 0n];
  bytes.forEach((byte, i) => {
    plain += BigInt(byte);
    numbered += BigInt(byte) * BigInt(i + 1);
  });
  const rows = body.split('\n').filter((line) => /^(rule|copy|alternative) /.test(line)).length;
  return `${body}end ${rows} ${plain} ${numbered}\n`;
}

/// The rows of a certificate with one section, in order: [{ line, copy, ports, joined, inner, kept, reason, by }], masks as
/// numbers, except `joined`, a BigInt: 12 ports have 66 pairs.
export function rowsOf(text) {
  return text.split('\n').flatMap((words, line) => {
    const [kind, P, J, R, K, , ...rest] = words.split(' ');
    if (kind !== 'rule' && kind !== 'copy') return [];
    const [ports, inner, kept] = [P, R, K].map((mask) => parseInt(mask, 16));
    return [{ line, copy: kind === 'copy', ports, joined: BigInt(`0x${J}`), inner, kept, reason: kind === 'rule' ? rest.join(' ') : '', by: kind === 'copy' ? rest.map(Number) : [] }];
  });
}

/// The certificate with another recolouring in one of its rows.
export function changed(text, line, inner) {
  const lines = text.split('\n');
  const words = lines[line].split(' ');
  words[3] = inner.toString(16);
  lines[line] = words.join(' ');
  return sealed(lines.join('\n'));
}
