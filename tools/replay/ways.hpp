// The list of all ways of keeping strips while the mesh changes. Whatever compares ways or selects one by name uses it.
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
#include "restrip/output/trace.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

/// The inputs of an upkeep, besides the mesh.
struct Beginning {
  Search search;                     ///< of ways that search
  Cost cost = Cost::strips();        ///< what to minimise, for ways that support several costs
  const BakedMesh* baked = nullptr;  ///< of ways that bake; must outlive the upkeep
};

/// One way of keeping strips.
struct Way {
  enum class Kind {
    mesh,   ///< the mesh alone, for comparison: keeps no strips, and after flips not even valid colours
    rules,  ///< the rules of the tables alone
    ours,
    paper  ///< as in the paper (paper_ways.cpp)
  };
  std::string name;  ///< on the command line and in every report
  std::string says;  ///< a description
  Kind kind = Kind::ours;
  /// Starts on a mesh with a valid colouring, which must outlive the upkeep. Baked strips are played while the mesh is
  /// at a baked level and continue by the rules elsewhere.
  std::function<std::unique_ptr<Upkeep>(StripMesh&, const Beginning&)> begin;
  Search search{};   ///< the default; 0 states: the way does not search and cannot be made to
  Search weighed{};  ///< the same for other costs than strips, where `states` counts the strip ends searched from after
                     ///< each operation (policy.hpp); 0 states: the way supports only strips
  bool bakes = false;  ///< precomputes the strips of all levels, so that a level always has the same strips

  [[nodiscard]] bool searches() const noexcept { return search.states != 0; }
  [[nodiscard]] bool weighs() const noexcept { return weighed.states != 0; }
  [[nodiscard]] const Search& search_under(const Cost& cost) const noexcept {
    return cost == Cost::strips() ? search : weighed;
  }
};

/// All of them: the mesh alone, the rules alone, ours from the least to the most costly, the paper's.
[[nodiscard]] const std::vector<Way>& ways();
/// The paper's: the four settings of two switches, named paper, paper-alone, paper-tunnel, paper-alone-tunnel
/// (paper_ways.cpp).
[[nodiscard]] std::vector<Way> paper_ways();
/// Throws std::invalid_argument if the name is unknown.
[[nodiscard]] const Way& way_named(const std::string& name);
/// The default way.
[[nodiscard]] const Way& usual_way(bool strips_are_baked);

/// A way prepared for one progressive mesh: the coloured base, and precomputed strips.
class Plan {
 public:
  /// Parts that exist already.
  struct Given {
    std::optional<Search> search = std::nullopt;  ///< if not the default of the way
    std::optional<Cost> cost = std::nullopt;      ///< what to minimise; by default as the way says
    const StripMesh* base = nullptr;              ///< the base with strips from scratch
    const BakedMesh* baked = nullptr;             ///< must be baked from that mesh and outlive the plan
  };

  /// The mesh must outlive the plan. Stripifies the base, or bakes, which may throw BadInput and take long (bake.hpp).
  /// Throws std::invalid_argument if the way does not support the cost.
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
  [[nodiscard]] double seconds_to_bake() const noexcept { return seconds_; }  ///< 0 if nothing was baked here

  /// Starts on a mesh, a copy of the base or of a later level (then call restart).
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

/// The claim in a trace of that plan.
[[nodiscard]] Trace::Claim claim_of(const Plan& plan);

/// An upkeep that records its operations (restrip/output/trace.hpp). Keeps strips as `kept` does, which must already
/// work on the mesh. `trace` starts with the current mesh, and again with each restart. It has one record per
/// operation, and another one for changes between two operations, if any. Both must outlive the result. Nothing else
/// may watch the mesh meanwhile.
[[nodiscard]] std::unique_ptr<Upkeep> traced(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim,
                                             std::optional<Trace>& trace);

}  // namespace restrip::tools
