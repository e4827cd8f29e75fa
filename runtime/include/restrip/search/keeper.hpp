// Keeper: maintains the strips of a mesh through every operation, under a policy.
//
// Every operation begins with its proven rule (operations.hpp), which reads one patch. A policy (policy.hpp) says what
// follows. Under costs that weigh swaps or isolated triangles, a policy that searches may keep the colours before a
// split or collapse instead, if they cost no more. The steps after that only lower the cost, so what an operation adds
// is bounded (docs/explanation/theory.md, "What an operation adds"). One of two engines takes these steps: src/search/
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
// on the policy, not on the size of the mesh. After warm-up splits, collapses and flips allocate nothing beyond what
// the mesh itself allocates to grow; other operations also allocate short lists of the sides that they join.
//
// Exceptions (std::bad_alloc, and std::length_error of the mesh). The mesh and its colouring are valid after an
// exception: the operation, or the repair that follows it, is done completely, in part or not at all. The data of the
// keeper are then out of date: up_to_date() is false and the counts are stale until rebuild(), which the next
// operation calls itself.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/search/policy.hpp"

namespace restrip {

class Keeper;
class StripLocator;

namespace detail {

class Step;
/// Null under policies without a locator, and while the keeper is not up to date.
[[nodiscard]] const StripLocator* locator_of(const Keeper& keeper) noexcept;

}  // namespace detail

/// Maintains the strips of one mesh. While a keeper is in use, colour and change the mesh only through it; after any
/// other change call rebuild(). The mesh must outlive the keeper and have a valid colouring (all dashed is valid;
/// check_coloring() in strips.hpp checks). Whenever the keeper reads the whole mesh, it throws std::invalid_argument if
/// the colouring is not valid.
class Keeper {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit Keeper(StripMesh& mesh, Policy policy = default_policy, Cost cost = default_cost);
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  Keeper(Keeper&&) noexcept;
  Keeper& operator=(Keeper&&) noexcept;
  ~Keeper();

  /// Searches of any size: larger ones keep longer strips and take proportionally longer. For the cost of strips; takes
  /// effect with the next operation. Linear time if the locator has to be made. Does nothing under `bare`.
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

  /// Background work. Under the cost of strips it continues with rounds of tunnelling over all strip ends, of about
  /// `budget` states. Under other costs it continues with chains from all strip ends and swaps, of about `budget`
  /// moves, and does nothing once no chain gains, until the next operation. A state or a move takes a few hundred
  /// nanoseconds. Returns the cost saved.
  std::size_t improve(std::size_t budget);

  /// Reads the mesh again. Linear time. Throws std::invalid_argument if its colouring is not valid; the keeper must
  /// then not be used until rebuild() succeeds.
  void rebuild();
  /// The mesh has changed without the keeper: up_to_date() is false until the next operation.
  void forget() noexcept { up_to_date_ = false; }
  struct Counts {
    std::size_t strips = 0;
    std::size_t swaps = 0;  ///< 0 under a cost that weighs neither swaps nor isolated triangles
    std::size_t isolated = 0;
  };
  /// None if not up to date.
  [[nodiscard]] std::optional<Counts> counts() const noexcept {
    return up_to_date_ ? std::optional(counts_) : std::nullopt;
  }
  /// For a mesh that is again as it was when counts() returned these, under the present policy and cost. Constant time,
  /// but rebuild() without counts and for a keeper with a locator.
  void return_to(const std::optional<Counts>& counts);
  /// Another policy and cost, from the next operation on. Linear time. Throws as the constructor does; nothing has
  /// changed then.
  void keep(Policy policy, const Cost& cost);
  void reserve(std::size_t triangles);

  [[nodiscard]] std::size_t strips() const noexcept { return counts_.strips; }
  [[nodiscard]] std::size_t isolated() const noexcept { return counts_.isolated; }
  /// Maintained under a cost that weighs swaps or isolated triangles; otherwise counted, in linear time.
  [[nodiscard]] std::size_t swaps() const;
  /// The cost of the whole colouring.
  [[nodiscard]] std::size_t cost() const noexcept {
    return cost_.restart * counts_.strips + cost_.swap * counts_.swaps + cost_.isolated * counts_.isolated;
  }
  /// Counts of rules used and not used in all operations so far.
  [[nodiscard]] const RuleCounts& rule_counts() const noexcept;
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] Policy policy() const noexcept { return policy_; }
  [[nodiscard]] const Cost& weights() const noexcept { return cost_; }
  /// False after an exception, until rebuild() or the next operation.
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }

 private:
  struct Engine;
  friend const StripLocator* detail::locator_of(const Keeper& keeper) noexcept;

  void begin();
  Rewrite perform(const detail::Step& step);
  Rewrite bare(const detail::Step& step);
  Rewrite counted(const Rewrite& done);

  StripMesh* mesh_;
  Policy policy_;
  Cost cost_;
  bool up_to_date_ = false;
  Counts counts_;
  std::unique_ptr<Engine> engine_;
};

/// The operations if their checks grant them, in every build.
Checked checked_split(Keeper& keeper, const VertexSplit& where, Vertex new_vertex = none);
Checked checked_collapse(Keeper& keeper, Halfedge chord);
Checked checked_flip(Keeper& keeper, Halfedge h);
Checked checked_apply(Keeper& keeper, const OperationView& table, Halfedge where);
Checked checked_replace(Keeper& keeper, std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in);

}  // namespace restrip
