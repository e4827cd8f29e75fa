// The ways of keeping strips while the mesh changes, in one list: whatever compares ways, or is told one by name, takes
// them from here.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lod/bake.hpp"
#include "lod/progressive_mesh.hpp"
#include "replay/upkeep.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

/// What an upkeep begins with, besides the mesh.
struct Beginning {
  Search search;                     ///< of ways that search
  Cost cost = Cost::strips();        ///< of ways that weigh; what they keep low
  const BakedMesh* baked = nullptr;  ///< of ways that bake; must outlive the upkeep
};

/// One way of keeping strips.
struct Way {
  enum class Kind {
    mesh,   ///< the mesh alone, with which the others are compared: keeps no strips, after flips not even valid colours
    rules,  ///< the rules of the tables alone
    ours,
    paper  ///< as the paper did it (paper_ways.hpp)
  };
  std::string name;  ///< on the command line and in every report
  std::string says;  ///< what it does, for a reader
  Kind kind = Kind::ours;
  /// Begins on a mesh with a valid colouring, which must outlive the upkeep. Baked strips are played while the mesh is
  /// at a level that is baked, and continue by the rules elsewhere.
  std::function<std::unique_ptr<Upkeep>(StripMesh&, const Beginning&)> begin;
  Search search{};     ///< its own; one without states does not search, and takes no other
  Search weighed{};    ///< the same under other costs than strips, where `states` counts the strip ends looked at after
                       ///< each operation (policy.hpp); one without states: the way knows no other cost
  bool bakes = false;  ///< decides the strips of all levels beforehand, so that a level always has the same

  [[nodiscard]] bool searches() const noexcept { return search.states != 0; }
  [[nodiscard]] bool weighs() const noexcept { return weighed.states != 0; }
  /// What it keeps low unless set otherwise.
  [[nodiscard]] Cost usual_cost() const noexcept { return weighs() ? default_cost : Cost::strips(); }
  [[nodiscard]] const Search& search_under(const Cost& cost) const noexcept {
    return cost == Cost::strips() ? search : weighed;
  }
};

/// All of them: the mesh alone, the rules alone, ours from the least to the most costly, the paper's.
[[nodiscard]] const std::vector<Way>& ways();
/// Throws std::invalid_argument when none exists of that name.
[[nodiscard]] const Way& way_named(const std::string& name);
/// The way for whoever names none.
[[nodiscard]] const Way& usual_way(bool strips_are_baked);

/// A way made ready for one progressive mesh: the base in colours, and what was decided beforehand.
class Plan {
 public:
  /// What is there already and need not be made.
  struct Given {
    std::optional<Search> search = std::nullopt;  ///< other than the way's own
    std::optional<Cost> cost = std::nullopt;      ///< what is kept low; otherwise that of the way
    const StripMesh* base = nullptr;              ///< the base with strips from scratch
    const BakedMesh* baked = nullptr;             ///< must be baked from that mesh, and outlive the plan
  };

  /// The mesh must outlive the plan. Stripifies the base, or bakes, which may throw BadInput and take long (bake.hpp).
  /// Throws std::invalid_argument when the way knows no such cost.
  Plan(const Way& way, const ProgressiveMesh& mesh, const Given& given);
  /// For the fewest strips.
  Plan(const Way& way, const ProgressiveMesh& mesh) : Plan(way, mesh, Given{.cost = Cost::strips()}) {}
  Plan(const std::string& way, const ProgressiveMesh& mesh) : Plan(way_named(way), mesh) {}

  [[nodiscard]] const Way& way() const noexcept { return *way_; }
  [[nodiscard]] const ProgressiveMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] const StripMesh& base() const noexcept { return base_; }
  [[nodiscard]] const Search& search() const noexcept { return search_; }
  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const BakedMesh* baked() const noexcept { return baked_; }    ///< null for ways that do not bake
  [[nodiscard]] double seconds_to_bake() const noexcept { return seconds_; }  ///< 0 when nothing was baked here

  /// Begins on a mesh, a copy of the base or of a later level (then call restart).
  [[nodiscard]] std::unique_ptr<Upkeep> begin(StripMesh& on) const { return way_->begin(on, {search_, cost_, baked_}); }

 private:
  const Way* way_;
  const ProgressiveMesh* mesh_;
  Search search_;
  Cost cost_;
  std::shared_ptr<const BakedMesh> made_;
  const BakedMesh* baked_ = nullptr;
  StripMesh base_;
  double seconds_ = 0;
};

}  // namespace restrip::tools
