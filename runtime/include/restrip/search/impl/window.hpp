// Window: finds the cheapest colours of a few triangles exactly.
//
// A window is a set of triangles, usually a ball around one. The dual edges between two of its triangles may change
// their colours; all others are frozen. Of all valid colourings of the mesh that differ only in those edges the window
// takes a cheapest one. Ties are broken at random, so that a window without a gain still leads to another colouring,
// which other windows may improve; or, if each changed colour has to be stored, by the fewest changes (Ties).
//
// Method. The triangles are coloured one by one. The rest of the window depends only on this, for each edge on the
// frontier of the coloured part: whether it is dashed, or else how the strip turns in front of it, and where it comes
// from: another edge of the frontier, or a strip's end, which begins with the right or the wrong turn. Of all
// colourings that agree in this the cheapest is kept (a dynamic program over a path decomposition). Walks along the
// strips outside find which edges out of the window they join, so solid cycles are detected wherever they would close.
//
//   Window window(Cost::indices(), 1);
//   const WindowChange change = window.around(mesh, triangle, {.triangles = 40});
//
// The price of a colouring is as in cost.hpp. With Windings::priced a strip that begins with the wrong turn from both
// ends counts as one more swap, as in a written index buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/precondition.hpp"
#include "restrip/search/impl/descent.hpp"
#include "restrip/search/impl/pseudo_random.hpp"
#include "restrip/search/impl/window_plan.hpp"
#include "restrip/search/impl/window_search.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

struct WindowLimits {
  static constexpr std::uint32_t no_limit = (std::numeric_limits<std::uint32_t>::max)();
  /// The size of a ball, at most Window::max_triangles; smaller if the connected component is.
  std::uint32_t triangles = 40;
  /// Partial colourings more than this much above the cheapest are dropped, except the present one. Measured in thirds
  /// of a strip, or in swaps if these cost more. With no_limit the result is always a cheapest colouring; 2
  /// occasionally misses one, in a fraction of the time.
  std::uint32_t slack = 2;
  /// The number of cheapest different frontiers of one part that are followed; no_limit as above.
  std::uint32_t states = 4096;
};

/// The changes by a window.
struct WindowChange {
  ColoringChange change;
  int windings = 0;     ///< strips that begin with the wrong turn from both ends
  bool proven = false;  ///< the limits had no effect: no cheaper colouring of the window exists
};

/// Whether strips that begin with the wrong turn from both ends cost something.
enum class Windings : std::uint8_t { ignored, priced };

/// The choice among several cheapest colourings.
enum class Ties : std::uint8_t {
  random,         ///< one at random
  fewest_changes  ///< one that changes the fewest edges, so none if nothing is cheaper; else at
                  ///< random
};

/// Sums over all calls.
struct WindowCounts {
  std::uint64_t windows = 0;
  std::uint64_t refused = 0;  ///< windows whose frontier is too wide or whose strips are too long outside
  std::uint64_t tried = 0;    ///< colourings of a triangle tried; proportional to the time
  std::uint64_t walked = 0;   ///< triangles walked past outside
};

class Window {
 public:
  static constexpr std::size_t max_triangles = 100;

  /// Equal seeds and equal calls give equal results, on every machine.
  explicit Window(Cost cost = Cost::indices(), std::uint64_t seed = 1, Windings windings = Windings::priced,
                  Ties ties = Ties::random) noexcept
      : cost_(cost), random_(seed), search_(cost, windings == Windings::priced, ties == Ties::fewest_changes) {}

  /// Optimises a ball around a triangle, which must be alive. The mesh must have a valid colouring, and has one after
  /// each single change of a colour. The price of the whole mesh never rises. Time: the search, which depends only on
  /// the limits, and walks along the strips that leave the window, of up to 10,000 triangles each; beyond that the
  /// window is refused and nothing changes. After warm-up nothing is allocated, except for the list of changes of a
  /// watched mesh.
  ///
  /// Throws std::bad_alloc; nothing has changed then, or the mesh is watched and its colouring is valid.
  WindowChange around(SidedMesh auto& mesh, Triangle middle, const WindowLimits& limits = {});
  /// Optimises a window of these triangles: alive, all different, at most max_triangles.
  WindowChange inside(SidedMesh auto& mesh, std::span<const Triangle> triangles, const WindowLimits& limits = {});

