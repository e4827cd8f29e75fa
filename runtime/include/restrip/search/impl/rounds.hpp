// Rounds of tunnelling from every strip end of a mesh: strips from scratch, and improvement in the background.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "restrip/search/impl/strip_locator.hpp"
#include "restrip/search/impl/tunnel.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

/// Visits the strip ends of a mesh in the order of their handles, again and again, and searches from each (tunnel.hpp).
/// Searches start small and grow after a round that joined too few strips. At the largest size, ends whose search fails
/// wander, so that every round starts from other places.
class TunnelRounds {
 public:
  /// The sizes of the searches: from `first_states` to `last_states`, four times larger after a poor round.
  explicit TunnelRounds(std::uint32_t first_states = 64, std::uint32_t last_states = 4096)
      : first_(first_states), last_(last_states), states_(first_states) {}

  /// Continues where the last call stopped, until about `budget` states have been examined (one search may exceed it)
  /// or at most `enough` strips remain. Returns the number of states examined. One state of the largest searches costs
  /// a few hundred nanoseconds; walking past 64 triangles inside strips counts as one state. Deterministic: the same
  /// calls on the same mesh have the same result. `worth(t)` says whether to search from the end in t; by default from
  /// all ends.
  template <SidedMesh Mesh, std::predicate<Triangle> Worth>
  std::size_t run(Mesh& mesh, StripLocator& locator, Tunnel& tunnel, std::size_t budget, std::size_t enough,
                  Worth&& worth) {
    const std::size_t before = tunnel.counts().states;
    std::size_t passed = 0;
    const auto spent = [&] { return tunnel.counts().states - before + passed / 64; };
    while (locator.strips() > enough && spent() < budget) {
      if (next_ >= mesh.triangle_bound()) {
        const std::size_t strips = locator.strips();
        const bool poor = strips + strips / 8 >= strips_at_start_;
        if (poor) states_ = (std::min)(last_, states_ > last_ / 4 ? last_ : states_ * 4);
        strips_at_start_ = strips;
        next_ = 0;
        if (mesh.triangle_count() == 0) break;
      }
      const Triangle t = next_++;
      ++passed;
      if (!mesh.alive(t) || mesh.solid_degree(t) > 1 || !worth(t)) continue;
      const auto on_failure = states_ >= last_ ? Tunnel::OnFailure::wander : Tunnel::OnFailure::stay;
      tunnel.join(mesh, locator, t, states_, on_failure);
    }
    return spent();
  }
  std::size_t run(SidedMesh auto& mesh, StripLocator& locator, Tunnel& tunnel, std::size_t budget,
                  std::size_t enough = 1) {
    return run(mesh, locator, tunnel, budget, enough, [](Triangle) { return true; });
  }

  /// Starts with small searches again: for a mesh that has changed a lot.
  void restart() noexcept {
    states_ = first_;
    next_ = 0;
    strips_at_start_ = 0;
  }

  /// Visits the numbers on which later results depend, as std::uint64_t: for rounds that are saved and resumed.
  template <class Visit>
  void visit_state(Visit&& visit) {
    std::uint64_t states = states_;
    std::uint64_t next = next_;
    std::uint64_t strips = strips_at_start_;
    visit(states);
    visit(next);
    visit(strips);
    states_ = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(states, first_, last_));
    next_ = static_cast<Triangle>(next);
    strips_at_start_ = static_cast<std::uint32_t>(strips);
  }

 private:
  std::uint32_t first_;
  std::uint32_t last_;
  std::uint32_t states_;
  Triangle next_ = 0;
  std::size_t strips_at_start_ = 0;
};

}  // namespace restrip
