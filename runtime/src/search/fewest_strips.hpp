// FewestStrips: the engine of a Keeper under the cost of strips. fewest_strips.cpp tells the method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/policy.hpp"
#include "search/steps.hpp"
#include "search/strip_locator.hpp"
#include "search/tunnel.hpp"

namespace restrip::detail {

class FewestStrips {
 public:
  explicit FewestStrips(const PolicyRow& row) : search_(row.search), joins_(row.policy != Policy::rules) {}

  /// True if the mesh must be read before the next operation.
  bool set_search(Search search) noexcept {
    const bool had_locator = tunnels();
    search_ = search;
    return !had_locator && tunnels();
  }
  [[nodiscard]] bool tunnels() const noexcept { return search_.states != 0; }
  [[nodiscard]] const StripLocator& locator() const noexcept { return locator_; }
  [[nodiscard]] const TunnelCounts& counts() const noexcept { return tunnel_.counts(); }
  void reserve(std::size_t triangles) { locator_.reserve(triangles); }

  /// Reads the mesh and returns the number of its strips.
  std::size_t rebuild(const StripMesh& mesh);
  Rewrite perform(StripMesh& mesh, RuleChoice& choice, const Step& step);
  /// Rounds over all strip ends, of about `budget` states.
  ColoringChange improve(StripMesh& mesh, std::size_t budget);

 private:
  Rewrite tunnel_from_patch(StripMesh& mesh, RuleChoice& choice, const Step& step);
  ColoringChange tunnelled(StripMesh& mesh, int isolated, MayIsolate may_isolate);
  [[nodiscard]] std::uint32_t states_now() const noexcept;

  Search search_;
  bool joins_;  // ends that meet, if the policy does not tunnel
  StripLocator locator_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};  // background work
  std::size_t triangles_ = 0;       // while a locator exists
  std::vector<Triangle> patch_;
};

}  // namespace restrip::detail
