// The list of all methods of keeping strips while the mesh changes. Whatever compares methods or selects one by name
// uses it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lod/bake.hpp"
#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/trace.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

// Maintainer: keeps the strips of one mesh while it changes. methods() below lists the ways of doing so; replays,
// walks, benchmarks and the paper's report know this interface alone.

/// The record number of an operation that plays no record of a progressive mesh.
inline constexpr std::size_t no_record = static_cast<std::size_t>(-1);

class Maintainer {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Where = VertexSplit;

  explicit Maintainer(StripMesh& on) : mesh_(on) {}
  Maintainer(const Maintainer&) = delete;
  Maintainer& operator=(const Maintainer&) = delete;
  virtual ~Maintainer() = default;

  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }

  /// Preconditions and results as in operations.hpp; `strips` and `isolated` count the whole mesh. `record`: the number
  /// of the record being played, or no_record; precomputed strips need it.
  virtual Rewrite split(const Where& where, Vertex v_t, std::size_t record) = 0;
  virtual Rewrite collapse(Halfedge chord, std::size_t record) = 0;
  virtual Rewrite flip(Halfedge h) = 0;
  /// What the method does to all strips between two operations. Call it after each of the operations above; play_up()
  /// and play_down() do so themselves.
  virtual ColoringChange between() { return {}; }

  /// Plays split records in order, finding the spokes by their vertices. `first` is the number of the first record. For
  /// timing: nothing is reported.
  void play_up(std::span<const Record> records, std::size_t first);
  /// Collapses them again, the last one first.
  void play_down(std::span<const Record> records, std::size_t first);

  /// The mesh or its colours have been changed from outside, to that level of the progressive mesh: reads it again.
  virtual void restart(std::size_t /*level*/) {}
  /// A fault in the data kept for the mesh; empty if none is found.
  [[nodiscard]] virtual std::string fault() const { return {}; }
  /// The outcomes of all rule lookups; zero if no rule is used.
  [[nodiscard]] virtual RuleCounts rule_counts() const { return {}; }

 protected:
  /// The same as split and collapse, if that costs less without the report.
  virtual void split_silently(const Where& where, Vertex v_t, std::size_t record) { split(where, v_t, record); }
  virtual void collapse_silently(Halfedge chord, std::size_t record) { collapse(chord, record); }

  StripMesh& mesh_;
};

/// The inputs of a maintainer, besides the mesh.
struct MaintainerInputs {
  Search search;                     ///< of methods that search
  Cost cost = Cost::strips();        ///< what to minimise, for methods that support several costs
  const BakedMesh* baked = nullptr;  ///< of methods that bake; must outlive the maintainer
};

/// One method of keeping strips.
struct Method {
  enum class Kind {
    mesh,   ///< the mesh alone, for comparison: keeps no strips, and after flips not even valid colours
    rules,  ///< the rules of the tables alone
    ours,
    paper  ///< as in the paper (paper_methods.cpp)
  };
  std::string name;  ///< on the command line and in every report
  std::string description;
  Kind kind = Kind::ours;
  /// Starts on a mesh with a valid colouring, which must outlive the maintainer. Baked strips are played while the mesh
  /// is at a baked level and continue by the rules elsewhere.
  std::function<std::unique_ptr<Maintainer>(StripMesh&, const MaintainerInputs&)> begin;
  Search search{};   ///< the default; 0 states: the method does not search and cannot be made to
  Search weighed{};  ///< the same for other costs than strips, where `states` counts the strip ends searched from after
                     ///< each operation (policy.hpp); 0 states: the method supports only strips
  bool bakes = false;  ///< precomputes the strips of all levels, so that a level always has the same strips

  [[nodiscard]] bool searches() const noexcept { return search.states != 0; }
  [[nodiscard]] bool weighs() const noexcept { return weighed.states != 0; }
  [[nodiscard]] const Search& search_under(const Cost& cost) const noexcept {
    return cost == Cost::strips() ? search : weighed;
  }
};

/// All of them: the mesh alone, the rules alone, ours from the least to the most costly, the paper's.
[[nodiscard]] const std::vector<Method>& methods();
/// The paper's: the four settings of two switches, named paper, paper-alone, paper-tunnel, paper-alone-tunnel
/// (paper_methods.cpp).
[[nodiscard]] std::vector<Method> paper_methods();
/// Throws std::invalid_argument if the name is unknown.
[[nodiscard]] const Method& method_named(const std::string& name);
/// The default method.
[[nodiscard]] const Method& default_method(bool strips_are_baked);

/// A method prepared for one progressive mesh: the coloured base, and precomputed strips.
class PreparedMethod {
 public:
  /// Parts that exist already.
  struct Given {
    std::optional<Search> search = std::nullopt;  ///< if not the default of the method
    std::optional<Cost> cost = std::nullopt;      ///< what to minimise; by default as the method says
    const StripMesh* base = nullptr;              ///< the base with strips from scratch
    const BakedMesh* baked = nullptr;             ///< must be baked from that mesh and outlive this
  };

  /// The mesh must outlive this. Stripifies the base, or bakes, which may throw BadInput and take long (bake.hpp).
  /// Throws std::invalid_argument if the method does not support the cost.
  PreparedMethod(const Method& method, const ProgressiveMesh& mesh, const Given& given);
  /// For the fewest strips.
  PreparedMethod(const Method& method, const ProgressiveMesh& mesh)
      : PreparedMethod(method, mesh, Given{.cost = Cost::strips()}) {}
  PreparedMethod(const std::string& method, const ProgressiveMesh& mesh) : PreparedMethod(method_named(method), mesh) {}

  [[nodiscard]] const Method& method() const noexcept { return *method_; }
  [[nodiscard]] const ProgressiveMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] const StripMesh& base() const noexcept { return base_; }
  [[nodiscard]] const Search& search() const noexcept { return search_; }
  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const BakedMesh* baked() const noexcept { return baked_; }    ///< null for methods that do not bake
  [[nodiscard]] double seconds_to_bake() const noexcept { return seconds_; }  ///< 0 if nothing was baked here

  /// Starts on a mesh, a copy of the base or of a later level (then call restart).
  [[nodiscard]] std::unique_ptr<Maintainer> begin(StripMesh& on) const {
    return method_->begin(on, {search_, cost_, baked_});
  }

 private:
  const Method* method_;
  const ProgressiveMesh* mesh_;
  Search search_;
  Cost cost_;
  std::shared_ptr<const BakedMesh> made_;
  const BakedMesh* baked_ = nullptr;
  StripMesh base_;
  double seconds_ = 0;
};

/// The claim in a trace of that method.
[[nodiscard]] Trace::Claim claim_of(const PreparedMethod& prepared);

/// A maintainer that records its operations (restrip/output/trace.hpp). Keeps strips as `maintainer` does, which must
/// already work on the mesh. `trace` starts with the current mesh, and again with each restart. It has one record per
/// operation, and another one for changes between two operations, if any. Both must outlive the result. Nothing else
/// may watch the mesh meanwhile.
[[nodiscard]] std::unique_ptr<Maintainer> traced(StripMesh& mesh, std::unique_ptr<Maintainer> maintainer,
                                                 Trace::Claim claim, std::optional<Trace>& trace);

}  // namespace restrip::tools