  /// The triangles of the last window.
  [[nodiscard]] std::span<const Triangle> triangles() const noexcept { return ball_; }
  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] WindowCounts counts() const noexcept { return {windows_, refused_, search_.tried(), plan_.walked()}; }

  /// Visits the numbers on which later results depend, as std::uint64_t: for searches that are saved and resumed.
  template <class Visit>
  void visit_state(Visit&& visit) {
    random_.visit_state(visit);
    plan_.visit_state(visit);
  }

 private:
  WindowChange solve(SidedMesh auto& mesh, const WindowLimits& limits);

  Cost cost_;
  detail::PseudoRandom random_;
  std::vector<Triangle> ball_;
  detail::LocalNumbers in_ball_;
  std::vector<Triangle> hollows_;
  detail::WindowPlan plan_;
  detail::WindowSearch search_;
  std::uint64_t windows_ = 0;
  std::uint64_t refused_ = 0;
};

// The ball grows ring by ring, in an order drawn at random. A triangle with two neighbours inside is added immediately,
// so that the rim is short.
WindowChange Window::around(SidedMesh auto& mesh, Triangle middle, const WindowLimits& limits) {
  const auto size = std::min<std::size_t>(limits.triangles, max_triangles);
  ball_.clear();
  in_ball_.clear();
  const auto inside = [&](Triangle t) { return in_ball_[t] != detail::LocalNumbers::absent; };
  const auto add = [&](Triangle t) {
    in_ball_.add(t, 0);
    ball_.push_back(t);
  };
  const auto neighbor = [&](Triangle t, unsigned side) {
    const auto there = mesh.opposite(StripMesh::halfedge(t, side));
    return StripMesh::on_boundary(there) ? none : StripMesh::triangle(there);
  };
  add(middle);
  for (std::size_t next = 0; next < ball_.size() && ball_.size() < size; ++next) {
    const unsigned first_side = random_.below(3);
    for (unsigned turn = 0; turn < 3 && ball_.size() < size; ++turn) {
      const Triangle adjacent = neighbor(ball_[next], (first_side + turn) % 3);
      if (adjacent == none || inside(adjacent)) continue;
      add(adjacent);
      hollows_.assign(1, adjacent);
      while (!hollows_.empty() && ball_.size() < size) {
        const Triangle t = hollows_.back();
        hollows_.pop_back();
        for (unsigned s = 0; s < 3 && ball_.size() < size; ++s) {
          const Triangle hollow = neighbor(t, s);
          if (hollow == none || inside(hollow)) continue;
          unsigned sides_inside = 0;
          for (unsigned side = 0; side < 3; ++side)
            if (const Triangle around = neighbor(hollow, side); around != none && inside(around)) ++sides_inside;
          if (sides_inside < 2) continue;
          add(hollow);
          hollows_.push_back(hollow);
        }
      }
    }
  }
  return solve(mesh, limits);
}

WindowChange Window::inside(SidedMesh auto& mesh, std::span<const Triangle> triangles, const WindowLimits& limits) {
  RESTRIP_ASSERT(triangles.size() <= max_triangles, "Window::inside", "the window has too many triangles");
  ball_.assign(triangles.begin(), triangles.end());
  return solve(mesh, limits);
}

WindowChange Window::solve(SidedMesh auto& mesh, const WindowLimits& limits) {
  ++windows_;
  if (!plan_.make(mesh, ball_)) {
    ++refused_;
    return {};
  }
  // A third of a strip is two thirds of an end.
  const std::uint64_t third = std::max<std::uint64_t>({cost_.restart, std::uint64_t{3} * cost_.swap, cost_.isolated});
  const auto slack = limits.slack == WindowLimits::no_limit ? (std::numeric_limits<std::int64_t>::max)()
                                                            : static_cast<std::int64_t>(2 * third * limits.slack / 3);
  search_.run(plan_.triangles(), plan_.steps(), slack, limits.states, random_);
  // Edges that become dashed are cleared before others are set.
  for (const bool solid : {false, true})
    for (std::size_t i = 0; i < plan_.steps().size(); ++i) {
      const detail::WindowTriangle& here = plan_.triangles()[plan_.steps()[i].first];
      const unsigned changed = (here.present ^ search_.best()[i]) & here.leaving;
      for (unsigned s = 0; s < 3; ++s)
        if ((changed >> s & 1U) != 0 && ((search_.best()[i] >> s & 1U) != 0) == solid)
          mesh.set_solid(StripMesh::halfedge(here.triangle, s), solid);
    }
  const detail::WindowTally& now = search_.tally_of_best();
  const detail::WindowTally& before = search_.tally_of_present();
  return {{(now.ends - before.ends) / 2, now.swaps - before.swaps, now.isolated - before.isolated},
          now.windings - before.windings,
          search_.proven()};
}

}  // namespace restrip
