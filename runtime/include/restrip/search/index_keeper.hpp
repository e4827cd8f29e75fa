// IndexKeeper: split, collapse and flip while the cost of the colouring (cost.hpp) stays low: by default the indices of
// plain strips, 3 for each strip and 1 for each swap.
//
// StripKeeper (keeper.hpp) keeps the fewest strips, which costs 15 to 25 % more indices than the best. Here an
// operation passes its colours on as they are (a new triangle on a solid dual edge lengthens the strip that it cuts; a
// flip follows its rule), and a search at the strip ends around it (end_search.hpp) mends what it can. Nothing is kept
// beside the mesh but three counters, and a strip is some 20 triangles long, so that nothing depends on the size of the
// mesh.
//
// No rules of the index cost are used. Rules recolour a patch as well as can be with its ports as they are. Alone they
// keep far more indices, because they can neither give ports up nor take others; before the search they would gain a
// little, for half the time again to twice (docs/strips.md, "Fewest indices").
//
//   StripMesh mesh = ...;
//   IndexKeeper keeper(mesh, Policy::quick);
//   keeper.collapse(chord); keeper.split(where); keeper.flip(h);
//   keeper.improve(10'000);                            // in idle time
//
// After warm-up nothing is allocated but what the mesh itself allocates to grow.
//
// Exceptions (std::bad_alloc alone). The mesh and its colouring are valid after one: the operation, or the search that
// follows it, is done as a whole, in part or not at all. The counters are out of date: up_to_date() is false until
// rebuild(), which the next operation calls by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/descent.hpp"
#include "restrip/search/end_search.hpp"
#include "restrip/search/policy.hpp"

namespace restrip {

/// What follows an operation.
struct IndexPlan {
  /// Where the search begins.
  enum class From {
    joints,  ///< where strips do not go on: new triangles of a split, those that a collapse joins, the two of a flip
    patch,   ///< all triangles of the patch
    ring     ///< the same and their neighbours
  };
  From from = From::patch;
  EndLimits limits;
};

/// The searches of the policies.
[[nodiscard]] constexpr IndexPlan plan_of(Policy policy) noexcept {
  switch (policy) {
    case Policy::local:
      return {IndexPlan::From::joints, {.looks = 4}};
    case Policy::linked:
      return {IndexPlan::From::patch, {.looks = 5, .length = 2}};
    case Policy::quick:
      return {IndexPlan::From::patch, {.looks = 12, .length = EndSearch::max_length, .worse = 1}};
    case Policy::full:
      return {IndexPlan::From::ring, {.looks = 70, .length = EndSearch::max_length, .worse = 2}};
  }
  return {};
}

/// Keeps the colouring of one mesh. While a keeper is in use, colour and change the mesh through it alone; after any
/// other change call rebuild(). The mesh must outlive the keeper and have a valid colouring; the constructor and
/// rebuild() throw std::invalid_argument when it is not.
class IndexKeeper {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit IndexKeeper(StripMesh& mesh, Policy policy = Policy::quick, Cost cost = Cost::indices())
      : mesh_(&mesh), search_(cost), descent_(cost), plan_(plan_of(policy)) {
    rebuild();
  }

  /// From the next operation on.
  void set_policy(Policy policy) noexcept { plan_ = plan_of(policy); }
  void set_plan(const IndexPlan& plan) noexcept { plan_ = plan; }

  /// The operations of operations.hpp, with the same preconditions. `strips` and `isolated` of the result count what
  /// the search changed as well; last_change() also tells the swaps.
  Rewrite<Halfedge> split(const VertexSplit<Halfedge>& where, Vertex new_vertex = none);
  Rewrite<Halfedge> collapse(Halfedge chord);
  Rewrite<Halfedge> flip(Halfedge h);

  /// Background work: goes on with a descent by chains over all triangles, pricing about `budget` moves. Returns the
  /// cost it saved.
  std::size_t improve(std::size_t budget);

  /// Counts the mesh anew. Linear time.
  void rebuild();

  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  [[nodiscard]] std::size_t swaps() const noexcept { return swaps_; }
  [[nodiscard]] std::size_t isolated() const noexcept { return isolated_; }
  /// Of the whole colouring, in the weights of the cost.
  [[nodiscard]] std::size_t cost() const noexcept {
    const Cost& weights = descent_.cost();
    return weights.restart * strips_ + weights.swap * swaps_ + weights.isolated * isolated_;
  }
  /// What the last operation and its search changed.
  [[nodiscard]] const ColoringChange& last_change() const noexcept { return change_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  /// False after an exception, until rebuild() or the next operation.
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }
  /// Of the searches that follow operations, and of improve().
  [[nodiscard]] const EndCounts& counts() const noexcept { return search_.counts(); }
  [[nodiscard]] std::uint64_t walked() const noexcept { return search_.walked(); }
  [[nodiscard]] const DescentCounts& counts_of_improve() const noexcept { return descent_.counts(); }

 private:
  // The triangles whose colours a flip may change, and what they and their solid edges count.
  class Surroundings {
   public:
    void add(Triangle t) noexcept;
    void add_neighbors(const StripMesh& mesh, Triangle t) noexcept;
    // `strips` is the number of triangles less that of solid edges.
    [[nodiscard]] ColoringChange counted(const StripMesh& mesh) const noexcept;

   private:
    std::array<Triangle, 6> triangles_{};
    std::size_t count_ = 0;
  };

  void begin();
  [[nodiscard]] int swap_at(Halfedge h) const;
  void pass_through(Halfedge inner);
  void start_at(Halfedge h);
  Rewrite<Halfedge> split_any(const VertexSplit<Halfedge>& where, Vertex new_vertex);
  Rewrite<Halfedge> collapse_any(Halfedge chord);
  Rewrite<Halfedge> finish(Halfedge h, std::uint32_t valence);

  StripMesh* mesh_;
  EndSearch search_;  // after an operation
  Descent descent_;   // in the background
  IndexPlan plan_;
  std::size_t strips_ = 0;
  std::size_t swaps_ = 0;
  std::size_t isolated_ = 0;
  ColoringChange change_;
  bool up_to_date_ = false;
  Triangle next_ = 0;            // of improve()
  std::vector<Triangle> start_;  // where the search begins
};

}  // namespace restrip

#include "restrip/search/impl/index_keeper.hpp"
