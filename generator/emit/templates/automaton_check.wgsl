// Asks the look-up, restrip_automaton.wgsl put before this: one row of 64 invocations or a multiple adds up the digest of a
// position (operation, k, p, q), as `restrip-dump-tables --automaton --digests` prints it. Operation 7 counts rules where
// there must be none. digests must be 0 before. Where a position has at most 7,000 keys all are asked, else 64 that are
// drawn.
@group(0) @binding(0) var<storage, read> restrip_words_in_automaton: array<u32>;
@group(0) @binding(1) var<storage, read_write> digests: array<atomic<u32>>;
@group(0) @binding(2) var<storage, read> positions: array<vec4<u32>>;

fn mix_in(before: u32, ports: u32, answered: u32) -> u32 {
  var h = answered ^ (before * 0x9e3779b1u) ^ (ports * 0x85ebca77u);
  h = (h ^ (h >> 16u)) * 0x85ebca6bu;
  h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
  return h ^ (h >> 16u);
}

// How many keys are asked for a fan of k triangles.
fn keys_of(k: u32) -> u32 {
  var keys = 1u;
  for (var i = 0u; i < k && keys <= 7000u; i++) {
    keys *= 3u;
  }
  return select(64u, keys, keys <= 7000u);
}

// Key n: a letter for each port, the last one the lowest digit; or masks that are drawn.
fn key_numbered(k: u32, number: u32, keys: u32) -> RestripKey {
  if (keys == 64u) {
    let all = (1u << k) - 1u;
    return RestripKey(mix_in(number, 0u, 0u) & all, mix_in(number, 1u, 0u) & all);
  }
  var key = RestripKey(0u, 0u);
  var n = number;
  for (var i = k; i > 0u; i--) {
    let letter = n % 3u;
    n /= 3u;
    key.ports |= u32(letter != 0u) << (i - 1u);
    key.joined |= u32(letter == 2u) << (i - 1u);
  }
  return key;
}

fn answer(at: vec4<u32>, key: RestripKey) -> RestripRecoloring {
  switch at.x {
    case 0u: { return restrip_best_split(at.y, at.z, key); }
    case 1u: { return restrip_best_collapse(at.y, key); }
    case 2u: { return restrip_best_open_split(at.y, at.z, at.w, key); }
    case 3u: { return restrip_best_fan_collapse(at.y, key); }
    default: { return restrip_best_boundary_split(at.y, at.z, key); }
  }
}

fn inside(at: vec4<u32>) -> bool {
  if (at.y < select(1u, 3u, at.x < 2u) || at.y > RESTRIP_AUTOMATON_MAX_K) {
    return false;
  }
  if (at.x == 0u) {
    return at.z >= 1u && at.z < at.y;
  }
  if (at.x == 2u) {
    return at.z < at.w && at.w <= at.y;
  }
  return at.x != 4u || at.z <= at.y;
}

fn rules_outside(i: u32) -> u32 {
  var count = 0u;
  for (var operation = 0u; operation < 5u; operation++) {
    let at = vec4<u32>(operation, i % 40u, i / 40u % 40u, i / 1600u);
    if (!inside(at) && answer(at, RestripKey(0u, 0u)).valid) {
      count++;
    }
  }
  return count;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
  let at = positions[id.y];
  let keys = keys_of(at.y);
  let end = select(keys, 64000u, at.x == 7u);
  var digest = 0u;
  for (var i = id.x; i < end; i += groups.x * 64u) {
    if (at.x == 7u) {
      digest += rules_outside(i);
    } else {
      let key = key_numbered(at.y, i, keys);
      let made = answer(at, key);
      digest += mix_in(i, key.ports, select(0u, 0x80000000u | made.colors, made.valid));
    }
  }
  atomicAdd(&digests[id.y], digest);
}
