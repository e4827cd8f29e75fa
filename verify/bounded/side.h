// What solid edges make of one side of a patch, for the judges beside this file: they include it where `u32`, PORTS,
// MOST, MOST_TRIANGLES and MOST_BITS are known.
_Static_assert(EDGES_BEFORE <= MOST_BITS && EDGES_AFTER <= MOST_BITS && PORTS <= MOST_BITS, "all bits are counted");

static u32 count(u32 mask) {
  u32 n = 0;
  for (u32 i = 0; i < MOST_BITS; ++i) n += mask >> i & 1;
  return n;
}

// What solid edges make of a side: the strip of each triangle by the number of one in it, and isolated triangles.
typedef struct side {
  u32 strip[MOST_TRIANGLES], isolated;
  _Bool valid;
} side;

static side drawn(u32 triangles, u32 edges, const unsigned char* one, const unsigned char* other,
                  const unsigned char* owner, u32 inner, u32 ports) {
  side s;
  u32 degree[MOST_TRIANGLES];
  s.valid = inner >> edges == 0 && ports >> PORTS == 0;
  s.isolated = 0;
  for (u32 t = 0; t < triangles; ++t) {
    s.strip[t] = t;
    degree[t] = 0;
  }
  for (u32 p = 0; p < PORTS; ++p) degree[owner[p]] += ports >> p & 1;
  for (u32 e = 0; e < edges; ++e)
    if (inner >> e & 1) {
      const u32 kept = s.strip[one[e]], gone = s.strip[other[e]];
      ++degree[one[e]];
      ++degree[other[e]];
      if (kept == gone) s.valid = 0;
      for (u32 t = 0; t < triangles; ++t)
        if (s.strip[t] == gone) s.strip[t] = kept;
    }
  for (u32 t = 0; t < triangles; ++t) {
    if (degree[t] > MOST) s.valid = 0;
    if (degree[t] == 0) ++s.isolated;
  }
  return s;
}
