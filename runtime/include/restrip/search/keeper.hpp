// Keeper: maintains the strips of a mesh through every operation, under a policy.
//
// Every operation begins with its proven rule (operations.hpp), which reads one patch. A policy (policy.hpp) says what
// follows. The steps after the rule only lower the cost, so an operation adds at most what a rule adds at most
// (docs/explanation/theory.md, "What an operation adds"). One of two engines takes these steps: src/search/
// fewest_strips.cpp under the cost of strips, src/search/lowest_cost.cpp under a cost that weighs swaps or isolated
// triangles, such as Cost::indices().
//
//   Keeper keeper(mesh);
//   keeper.collapse(chord); keeper.split(where); keeper.flip(h);
//   keeper.apply(table, h);                            // a custom operation
//   keeper.improve(10'000);                            // in idle time
//
// Complexity. An operation takes the time of its rule and of the searches and, if the policy tunnels, time linear in
// the patch and logarithmic in the length of the strips for the locator. The mean number of states in a search depends
// on the policy, not on the size of the mesh. After warm-up nothing is allocated beyond what the mesh itself allocates
// to grow.
//
// Exceptions (std::bad_alloc, and std::length_error of the mesh). The mesh and its colouring are valid after an
// exception: the operation, or the repair that follows it, is done completely, in part or not at all. The data of the
// keeper are then out of date: up_to_date() is false, locator() is null and the counts are stale until rebuild(), which
// the next operation calls itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/policy.hpp"

namespace restrip {

class StripLocator;

namespace detail {

class Step;

}  // namespace detail

/// Maintains the strips of one mesh. While a keeper is in use, colour and change the mesh only through it; after any
/// other change call rebuild(). The mesh must outlive the keeper and have a valid colouring (all dashed is valid;
/// check_coloring() in strips.hpp checks). Whenever the keeper reads the whole mesh, it throws std::invalid_argument if
/// the colouring is not valid.
class Keeper {
 public:
  using Halfedge = StripMesh::Halfedge;
  using Player = BakedPlayer;

  explicit Keeper(StripMesh& mesh, Policy policy = default_policy, Cost cost = default_cost);
  /// Plays baked strips (baked.hpp): split_record and collapse_record are then copied, while in step. Every other
  /// operation is done under Policy::local, and the keeper is out of step after it. `level`: records played so far.
  Keeper(StripMesh& mesh, const BakedRecords& records, std::size_t level = 0);
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  Keeper(Keeper&&) noexcept;
  Keeper& operator=(Keeper&&) noexcept;
  ~Keeper();

  /// Searches of any size: larger ones keep longer strips and take proportionally longer. For the cost of strips; takes
  /// effect with the next operation. Linear time if the locator has to be made.
  void set_search(Search search);
  /// The same for costs that weigh swaps or isolated triangles.
  void set_plan(const IndexPlan& plan) noexcept;

  /// The operations of operations.hpp and apply.hpp, with the same preconditions. `strips` and `isolated` of the result
  /// include the changes by searches and repairs, so `strips` is often negative. Under `bare` an operation with a table
  /// makes all edges of its patch dashed.
  Rewrite split(const VertexSplit& where, Vertex new_vertex = none);
  Rewrite collapse(Halfedge chord);
  Rewrite flip(Halfedge h);
  Rewrite apply(const OperationView& table, Halfedge where, NewVertices* added = nullptr);
  /// Any triangles replaced by any others (StripMesh::replace), without a rule: edges of the removed triangles are
  /// cleared, then the policy searches among the new triangles and next to the removed ones. Quadratic in both.
  Rewrite replace(std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in);

  /// Split and collapse of a record of baked strips; by the rules if the keeper is not in step with it.
  Rewrite split_record(std::size_t record, const VertexSplit& where, Vertex new_vertex = none);
  Rewrite collapse_record(std::size_t record, Halfedge chord);
  /// Null unless baked strips are played (BakedPlayer).
  [[nodiscard]] Player* baked() noexcept { return baked_ ? &*baked_ : nullptr; }
  [[nodiscard]] const Player* baked() const noexcept { return baked_ ? &*baked_ : nullptr; }

  /// Background work. Under the cost of strips it continues with rounds of tunnelling over all strip ends, of about
  /// `budget` states. Under other costs it continues with chains from all strip ends and swaps, of about `budget`
  /// moves, and does nothing once no chain gains, until the next operation. A state or a move takes a few hundred
  /// nanoseconds. Returns the cost saved.
  std::size_t improve(std::size_t budget);

  /// Reads the mesh again. Linear time. Throws std::invalid_argument if its colouring is not valid; the keeper must
  /// then not be used until rebuild() succeeds.
  void rebuild();
  /// What later results depend on besides the mesh, its colours, policy and cost.
  struct State {
    bool known = false;  ///< the counts
    std::size_t strips = 0;
    std::size_t swaps = 0;
    std::size_t isolated = 0;
    Cost cost;
    std::array<std::uint64_t, 3> searches{};
    std::optional<std::size_t> level;  ///< of baked strips, in step
  };
  [[nodiscard]] State state() noexcept;
  /// For a mesh that is again as it was when state() returned this: later results are the same as they were then.
  /// Constant time for a keeper without a locator, if the cost is the same.
  void return_to(const State& state);
  /// Another policy and cost, from the next operation on; background work continues where it was if the cost is the
  /// same, and baked strips are no longer played. Linear time. Throws as the constructor does; nothing has changed
  /// then.
  void keep(Policy policy, const Cost& cost);
  void reserve(std::size_t triangles);

  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  /// Not maintained while baked strips are played, because their records do not contain it.
  [[nodiscard]] std::size_t isolated() const noexcept { return isolated_; }
  /// Maintained under a cost that weighs swaps or isolated triangles; otherwise counted, in linear time.
  [[nodiscard]] std::size_t swaps() const;
  /// The cost of the whole colouring.
  [[nodiscard]] std::size_t cost() const noexcept {
    return weights().restart * strips_ + weights().swap * swaps_ + weights().isolated * isolated_;
  }
  /// Counts of rules used and not used in all operations so far.
  [[nodiscard]] const RuleCounts& rule_counts() const noexcept;
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] Policy policy() const noexcept { return policy_; }
  [[nodiscard]] const Cost& weights() const noexcept { return cost_; }
  /// False after an exception, until rebuild() or the next operation.
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }
  /// Null under policies without a locator, and while it is not up to date.
  [[nodiscard]] const StripLocator* locator() const noexcept;

 private:
  struct Engine;

  void begin();
  void leave_levels() noexcept;
  Rewrite perform(const detail::Step& step);
  Rewrite bare(const detail::Step& step);
  Rewrite counted(const Rewrite& done);

  StripMesh* mesh_;
  Policy policy_;
  Cost cost_;
  bool up_to_date_ = false;
  std::size_t strips_ = 0;
  std::size_t swaps_ = 0;
  std::size_t isolated_ = 0;
  std::optional<Player> baked_;
  std::unique_ptr<Engine> engine_;
};

/// The operations if their checks grant them, in every build.
Checked checked_split(Keeper& keeper, const VertexSplit& where, Vertex new_vertex = none);
Checked checked_collapse(Keeper& keeper, Halfedge chord);
Checked checked_flip(Keeper& keeper, Halfedge h);
Checked checked_apply(Keeper& keeper, const OperationView& table, Halfedge where);
Checked checked_replace(Keeper& keeper, std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in);

}  // namespace restrip
