// What an operation did, or why it was refused.
#pragma once

#include <cstdint>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The result of an operation. (Baked operations count only strips, see baked.hpp.)
template <class Halfedge>
struct Rewrite : ColoringChange {  // swaps are counted by a Keeper whose cost weighs them
  Halfedge halfedge{};  ///< split: the chord v_s -> v_t; collapse: a spoke of v_s (see CollapsibleMesh); flip: the
                        ///< turned edge
  std::uint32_t valence = 0;  ///< k of the fan that was split or that the collapse left; 4 for a flip
};

/// What a checked operation on a custom mesh did, or why it was refused. The halfedge of the rewrite leads to a new
/// vertex.
template <class Halfedge>
struct CustomChecked {
  Refusal refusal = Refusal::granted;
  Rewrite<Halfedge> rewrite{};  ///< of the operation, if it was granted

  [[nodiscard]] constexpr bool granted() const noexcept { return refusal == Refusal::granted; }
  constexpr explicit operator bool() const noexcept { return granted(); }
};

/// The same on a StripMesh.
struct Checked : CustomChecked<StripMesh::Halfedge> {
  Vertex new_vertex = none;  ///< of a split, split_face or bisect, if it was granted
};

/// The sources of a Keeper's colours, over all operations except baked ones and operations under Policy::bare.
struct RuleCounts {
  std::uint64_t asked = 0;     ///< rules looked up
  std::uint64_t taken = 0;     ///< of them: their colours were written
  std::uint64_t kept = 0;      ///< of them: passed-on colours cost no more and were kept
  std::uint64_t improved = 0;  ///< operations after which a search lowered the cost, or joins strips or isolated ones
  friend constexpr bool operator==(const RuleCounts&, const RuleCounts&) = default;
};

}  // namespace restrip
