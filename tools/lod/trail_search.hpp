// A search for the fewest flips that join two strips: offline work, for baking.
//
// Two colourings of a mesh differ by alternating trails: dashed, solid, ..., dashed edges, one after the other across
// the triangles. A trail that leads from a strip's end to a strip's end and is flipped whole leaves every degree as it
// was but for the two ends, so the mesh has one strip less, if only no cycle is solid then. This search walks trails
// depth first, shortest first, and asks about cycles only where one arrives; in between, cycles may come and go. That
// is what it has over tunnelling (tunnel.hpp), whose every move keeps paths: it finds shorter trails, with fewer flips,
// and is the slower the longer they are. (Alternating paths: Berge, "Two theorems in graph theory", 1957.)
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

  /// Joins two strips by the shortest trail from one of `ends` that it can find within `max_states` edges walked. True
  /// when it did: then colours and locator are changed, and flips() are the edges of the trail. Deterministic.
  bool join(StripMesh& mesh, StripLocator& locator, const std::vector<Triangle>& ends, std::size_t max_states);

  /// The trail of the last success: dashed, solid, ..., dashed before, each the other way now.
  [[nodiscard]] const std::vector<Halfedge>& flips() const noexcept { return trail_; }
  [[nodiscard]] std::size_t states() const noexcept { return states_; }

 private:
  void measure_distances(const std::vector<Triangle>& ends);
  bool walk_on(Triangle end, unsigned solid_left);
  [[nodiscard]] bool closes_no_cycle();
  void toggle(Halfedge h);
  void take_back();
  void commit();

  StripMesh* mesh_ = nullptr;
  StripLocator* locator_ = nullptr;
  std::vector<std::uint8_t> on_trail_;  // by halfedge
  std::vector<Halfedge> trail_;
  // How far the nearest strip end is, in steps across edges; `far` where none is near enough for any trail.
  std::vector<std::uint8_t> distance_;
  std::vector<Triangle> measured_;
  bool pruning_ = false;
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
