// What an operation did, or why it was refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The result of an operation. (Baked operations count only strips, see baked.hpp.)
struct Rewrite : ColoringChange {  // swaps are counted by a Keeper whose cost weighs them
  Halfedge halfedge{};  ///< split: the chord v_s -> v_t; collapse: a spoke of v_s (see StripMesh::remove_vertex); flip:
                        ///< the turned edge
  std::uint32_t valence = 0;  ///< k of the fan that was split or that the collapse left; 4 for a flip
};

/// The new vertices of an operation, in the order of its file; of a split the one new vertex.
struct NewVertices {
  static constexpr std::size_t most = 18;  ///< a disc of 16 triangles has at most 18 vertices
  std::array<Vertex, most> vertex;
  std::size_t count = 0;

  void push_back(Vertex v) noexcept { vertex[count++] = v; }
  [[nodiscard]] std::size_t size() const noexcept { return count; }
  [[nodiscard]] bool empty() const noexcept { return count == 0; }
  [[nodiscard]] Vertex operator[](std::size_t i) const noexcept { return vertex[i]; }
  [[nodiscard]] const Vertex* begin() const noexcept { return vertex.data(); }
  [[nodiscard]] const Vertex* end() const noexcept { return vertex.data() + count; }
};

/// What a checked operation did, or why it was refused.
struct Checked {
  Refusal refusal = Refusal::granted;
  Rewrite rewrite{};         ///< of the operation, if it was granted
  NewVertices new_vertices;  ///< likewise

  [[nodiscard]] constexpr bool granted() const noexcept { return refusal == Refusal::granted; }
  constexpr explicit operator bool() const noexcept { return granted(); }
  /// The first new vertex, or none.
  [[nodiscard]] Vertex new_vertex() const noexcept { return new_vertices.empty() ? none : new_vertices[0]; }
};

/// The sources of a Keeper's colours, over all operations except baked ones and operations under Policy::bare.
struct RuleCounts {
  std::uint64_t asked = 0;     ///< rules looked up
  std::uint64_t taken = 0;     ///< of them: their colours were written
  std::uint64_t kept = 0;      ///< of them: passed-on colours cost no more and were kept
  std::uint64_t improved = 0;  ///< operations after which a search lowered the cost, or a join the number of strips or
                               ///< of isolated triangles
  friend constexpr bool operator==(const RuleCounts&, const RuleCounts&) = default;
};

}  // namespace restrip
