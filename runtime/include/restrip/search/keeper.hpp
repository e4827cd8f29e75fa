// Keeper: maintains the strips of any mesh through every operation, under a policy.
//
// Every operation begins with its proven rule (operations.hpp), which reads one patch. A policy (policy.hpp) says what
// follows. The steps after the rule only lower the cost, so an operation adds at most what a rule adds at most
// (docs/explanation/theory.md, "What an operation adds").
//
// Under the cost of strips the policies join ends of strips that meet (join.hpp), or search by tunnelling (tunnel.hpp)
// from every strip end in the patch, which needs a locator of the strips (strip_locator.hpp). When a strip breaks, its
// ends are known, and ends of other strips are near. (Porcu and Scateni tunnel when isolated triangles exceed a
// threshold. Immediate local tunnelling keeps the strips of every level of detail as long as strips made from scratch.)
//
// Under a cost that weighs swaps or isolated triangles, such as Cost::indices(), a split or collapse keeps the previous
// colours if they cost no more than the rule's. An operation with a table (apply.hpp, refine.hpp) takes the cheapest of
// its rule and the colours that join two ports only if they were joined before. A search at the strip ends of the patch
// (end_search.hpp) then lowers the cost; under Policy::best an exact window (window.hpp) follows. Fewest strips take 15
// to 25 % more indices than fewest indices.
//
//   Keeper keeper(mesh);                               // mesh: any NumberedMesh, such as a StripMesh
//   keeper.collapse(chord); keeper.split(where); keeper.flip(h);
//   keeper.apply(table, h);                            // a custom operation
//   keeper.improve(10'000);                            // in idle time
//
// Complexity. An operation takes the time of its rule and of the searches and, if the policy tunnels, time linear in
// the patch for the locator. The mean number of states in a search depends on the policy, not on the size of the mesh.
// So does the mean length of the strips, on which the locator depends, once strips have the length that the policy
// keeps. After warm-up nothing is allocated beyond what the mesh itself allocates to grow.
//
// Exceptions (std::bad_alloc, and what the mesh throws). The mesh and its colouring are valid after an exception: the
// operation, or the repair that follows it, is done completely, in part or not at all. The data of the keeper are then
// out of date: up_to_date() is false, locator() is null and the counts are stale until rebuild(), which the next
// operation calls itself. Under a cost that weighs swaps or isolated triangles, set_solid of a custom mesh must not
// throw: searches try colours and undo them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/impl/keeper_steps.hpp"
#include "restrip/search/impl/members.hpp"
#include "restrip/search/impl/rounds.hpp"
#include "restrip/search/impl/rule_choice.hpp"
#include "restrip/search/impl/strip_locator.hpp"
#include "restrip/search/impl/tunnel.hpp"
#include "restrip/search/impl/window_rounds.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

namespace detail {

/// The player of baked strips, on a mesh that can split and collapse.
template <class Mesh>
struct PlayerOf {
  void leave_step() const noexcept {}
  void restart(std::size_t /*level*/) const noexcept {}
  [[nodiscard]] bool in_step() const noexcept { return false; }
  [[nodiscard]] std::size_t level() const noexcept { return 0; }
  using type = PlayerOf;
};
template <class Mesh>
requires SplittableMesh<Mesh> && CollapsibleMesh<Mesh>
struct PlayerOf<Mesh> : std::type_identity<BakedPlayer<Mesh>> {
};

}  // namespace detail

/// Maintains the strips of one mesh. While a keeper is in use, colour and change the mesh only through it; after any
/// other change call rebuild(). The mesh must outlive the keeper and have a valid colouring (all dashed is valid;
/// check_coloring() in strips.hpp checks). Whenever the keeper reads the whole mesh, it throws std::invalid_argument if
/// the colouring is not valid. It has the operations that the mesh has (mesh.hpp).
template <class Mesh>
class Keeper {
  static_assert(detail::has_members_of_numbered_mesh<Mesh>());

 public:
  using Halfedge = typename Mesh::Halfedge;
  using Player = typename detail::PlayerOf<Mesh>::type;

