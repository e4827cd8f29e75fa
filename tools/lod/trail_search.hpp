// A search for the fewest flips that join two strips: offline work, for baking.
//
// Two colourings of a mesh differ by alternating trails: dashed, solid, ..., dashed edges, one after the other across
// the triangles. Flipping a whole trail from one strip end to another changes the degrees of the two ends only, so the
// mesh has one strip less, provided no solid cycle results. This search walks trails depth first, shortest first, and
// tests for cycles only when a trail arrives; in between, cycles may appear and vanish. Tunnelling (tunnel.hpp), by
// contrast, keeps paths in every move. So this search finds shorter trails with fewer flips, but slows down as trails
// grow. Distances to the ends are measured beforehand, along walks that alternate in the same way, so a trail that must
// become too long is not followed. (Alternating paths: Berge, "Two theorems in graph theory", 1957.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "search/strip_locator.hpp"

namespace restrip::tools {

// How many strips each connected component of a mesh has, and a lower bound for each.

/// Each connected component of the dual graph takes at least one strip, and a triangle with at most one neighbour is
/// the end of a strip. A vertex split neither joins nor divides components, so updating the counts takes time linear in
/// its patch.
class ComponentStrips {
 public:
  /// Linear time.
  explicit ComponentStrips(const StripMesh& mesh);

  /// Call them with the triangles around the vertex before a split, and around both vertices after it.
  void before_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  void after_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  /// The component of a triangle now has `strips` more strips than before.
  void add(Triangle t, std::ptrdiff_t strips) { components_[component_[t]].strips += strips; }
  /// Counts the strips again, after any change of colours. Linear time.
  void recount(const StripMesh& mesh);

  [[nodiscard]] std::size_t components() const noexcept { return components_.size(); }
  /// For the whole mesh, whatever its colours.
  [[nodiscard]] std::size_t needed() const noexcept { return static_cast<std::size_t>(needed_); }
  /// Whether the component of a triangle has more strips than its lower bound.
  [[nodiscard]] bool can_spare(Triangle t) const {
    const Component& component = components_[component_[t]];
    return component.strips > component.needed();
  }

 private:
  struct Component {
    std::ptrdiff_t strips = 0;
    std::ptrdiff_t tips = 0;  // triangles with at most one neighbour
    [[nodiscard]] std::ptrdiff_t needed() const noexcept { return tips > 2 ? (tips + 1) / 2 : 1; }
  };
  [[nodiscard]] static std::ptrdiff_t tips(const StripMesh& mesh, const std::vector<Triangle>& patch);

  std::vector<std::uint32_t> component_;  // of each triangle
  std::vector<Component> components_;
  std::ptrdiff_t needed_ = 0;
  std::uint32_t split_ = 0;  // the component of the current split
};

/// A lower bound for any colouring. Linear time.
[[nodiscard]] inline std::size_t strips_at_least(const StripMesh& mesh) { return ComponentStrips(mesh).needed(); }

class TrailSearch {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Trails of at most this many solid edges are tried.
  static constexpr unsigned longest = 32;

  /// Joins two strips by the shortest trail from one of `ends` that it can find within `max_states` edges walked or
  /// triangles measured. True if it succeeded: colours and locator are then updated, and flips() are the edges of the
  /// trail. Deterministic.
  bool join(StripMesh& mesh, StripLocator& locator, const std::vector<Triangle>& ends, std::size_t max_states);

  /// The trail of the last success. Its edges were dashed, solid, ..., dashed before it; now each has the other colour.
  [[nodiscard]] const std::vector<Halfedge>& flips() const noexcept { return trail_; }
  [[nodiscard]] std::size_t states() const noexcept { return states_; }

 private:
  static constexpr std::uint8_t far = 255;
  static_assert(longest < far);
  /// Distances, in solid edges, of a triangle that a trail leaves across a dashed edge.
  struct EndDistances {
    std::uint8_t here = far;    // from the nearest start
    std::uint8_t first = far;   // to the nearest end
    std::uint8_t second = far;  // to the nearest other end
    Triangle target = none;     // that nearest end
  };
  struct Arrival {
    Triangle triangle;
    Triangle target;
    unsigned solid;
  };
  template <class Visit>
  void for_each_neighbor(Triangle t, bool solid, Visit&& visit) const;
  void measure(const std::vector<Triangle>& ends, unsigned radius);
  void forget_distances();
  [[nodiscard]] unsigned solid_edges_from(Triangle t) const;
  bool walk_on(Triangle end, unsigned solid_left);
  [[nodiscard]] bool closes_no_cycle();
  void toggle(Halfedge h);
  void take_back();

  StripMesh* mesh_ = nullptr;
  StripLocator* locator_ = nullptr;
  std::vector<std::uint8_t> on_trail_;  // by halfedge
  std::vector<Halfedge> trail_;
  std::vector<EndDistances> distances_;  // by triangle
  std::vector<Triangle> met_;            // triangles with a known entry in distances_
  std::vector<Triangle> targets_;
  std::vector<Arrival> back_;
  Triangle not_to_ = none;  // the start of the trail, if the trail must not return to it
  std::size_t states_ = 0;
  std::size_t last_state_ = 0;

  // The strips as cut by the trail, during the test for cycles.
  struct Cut {
    std::uint32_t strip;
    std::uint64_t order;  // of the first triangle after the cut
    friend auto operator<=>(const Cut&, const Cut&) = default;
  };
  struct Piece {
    std::uint32_t strip;
    std::size_t number;  // the number of earlier cuts
    std::size_t joined;  // parent in union-find
  };
  [[nodiscard]] Cut place_of(Triangle t) const;
  std::size_t piece_of(Triangle t);
  std::vector<Cut> cuts_;
  std::vector<Piece> pieces_;
};

}  // namespace restrip::tools
