#version 450
// Asks the look-up: one row of 64 invocations or a multiple adds up the digest of a position (operation, k, p, q), as
// `restrip-dump-tables --automaton --digests` prints it. Operation 7 counts rules where there must be none. digests must be 0
// before. Where a position has at most 7,000 keys all are asked, else 64 that are drawn.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer RestripAutomaton { uint restrip_words_in_automaton[]; };
layout(std430, set = 0, binding = 1) buffer Digests { uint digests[]; };
layout(std430, set = 0, binding = 2) readonly buffer Positions { uvec4 positions[]; };
#include "restrip_automaton.glsl"

uint mix_in(uint before, uint ports, uint answered) {
  uint h = answered ^ (before * 0x9e3779b1u) ^ (ports * 0x85ebca77u);
  h = (h ^ (h >> 16u)) * 0x85ebca6bu;
  h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
  return h ^ (h >> 16u);
}

// How many keys are asked for a fan of k triangles.
uint keys_of(uint k) {
  uint keys = 1u;
  for (uint i = 0u; i < k && keys <= 7000u; ++i) keys *= 3u;
  return keys <= 7000u ? keys : 64u;
}

// Key n: a letter for each port, the last one the lowest digit; or masks that are drawn.
RestripKey key_numbered(uint k, uint n, uint keys) {
  if (keys == 64u) {
    uint all = (1u << k) - 1u;
    return RestripKey(mix_in(n, 0u, 0u) & all, mix_in(n, 1u, 0u) & all);
  }
  RestripKey key = RestripKey(0u, 0u);
  for (uint i = k; i-- > 0u; n /= 3u) {
    uint letter = n % 3u;
    key.ports |= uint(letter != 0u) << i;
    key.joined |= uint(letter == 2u) << i;
  }
  return key;
}

RestripRecoloring answer(uvec4 at, RestripKey key) {
  switch (at.x) {
    case 0u: return restrip_best_split(at.y, at.z, key);
    case 1u: return restrip_best_collapse(at.y, key);
    case 2u: return restrip_best_open_split(at.y, at.z, at.w, key);
    case 3u: return restrip_best_fan_collapse(at.y, key);
  }
  return restrip_best_boundary_split(at.y, at.z, key);
}

bool inside(uvec4 at) {
  if (at.y < (at.x < 2u ? 3u : 1u) || at.y > RESTRIP_AUTOMATON_MAX_K) return false;
  if (at.x == 0u) return at.z >= 1u && at.z < at.y;
  if (at.x == 2u) return at.z < at.w && at.w <= at.y;
  return at.x != 4u || at.z <= at.y;
}

uint rules_outside(uint i) {
  uint count = 0u;
  for (uint operation = 0u; operation < 5u; ++operation) {
    uvec4 at = uvec4(operation, i % 40u, i / 40u % 40u, i / 1600u);
    if (!inside(at) && answer(at, RestripKey(0u, 0u)).valid) ++count;
  }
  return count;
}

void main() {
  uvec4 at = positions[gl_GlobalInvocationID.y];
  uint keys = keys_of(at.y);
  uint end = at.x == 7u ? 64000u : keys;
  uint digest = 0u;
  for (uint i = gl_GlobalInvocationID.x; i < end; i += gl_NumWorkGroups.x * 64u) {
    if (at.x == 7u) {
      digest += rules_outside(i);
      continue;
    }
    RestripKey key = key_numbered(at.y, i, keys);
    RestripRecoloring made = answer(at, key);
    digest += mix_in(i, key.ports, made.valid ? 0x80000000u | made.colors : 0u);
  }
  atomicAdd(digests[gl_GlobalInvocationID.y], digest);
}