  explicit Keeper(Mesh& mesh, Policy policy = default_policy, Cost cost = default_cost)
      : mesh_(&mesh),
        search_(row_of(policy).search),
        plan_(row_of(policy).plan),
        policy_(policy),
        choice_(cost, cost.swap != 0 || cost.isolated != 0),
        ends_(cost),
        descent_(cost),
        windows_(cost, 1, Windings::ignored),
        window_(cost, 1, Windings::ignored) {
    rebuild();
  }
  /// Plays baked strips (baked.hpp): split_record and collapse_record are then copied, while in step. Every other
  /// operation is done under Policy::local, and the keeper is out of step after it. `level`: records played so far.
  Keeper(Mesh& mesh, const BakedRecords<Halfedge>& records, std::size_t level = 0)
      : Keeper(mesh, Policy::local, Cost::strips()) {
    baked_.emplace(mesh, records, level);
  }

  /// Takes effect with the next operation. Linear time if the locator has to be made.
  void set_policy(Policy policy) {
    policy_ = policy;
    plan_ = row_of(policy).plan;
    set_search(row_of(policy).search);
  }
  /// Searches of any size: larger ones keep longer strips and take proportionally longer.
  void set_search(Search search) {
    const bool had_locator = tunnels();
    search_ = search;
    if (!had_locator && tunnels()) rebuild();
  }
  /// The same for costs that weigh swaps or isolated triangles.
  void set_plan(const IndexPlan& plan) noexcept { plan_ = plan; }

  /// The operations of operations.hpp, with the same preconditions. `strips` and `isolated` of the result include the
  /// changes by searches and repairs, so `strips` is often negative. `name`: the new vertex, for meshes that let the
  /// caller name it.
  template <class... Name>
  Rewrite<Halfedge> split(const VertexSplit<Halfedge>& where, Name... name);
  Rewrite<Halfedge> collapse(Halfedge chord);
  Rewrite<Halfedge> flip(Halfedge h);
  /// The operations of refine.hpp, likewise. Under `bare` they are done as the split or collapse that changes the mesh
  /// in the same way, with the `valence` of that operation.
  Rewrite<Halfedge> split_face(Halfedge h);
  Rewrite<Halfedge> bisect(Halfedge h);
  Rewrite<Halfedge> join_faces(Halfedge chord);
  Rewrite<Halfedge> merge(Halfedge chord);

  /// Custom operations, see apply.hpp: on a StripMesh, or by a function that changes the mesh. Under `bare` all edges
  /// of the patch become dashed.
  template <SurfaceTable Table>
  Rewrite<Halfedge> apply(const Table& table, Halfedge where) requires std::same_as<Mesh, StripMesh>;
  template <SurfaceTable Table, class Change>
  Rewrite<Halfedge> apply(const Table& table, Halfedge where, Change&& change);

  /// Split and collapse of a record of baked strips; by the rules if the keeper is not in step with it.
  template <class... Name>
  Rewrite<Halfedge> split_record(std::size_t record, const VertexSplit<Halfedge>& where, Name... name);
  Rewrite<Halfedge> collapse_record(std::size_t record, Halfedge chord);
  /// Null unless baked strips are played (BakedPlayer).
  [[nodiscard]] Player* baked() noexcept { return baked_ ? &*baked_ : nullptr; }
  [[nodiscard]] const Player* baked() const noexcept { return baked_ ? &*baked_ : nullptr; }

