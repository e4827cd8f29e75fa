#pragma once
// The triangles of a Wavefront OBJ file, as docs/bound.md counts them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace restrip::verify {

struct TriangleList {
  std::uint64_t vertices = 0;  ///< `v` lines
  /// In the order of the file, vertices counted from 0; those with a corner twice are left out.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::uint64_t left_out = 0;
};

/// Reads `v` and `f` lines; of a corner v/vt/vn the v alone. InputError, by line, when a face has other than three
/// corners or one that is no vertex, and when the file cannot be read or has no triangles.
TriangleList read_obj(const std::string& path);

/// FNV-1a, 64 bits, of all corners as four bytes each, the lowest first.
std::uint64_t digest_of(const TriangleList& list);

}  // namespace restrip::verify
