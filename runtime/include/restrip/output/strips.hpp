// From colours to strips: check a colouring, list the triangles of each strip, write the index buffer.
//
// Everything here is computed from scratch in linear time and is the same on every machine. The index buffer is the
// plain triangle strip of OpenGL, Vulkan, Direct3D and WebGPU with primitive restart: after the first two indices of a
// strip each index v_{i+2} draws the triangle (v_i, v_{i+1}, v_{i+2}) when i is even and (v_{i+1}, v_i, v_{i+2}) when i
// is odd. A strip that turns twice the same way repeats one index there (a *swap*; Evans, Skiena, Varshney, "Optimizing
// triangle strips for fast rendering", 1996), which draws one degenerate triangle that hardware drops.
//
//   const Strips strips = extract_strips(mesh);
//   const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);   // upload; restart index 0xFFFFFFFF
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The result of check_coloring(). The colouring is valid when the first three counts are zero.
struct ColoringReport {
  std::size_t one_sided = 0;     ///< dual edges that are solid in only one of their triangles
  std::size_t over_degree = 0;   ///< triangles with three solid edges
  std::size_t solid_cycles = 0;  ///< independent solid cycles: how many solid edges must be removed to break them all
  std::size_t triangles = 0;
  std::size_t strips = 0;    ///< solid components, isolated triangles included
  std::size_t isolated = 0;  ///< triangles without a solid edge
  bool valid = true;
};

/// Checks a whole colouring from its definition. Close to linear time, 4 bytes of memory a triangle.
[[nodiscard]] ColoringReport check_coloring(const StripMesh& mesh);

/// Number of strips of a valid colouring. Linear time, a bit a triangle. Throws std::invalid_argument when the
/// colouring is not valid.
[[nodiscard]] std::size_t count_strips(const StripMesh& mesh);

/// The number of swaps (cost.hpp) of a valid colouring. Linear time.
[[nodiscard]] std::size_t count_swaps(const StripMesh& mesh);

/// The strips of a mesh: strip s is order[start[s]] … order[start[s + 1] - 1], each triangle next to the following one.
struct Strips {
  std::vector<Triangle> order;
  std::vector<std::size_t> start{0};  ///< size() + 1 offsets into `order`
  /// Strips are written from their first triangle; else from the end that needs fewer indices.
  bool directed = false;

  [[nodiscard]] std::size_t size() const noexcept { return start.size() - 1; }
  [[nodiscard]] std::span<const Triangle> operator[](std::size_t s) const noexcept {
    return {order.data() + start[s], order.data() + start[s + 1]};
  }
};

/// Lists the strips of a valid colouring. A strip begins at its end with the lower handle, and strips are sorted by
/// that handle, so equal meshes give equal lists. If the colouring is not valid, each triangle is listed at most once,
/// and triangles on solid cycles are left out.
[[nodiscard]] Strips extract_strips(const StripMesh& mesh);

/// The index between two strips of an index buffer.
inline constexpr std::uint32_t restart_index = 0xFFFFFFFFU;

/// The index buffer of the strips, in their order, restart_index between them and neither before nor after. It draws
/// each triangle exactly once, with its winding in the mesh; indices are vertex numbers. A strip of n triangles takes
/// n + 2 indices and one for each swap, and one more if its first turn is to the right. `strips` must be the strips of
/// the mesh as it is now: debug builds check that triangles that follow each other share a solid dual edge.
[[nodiscard]] std::vector<std::uint32_t> strip_indices(const StripMesh& mesh, const Strips& strips);

/// The same as strip_indices(mesh, extract_strips(mesh)), without the list of strips. The colouring must be
/// valid; debug builds check that.
[[nodiscard]] std::vector<std::uint32_t> strip_indices(const StripMesh& mesh);

/// strip_indices(mesh, strips).size().
[[nodiscard]] std::size_t strip_index_count(const StripMesh& mesh, const Strips& strips);

namespace detail {

/// extract_strips(), but throws std::invalid_argument when the colouring is not valid.
[[nodiscard]] Strips valid_strips(const StripMesh& mesh);

}  // namespace detail

}  // namespace restrip
