// Checks that an index buffer draws the triangles of a mesh, each once. For tests and debug builds: a buffer that
// misses a change draws a wrong picture without noticing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/live_buffer.hpp"

namespace restrip {

/// Three vertices counter-clockwise, the lowest first.
using DrawnTriangle = std::array<std::uint32_t, 3>;

namespace detail {

constexpr DrawnTriangle lowest_first(DrawnTriangle t) noexcept {
  if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
  if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
  return t;
}

}  // namespace detail

/// The triangles that strips with restart indices draw, sorted; degenerate ones left out. `Index`: an unsigned type of
/// 16 or 32 bits, whose highest value restarts. O(n log n).
template <class Index>
[[nodiscard]] std::vector<DrawnTriangle> triangles_of_strips(std::span<const Index> indices) {
  std::vector<DrawnTriangle> drawn;
  std::size_t start = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == (std::numeric_limits<Index>::max)()) start = i + 1;
    if (i < start + 2) continue;
    DrawnTriangle t{indices[i - 2], indices[i - 1], indices[i]};
    if ((i - start) % 2 == 1) std::swap(t[0], t[1]);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) drawn.push_back(detail::lowest_first(t));
  }
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

/// The triangles that a triangle list draws.
template <class Index>
[[nodiscard]] std::vector<DrawnTriangle> triangles_of_list(std::span<const Index> indices) {
  std::vector<DrawnTriangle> drawn;
  for (std::size_t i = 2; i < indices.size(); i += 3)
    drawn.push_back(detail::lowest_first({indices[i - 2], indices[i - 1], indices[i]}));
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

/// The triangles of a mesh.
[[nodiscard]] inline std::vector<DrawnTriangle> triangles_of(const StripMesh& mesh) {
  std::vector<DrawnTriangle> all;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) all.push_back(detail::lowest_first(mesh.corners(t)));
  std::sort(all.begin(), all.end());
  return all;
}

struct BufferReport {
  std::size_t missing = 0;  ///< triangles of the mesh that the buffer does not draw
  std::size_t extra = 0;    ///< triangles that it draws but the mesh does not have, or draws more than once
  [[nodiscard]] constexpr bool right() const noexcept { return missing + extra == 0; }
};

namespace detail {

inline BufferReport compare_drawn(const std::vector<DrawnTriangle>& drawn, const std::vector<DrawnTriangle>& wanted) {
  const auto count_beyond = [](const auto& all, const auto& known) {
    std::vector<DrawnTriangle> beyond;
    std::set_difference(all.begin(), all.end(), known.begin(), known.end(), std::back_inserter(beyond));
    return beyond.size();
  };
  return {count_beyond(wanted, drawn), count_beyond(drawn, wanted)};
}

}  // namespace detail

/// Decodes the buffer and compares. O(n log n).
[[nodiscard]] inline BufferReport check_buffer(const LiveBuffer& buffer, const StripMesh& mesh) {
  const bool narrow = buffer.index_bytes() == 2;
  if (buffer.format().form == StripForm::list)
    return detail::compare_drawn(narrow ? triangles_of_list(buffer.indices16()) : triangles_of_list(buffer.indices()),
                                 triangles_of(mesh));
  return detail::compare_drawn(narrow ? triangles_of_strips(buffer.indices16()) : triangles_of_strips(buffer.indices()),
                               triangles_of(mesh));
}

}  // namespace restrip
