// WindowRounds: exact windows (window.hpp) around all strip ends and swaps of a mesh, again and again. Strips from
// scratch, and improvement in the background.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/impl/window.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

/// Visits the triangles of a mesh in the order of their handles and optimises a window around each that is a strip end
/// or, if swaps cost something, part of a swap. Elsewhere a colouring cannot be cheaper. Windows without a gain choose
/// at random among equal colourings, so every round starts from different colours.
class WindowRounds {
 public:
  static constexpr std::uint64_t no_limit = (std::numeric_limits<std::uint64_t>::max)();

  /// The budget of a round of windows of 20 triangles: twice the work of a whole round on meshes with 1.3 indices per
  /// triangle. A round exceeds it only if strips are thousands of triangles long, so rounds take linear time.
  static constexpr std::uint64_t round_budget(std::uint64_t triangles) noexcept { return 200 * triangles; }

  explicit WindowRounds(Cost cost = Cost::indices(), std::uint64_t seed = 1,
                        Windings windings = Windings::priced) noexcept
      : window_(cost, seed, windings) {}

  /// Continues where the last call stopped, at most once through the mesh, until about `budget` colourings of a
  /// triangle have been tried (one window may exceed it). Eight triangles that a window walks past, or 64 that the
  /// round passes, count as one. Returns the changes. The price of the mesh never rises. Deterministic: the same calls
  /// on the same mesh have the same result. One colouring costs about 50 ns.
  WindowChange run(SidedMesh auto& mesh, std::uint64_t budget, const WindowLimits& limits = {}) {
    WindowChange sum{{}, 0, true};
    const std::uint64_t stop = spent() + (std::min)(budget, no_limit - spent());
    for (std::size_t left = mesh.triangle_bound(); left > 0 && spent() < stop; --left) {
      if (next_ >= mesh.triangle_bound()) next_ = 0;
      const Triangle t = next_++;
      ++passed_;
      if (!mesh.alive(t) || !flawed(mesh, t)) continue;
      const WindowChange done = window_.around(mesh, t, limits);
      sum.change += done.change;
      sum.windings += done.windings;
      sum.proven &= done.proven;
    }
    return sum;
  }

  /// The work of all calls, in units of the budget.
  [[nodiscard]] std::uint64_t spent() const noexcept {
    return window_.counts().tried + window_.counts().walked / 8 + passed_ / 64;
  }
  [[nodiscard]] WindowCounts counts() const noexcept { return window_.counts(); }
  /// As Window::visit_state.
  template <class Visit>
  void visit_state(Visit&& visit) {
    window_.visit_state(visit);
    std::uint64_t next = next_;
    std::uint64_t passed = passed_ % 64;
    visit(next);
    visit(passed);
    next_ = static_cast<Triangle>(next);
    passed_ = passed % 64;
  }

 private:
  [[nodiscard]] bool flawed(const SidedMesh auto& mesh, Triangle t) const {
    const unsigned solid = mesh.solid_sides(t);
    if (std::popcount(solid) < 2) return true;
    if (window_.cost().swap == 0) return false;
    for (unsigned s = 0; s < 3; ++s) {
      if ((solid >> s & 1U) == 0) continue;
      const auto h = StripMesh::halfedge(t, s);
      if (detail::is_swap(mesh.other_solid_sides(h), mesh.other_solid_sides(mesh.opposite(h))) != 0) return true;
    }
    return false;
  }

  Window window_;
  Triangle next_ = 0;
  std::uint64_t passed_ = 0;
};

}  // namespace restrip
