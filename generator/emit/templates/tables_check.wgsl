// Asks the look-up, restrip_tables.wgsl put before this, everything: one row of 64 invocations or a multiple adds up the
// digest of a position (operation, k, p, q), as `restrip-dump-tables --digests` prints it. Operation 7 counts rules where
// there must be none. digests must be 0 before.
@group(0) @binding(0) var<storage, read> restrip_words: array<u32>;
@group(0) @binding(1) var<storage, read_write> digests: array<atomic<u32>>;
@group(0) @binding(2) var<storage, read> positions: array<vec4<u32>>;

fn packed(rule: RestripRule) -> u32 {
  return select(0u, 0x80000000u | (u32(rule.strips + 8) << 16u) | rule.colors, rule.valid);
}

fn answer(at: vec4<u32>, before: u32, ports: u32) -> u32 {
  switch at.x {
    case 0u: { return packed(restrip_split(at.y, at.z, before, ports)); }
    case 1u: { return packed(restrip_collapse(at.y, at.z, before, ports)); }
    default: {
      let flip = restrip_flip(before, ports);
      return packed(RestripRule((flip.inner << 4u) | flip.ports, flip.strips, flip.valid));
    }
  }
}

fn inside(at: vec4<u32>) -> bool {
  return at.y >= 3u && at.y <= RESTRIP_MAX_K && at.z >= 1u && at.z < at.y;
}

fn rules_outside(i: u32) -> u32 {
  var count = 0u;
  for (var operation = 0u; operation < 2u; operation++) {
    let at = vec4<u32>(operation, i % 20u, i / 20u, 0u);
    if (!inside(at) && answer(at, 0u, 0u) != 0u) {
      count++;
    }
  }
  if (i == 0u && (restrip_flip(2u, 0u).valid || restrip_flip(0u, 16u).valid)) {
    count++;
  }
  return count;
}

fn mix_in(before: u32, ports: u32, answered: u32) -> u32 {
  var h = answered ^ (before * 0x9e3779b1u) ^ (ports * 0x85ebca77u);
  h = (h ^ (h >> 16u)) * 0x85ebca6bu;
  h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
  return h ^ (h >> 16u);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
  let at = positions[id.y];
  var port_bits = 4u;
  var bits = 5u;
  if (at.x < 2u) {
    port_bits = at.y;
    bits = 2u * at.y + 3u * at.x;  // a collapse has three more colours before
  }
  let end = select(1u << bits, 400u, at.x == 7u);
  var digest = 0u;
  for (var i = id.x; i < end; i += groups.x * 64u) {
    if (at.x == 7u) {
      digest += rules_outside(i);
    } else {
      let before = i >> port_bits;
      let ports = i & ((1u << port_bits) - 1u);
      digest += mix_in(before, ports, answer(at, before, ports));
    }
  }
  atomicAdd(&digests[id.y], digest);
}
