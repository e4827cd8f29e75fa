#version 450
// Asks the look-up everything: one row of 64 invocations or a multiple adds up the digest of a position (operation, k,
// p, q), as `restrip-dump-tables --digests` prints it. Operation 7 counts rules where there must be none. digests must
// be 0 before.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer RestripTables { uint restrip_words[]; };
layout(std430, set = 0, binding = 1) buffer Digests { uint digests[]; };
layout(std430, set = 0, binding = 2) readonly buffer Positions { uvec4 positions[]; };
#include "restrip_tables.glsl"

uint packed_rule(RestripRule rule) {
  return rule.valid ? 0x80000000u | (uint(rule.strips + 8) << 16u) | rule.colors : 0u;
}

uint answer(uvec4 at, uint before, uint ports) {
  switch (at.x) {
    case 0u: return packed_rule(restrip_split(at.y, at.z, before, ports));
    case 1u: return packed_rule(restrip_collapse(at.y, at.z, before, ports));
  }
  RestripFlipRule flip = restrip_flip(before, ports);
  return packed_rule(RestripRule((flip.inner << 4u) | flip.ports, flip.strips, flip.valid));
}

bool inside(uvec4 at) {
  return at.y >= 3u && at.y <= RESTRIP_MAX_K && at.z >= 1u && at.z < at.y;
}

uint rules_outside(uint i) {
  uint count = 0u;
  for (uint operation = 0u; operation < 2u; ++operation) {
    uvec4 at = uvec4(operation, i % 20u, i / 20u, 0u);
    if (!inside(at) && answer(at, 0u, 0u) != 0u) ++count;
  }
  if (i == 0u && (restrip_flip(2u, 0u).valid || restrip_flip(0u, 16u).valid)) ++count;
  return count;
}

uint mix_in(uint before, uint ports, uint answered) {
  uint h = answered ^ (before * 0x9e3779b1u) ^ (ports * 0x85ebca77u);
  h = (h ^ (h >> 16u)) * 0x85ebca6bu;
  h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
  return h ^ (h >> 16u);
}

void main() {
  uvec4 at = positions[gl_GlobalInvocationID.y];
  uint port_bits = at.x < 2u ? at.y : 4u;
  uint bits = at.x < 2u ? 2u * at.y + 3u * at.x : 5u;  // a collapse has three more colours before
  uint end = at.x == 7u ? 400u : 1u << bits;
  uint digest = 0u;
  for (uint i = gl_GlobalInvocationID.x; i < end; i += gl_NumWorkGroups.x * 64u) {
    uint before = i >> port_bits;
    uint ports = i & ((1u << port_bits) - 1u);
    digest += at.x == 7u ? rules_outside(i) : mix_in(before, ports, answer(at, before, ports));
  }
  atomicAdd(digests[gl_GlobalInvocationID.y], digest);
}
