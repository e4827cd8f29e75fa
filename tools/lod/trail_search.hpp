// A search for the fewest flips that join two strips: offline work, for baking.
//
// Two colourings of a mesh differ by alternating trails: dashed, solid, ..., dashed edges, one after the other across
// the triangles. A trail that leads from a strip's end to a strip's end and is flipped whole leaves every degree as it
// was but for the two ends, so the mesh has one strip less, if only no cycle is solid then. This search walks trails
// depth first, shortest first, and asks about cycles only where one arrives; in between, cycles may come and go. That
// is what it has over tunnelling (tunnel.hpp), whose every move keeps paths: it finds shorter trails, with fewer flips,
// and is the slower the longer they are. How far the ends are is measured beforehand, along walks that alternate in the
// same way, so that no trail is followed that must get too long. (Alternating paths: Berge, "Two theorems in graph
// theory", 1957.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/strip_locator.hpp"

namespace restrip::tools {

class TrailSearch {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Trails of at most this many solid edges are tried.
  static constexpr unsigned longest = 32;

  /// Joins two strips by the shortest trail from one of `ends` that it can find within `max_states` edges walked or
  /// triangles measured. True
  /// when it did: then colours and locator are changed, and flips() are the edges of the trail. Deterministic.
  bool join(StripMesh& mesh, StripLocator& locator, const std::vector<Triangle>& ends, std::size_t max_states);

  /// The trail of the last success: dashed, solid, ..., dashed before, each the other way now.
  [[nodiscard]] const std::vector<Halfedge>& flips() const noexcept { return trail_; }
  [[nodiscard]] std::size_t states() const noexcept { return states_; }

 private:
  static constexpr std::uint8_t far = 255;
  static_assert(longest < far);
  /// Of a triangle that a trail leaves across a dashed edge, in solid edges.
  struct Way {
    std::uint8_t here = far;    // from the nearest beginning
    std::uint8_t first = far;   // from here to the nearest end
    std::uint8_t second = far;  // to the nearest other one
    Triangle target = none;     // that nearest end
  };
  struct Arrival {
    Triangle triangle;
    Triangle target;
    unsigned solid;
  };
  template <class Visit>
  void for_each_beside(Triangle t, bool solid, Visit&& visit) const;
  void measure(const std::vector<Triangle>& ends, unsigned radius);
  void forget_ways();
  [[nodiscard]] unsigned solid_edges_from(Triangle t) const;
  bool walk_on(Triangle end, unsigned solid_left);
  [[nodiscard]] bool closes_no_cycle();
  void toggle(Halfedge h);
  void take_back();
  void commit();

  StripMesh* mesh_ = nullptr;
  StripLocator* locator_ = nullptr;
  std::vector<std::uint8_t> on_trail_;  // by halfedge
  std::vector<Halfedge> trail_;
  std::vector<Way> ways_;      // by triangle
  std::vector<Triangle> met_;  // those whose way is known
  std::vector<Triangle> targets_;
  std::vector<Arrival> back_;
  Triangle not_to_ = none;  // the end that the trail begins at, where it must not come back to it
  std::size_t states_ = 0;
  std::size_t last_state_ = 0;

  // The strips as the trail has cut them, while cycles are looked for.
  struct Cut {
    std::uint32_t strip;
    std::uint64_t order;  // of the first triangle behind the cut
    friend auto operator<=>(const Cut&, const Cut&) = default;
  };
  struct Piece {
    std::uint32_t strip;
    std::size_t number;  // cuts that lie before it
    std::size_t joined;  // with: union-find
  };
  [[nodiscard]] Cut place_of(Triangle t) const;
  std::size_t piece_of(Triangle t);
  std::vector<Cut> cuts_;
  std::vector<Piece> pieces_;
};

}  // namespace restrip::tools
