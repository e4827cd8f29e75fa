// Tunnelling: joins two strips by a chain of alternating moves; and rounds of it from every strip end of a mesh, for
// strips from scratch and for improvement in the background. tunnel.cpp tells the method.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "search/poll.hpp"
#include "search/strip_locator.hpp"

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
  bool join(StripMesh& mesh, StripLocator& locator, Triangle end, std::uint32_t max_states,
            OnFailure on_failure = OnFailure::stay);

  [[nodiscard]] const TunnelCounts& counts() const noexcept { return counts_; }

 private:
  using Halfedge = StripMesh::Halfedge;
  using Order = std::uint32_t;

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
  bool move(StripMesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge join, Triangle x);
  bool reach(StripMesh& mesh, StripLocator& locator, const State& state);
  void lay_out(std::uint32_t s);
  Piece* room_for(State& state, std::uint32_t total);
  void commit(StripMesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge last_join = {});

  std::vector<State> states_;
  std::vector<Piece> pieces_;  // as large as in the largest search
  std::uint32_t used_ = 0;     // of pieces_
  std::vector<std::uint32_t> seen_;
  std::uint32_t search_ = 0;
  std::uint32_t max_states_ = 0;
  std::vector<std::uint32_t> chain_;
  TunnelCounts counts_;
};

/// Visits the strip ends of a mesh in the order of their handles, again and again, and searches from each.
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
  /// calls on the same mesh have the same result. `worth(t)` says whether to search from the end in t; none: from
  /// all ends. `poll` may end it.
  std::size_t run(StripMesh& mesh, StripLocator& locator, Tunnel& tunnel, std::size_t budget, std::size_t enough = 1,
                  const std::function<bool(Triangle)>& worth = {}, detail::Poll* poll = nullptr);

  /// Starts with small searches again: for a mesh that has changed a lot.
  void restart() noexcept {
    states_ = first_;
    next_ = 0;
    strips_at_start_ = 0;
  }

 private:
  std::uint32_t first_;
  std::uint32_t last_;
  std::uint32_t states_;
  Triangle next_ = 0;
  std::size_t strips_at_start_ = 0;
};

}  // namespace restrip