  /// Background work. Under the cost of strips it continues with rounds over all strip ends (rounds.hpp), of about
  /// `budget` states. Under other costs it continues with a descent by chains over all triangles (descent.hpp), and
  /// once that has ended, until the next operation, with windows around all strip ends and swaps (window_rounds.hpp),
  /// of about `budget` moves and colourings, some 60 ns each. Returns the cost saved.
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
    std::array<std::uint64_t, 11> searches{};
    std::optional<std::size_t> level;  ///< of baked strips, in step
  };
  [[nodiscard]] State state() noexcept;
  /// For a mesh that is again as it was when state() returned this: later results are the same as they were then.
  /// Constant time for a keeper without a locator, if the cost is the same.
  void return_to(const State& state);
  /// Another policy and cost, from the next operation on; background work continues where it was, and baked strips are
  /// no longer played. Linear time. Throws as the constructor does; nothing has changed then.
  void keep(Policy policy, const Cost& cost);
  void reserve(std::size_t triangles) { locator_.reserve(triangles); }
  /// Visits the state and the counts of rules as std::uint64_t: for keepers that are saved and resumed. Rebuilds a
  /// keeper that is not up to date.
  template <class Visit>
  void visit_state(Visit&& visit);

  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  /// Not maintained while baked strips are played, because their records do not contain it.
  [[nodiscard]] std::size_t isolated() const noexcept { return isolated_; }
  /// Maintained under a cost that weighs swaps or isolated triangles; otherwise counted, in linear time.
  [[nodiscard]] std::size_t swaps() const { return weighs() ? swaps_ : count_swaps(*mesh_); }
  /// The cost of the whole colouring.
  [[nodiscard]] std::size_t cost() const noexcept {
    const Cost& weights = descent_.cost();
    return weights.restart * strips_ + weights.swap * swaps_ + weights.isolated * isolated_;
  }
  /// Counts of rules used and not used in all operations so far.
  [[nodiscard]] const RuleCounts& rule_counts() const noexcept { return choice_.counts(); }
  [[nodiscard]] const Mesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] Policy policy() const noexcept { return policy_; }
  [[nodiscard]] const Cost& weights() const noexcept { return descent_.cost(); }
  /// False after an exception, until rebuild() or the next operation.
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }
  /// Null under policies without a locator, and while it is not up to date.
  [[nodiscard]] const StripLocator* locator() const noexcept { return tunnels() && up_to_date_ ? &locator_ : nullptr; }
  /// Counts of tunnelling; of the searches at strip ends; the work of improve() under costs that weigh swaps or
  /// isolated triangles.
  [[nodiscard]] const TunnelCounts& counts() const noexcept { return tunnel_.counts(); }
  [[nodiscard]] const EndSearch& end_search() const noexcept { return ends_; }
  [[nodiscard]] std::uint64_t spent_by_improve() const noexcept { return descent_.counts().priced + windows_.spent(); }

 private:
  template <class Visit>
  void visit_searches(Visit&& visit);
  /// Whether the cost weighs swaps or isolated triangles.
  [[nodiscard]] bool weighs() const noexcept { return descent_.cost().swap != 0 || descent_.cost().isolated != 0; }
  [[nodiscard]] bool tunnels() const noexcept { return !weighs() && search_.states != 0; }

  void begin();
  template <class Step>
  Rewrite<Halfedge> perform(const Step& step);
  Rewrite<Halfedge> counted(const Rewrite<Halfedge>& done, bool improved);
  Rewrite<Halfedge> counted(Rewrite<Halfedge> done, const ColoringChange& change, bool improved);
  template <class Step>
  Rewrite<Halfedge> search_from_ends(const Step& step);
  Rewrite<Halfedge> searched(const Rewrite<Halfedge>& by_rule, bool counts_swaps, unsigned rings);
  template <class Step>
  Rewrite<Halfedge> tunnel_from_patch(const Step& step);
  Rewrite<Halfedge> tunnelled(const Rewrite<Halfedge>& by_rule, detail::MayIsolate may_isolate);

  Mesh* mesh_;
  Search search_;   // under the cost of strips
  IndexPlan plan_;  // under other ones
  Policy policy_;
  bool up_to_date_ = false;
  std::size_t strips_ = 0;
  std::size_t swaps_ = 0;
  std::size_t isolated_ = 0;
  std::optional<Player> baked_;
  detail::RuleChoice<Mesh> choice_;
  // For the cost of strips.
  StripLocator locator_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};
  std::size_t triangles_ = 0;  // while a locator exists
  std::vector<Triangle> patch_;
  // For other ones.
  EndSearch ends_;  // after an operation
  // For background work.
  Descent descent_;
  Triangle next_ = 0;          // of the descent
  std::size_t unsettled_ = 0;  // triangles that it still has to pass
  WindowRounds windows_;
  Window window_;  // after an operation and its search
  // For operations that do not count.
  detail::Surroundings<Mesh> around_;
};

}  // namespace restrip

#include "restrip/search/impl/keeper.hpp"

#ifdef RESTRIP_COMPILED
namespace restrip {

extern template class Keeper<StripMesh>;
extern template Rewrite<StripMesh::Halfedge> Keeper<StripMesh>::split(const VertexSplit<StripMesh::Halfedge>&);
extern template Rewrite<StripMesh::Halfedge> Keeper<StripMesh>::split(const VertexSplit<StripMesh::Halfedge>&, Vertex);

}  // namespace restrip
#endif
