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

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/descent.hpp"
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

}  // namespace restrip

#include "restrip/search/impl/window.hpp"
