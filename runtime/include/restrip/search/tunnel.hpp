// Tunnelling: joins two strips by a chain of alternating moves.
//
// From the end u of a strip go over a dashed edge to a triangle x, set that edge, and clear a solid edge (x, y): y is
// the new end. If x lies on u's strip, y must be the neighbour of x on u's side (a Pósa rotation); if x lies on another
// strip, y may be either neighbour. No move adds a strip or closes a cycle. If x is itself an end of another strip, no
// edge is cleared, and two strips have become one. (Pósa, "Hamiltonian circuits in random graphs", 1976; Stewart,
// "Tunneling for triangle strips in continuous level-of-detail meshes", 2001; Porcu, Scateni, "An iterative
// stripification algorithm based on dual graph operations", 2003.)
//
// The search simulates such chains breadth-first. A state is a list of *pieces*, stretches of the strips as the locator
// knows them, in the order in which the moves so far would join them. No triangle becomes the new end twice, so a
// search of n states has examined n different ends. If one triangle in d is an end, it takes about d states to find
// one. Only a successful chain, the shortest of those tried, changes colours and locator, or, on request, the chain to
// one state of a search that fails.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/search/sided_mesh.hpp"
#include "restrip/search/strip_locator.hpp"

namespace restrip {

/// The work of tunnelling so far.
struct TunnelCounts {
  std::size_t searches = 0;
  std::size_t states = 0;       ///< examined in all searches
  std::size_t joined = 0;       ///< searches that joined two strips
  std::size_t moves = 0;        ///< edges made solid
  std::ptrdiff_t isolated = 0;  ///< increase in isolated triangles
};

/// The search, with its memory. One object can run any number of searches on any mesh, one after the other; nothing is
/// allocated once its arrays have grown to the largest search.
class Tunnel {
 public:
  enum class OnFailure {
    stay,   ///< nothing changes
    wander  ///< the moves to the last state examined are made, and the strip ends there
  };

  /// Tries to join the strip that ends at `end` with another one, by examining at most `max_states` states. Returns
  /// true if the mesh now has one strip fewer. `locator` must belong to the mesh. Deterministic.
  ///
  /// A search that fails does not change the number of strips. After `wander` the next search starts from the far limit
  /// of this one.
  ///
  /// Complexity: O(max_states * length of the chains), where chains have about 5 moves at 100 states, 12 at 1,000, 25
  /// at 10,000. Does nothing when `end` is inside a strip.
  bool join(SidedMesh auto& mesh, StripLocator& locator, Triangle end, std::uint32_t max_states,
            OnFailure on_failure = OnFailure::stay);

  [[nodiscard]] const TunnelCounts& counts() const noexcept { return counts_; }

 private:
  using Halfedge = StripMesh::Halfedge;
  using Order = std::uint64_t;

  // A stretch of a strip: from low to high, or down from high to low. `last` of its path or not.
  struct Piece {
    Order low;
    Order high;
    std::uint32_t strip;
    std::uint32_t flags;

    static constexpr std::uint32_t down_flag = 1;
    static constexpr std::uint32_t last_flag = 2;
    [[nodiscard]] static Piece whole(std::uint32_t strip) noexcept { return {0, ~Order{0}, strip, last_flag}; }
    [[nodiscard]] bool down() const noexcept { return (flags & down_flag) != 0; }
    [[nodiscard]] bool last() const noexcept { return (flags & last_flag) != 0; }
    [[nodiscard]] bool has(Order order) const noexcept { return low <= order && order <= high; }
    [[nodiscard]] Order front() const noexcept { return down() ? high : low; }
    [[nodiscard]] Order back() const noexcept { return down() ? low : high; }
    // This stretch reversed, in the middle of a path.
    [[nodiscard]] Piece turned() const noexcept { return {low, high, strip, (flags & down_flag) ^ down_flag}; }
    [[nodiscard]] Piece from(Order x, bool upwards) const noexcept {
      return {upwards ? x : low, upwards ? high : x, strip, flags};
    }
  };
  // The paths after some moves: first the path that begins at `end`, then the others that differ from the locator.
  struct State {
    std::uint32_t parent;
    Halfedge join;  // the last move made the dual edge of `join` solid
    Halfedge cut;   // and the index of `cut`, a halfedge of the new end, dashed
    Order x;        // of the last move
    Order y;
    std::uint32_t where;        // the piece of the parent that x is in, or the name of its strip if no move touched it
    bool touched;               // which of the two
    std::uint32_t pieces = 0;   // when it has: the first one in pieces_,
    std::uint32_t current = 0;  // the number in the path of the new end,
    std::uint32_t total = 0;    // and in all paths
  };
  bool move(SidedMesh auto& mesh, StripLocator& locator, std::uint32_t s, Halfedge join, Triangle x);
  bool reach(SidedMesh auto& mesh, StripLocator& locator, const State& state);
  void lay_out(std::uint32_t s);
  Piece* room_for(State& state, std::uint32_t total);
  void commit(SidedMesh auto& mesh, StripLocator& locator, std::uint32_t s, Halfedge last_join = {});

  std::vector<State> states_;
  std::vector<Piece> pieces_;  // as large as in the largest search
  std::uint32_t used_ = 0;     // of pieces_
  std::vector<std::uint32_t> seen_;
  std::uint32_t search_ = 0;
  std::uint32_t max_states_ = 0;
  std::vector<std::uint32_t> chain_;
  TunnelCounts counts_;
};

}  // namespace restrip

#include "restrip/search/impl/tunnel.hpp"
