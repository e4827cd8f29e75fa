// Lists of chunks that can be cut, joined and reversed: the upper level of StripLocator.
//
// A chunk knows its list, its rank in it, its two neighbours and whether it reads backwards, so a look costs one memory
// read. Cutting and joining rewrite the smaller part, which two walkers that start at the cut at the same time find.
// Occasionally the ranks of the larger part have drifted far and are rewritten, once for at least half the number of
// chunks joined to it. A chunk added in the middle takes the rank between its neighbours; if no rank is free, the
// smallest stretch of the list with room is spread out: amortised O(log n) ranks for each chunk added. (Bender, Cole,
// Demaine, Farach-Colton, Zito, "Two simplified algorithms for maintaining order in a list", 2002. The upper level of
// the two-level lists of Fredman, Johnson, McGeoch, Ostheimer, "Data structures for traveling salesmen", 1995. They
// reverse a list by one bit; here the smaller part is written again in any case. The smaller half is the rule of Even
// and Shiloach, "An on-line edge-deletion problem", 1981.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace restrip::detail {

class ChunkLists {
 public:
  using Id = std::uint32_t;
  static constexpr Id no_chunk = (std::numeric_limits<Id>::max)();

  struct Chunk {
    Id before = no_chunk;  // in the order of ranks
    Id after = no_chunk;
    std::uint32_t list = no_chunk;  // no_chunk: the chunk is not in use
    std::uint32_t rank = middle;    // grows along the list
    std::uint32_t count = 0;        // of triangles, used by the owner
    bool backwards = false;         // the chunk's own order is the reverse of the list's
    bool crowded = false;           // used by the owner, too
  };

  /// Joining and adding spread the ranks of a list again when they would be further than `reach` from the middle of
  /// their range. A power of two; smaller values are for tests.
  explicit ChunkLists(std::uint32_t reach = middle / 2) : reach_(reach) {}

  [[nodiscard]] const Chunk& operator[](Id c) const noexcept { return chunks_[c]; }
  [[nodiscard]] std::uint32_t& count(Id c) noexcept { return chunks_[c].count; }
  [[nodiscard]] bool& crowded(Id c) noexcept { return chunks_[c].crowded; }
  [[nodiscard]] bool in_use(Id c) const noexcept { return chunks_[c].list != no_chunk; }
  /// Number of lists.
  [[nodiscard]] std::size_t lists() const noexcept { return sizes_.size() - free_lists_.size(); }
  /// Number of chunks of a list.
  [[nodiscard]] std::uint32_t size(std::uint32_t list) const noexcept { return sizes_[list]; }

  void clear() noexcept {
    chunks_.clear();
    free_chunks_.clear();
    sizes_.clear();
    free_lists_.clear();
  }
  void reserve(std::size_t chunks, std::size_t lists) {
    chunks_.reserve(chunks);
    free_chunks_.reserve(chunks);
    sizes_.reserve(lists);
    free_lists_.reserve(lists);
  }

  /// Adds a chunk, in a new list.
  Id add() {
    const Id c = new_chunk();
    chunks_[c].list = new_list(1);
    return c;
  }
  /// Adds a chunk next to c, in the same list and direction as c. Amortised O(log(chunks of the list)).
  Id add_next_to(Id c, bool after) {
    const Id fresh = new_chunk();
    Chunk& chunk = chunks_[fresh];
    const Chunk& by = chunks_[c];
    const Id next = towards(by, after);
    chunk.list = by.list;
    chunk.backwards = by.backwards;
    const std::uint32_t rank = by.rank;
    chunk.rank = rank;
    connect(c, fresh, after);
    connect(fresh, next, after);
    const std::uint32_t size = ++sizes_[chunk.list];
    if (next == no_chunk) {
      if (from_middle(rank) + stride(size) > reach_)
        spread(fresh);
      else
        chunk.rank = after ? rank + stride(size) : rank - stride(size);
    } else {
      const std::uint32_t there = chunks_[next].rank;
      chunk.rank = after ? rank + (there - rank) / 2 : rank - (rank - there) / 2;
      if (chunk.rank == rank) make_room(fresh);
    }
    return fresh;
  }
  /// Removes a chunk from its list, and the list if it is then empty.
  void erase(Id c) {
    Chunk& chunk = chunks_[c];
    connect(chunk.before, chunk.after, true);
    if (--sizes_[chunk.list] == 0) free_lists_.push_back(chunk.list);
    chunk.list = no_chunk;
    free_chunks_.push_back(c);
  }

  /// Cuts the list of c after c (`after`) or before it. Does nothing at the end of a list.
  void cut(Id c, bool after) {
    Id low = after ? c : chunks_[c].before;
    Id high = after ? chunks_[c].after : c;
    if (low == no_chunk || high == no_chunk) return;
    chunks_[low].after = no_chunk;
    chunks_[high].before = no_chunk;
    std::uint32_t smaller = 1;
    Id down = chunks_[low].before;
    Id up = chunks_[high].after;
    while (down != no_chunk && up != no_chunk) {
      down = chunks_[down].before;
      up = chunks_[up].after;
      ++smaller;
    }
    const bool upwards = up == no_chunk;  // the part that is smaller
    sizes_[chunks_[c].list] -= smaller;
    const std::uint32_t list = new_list(smaller);
    for (Id at = upwards ? high : low; at != no_chunk; at = towards(chunks_[at], upwards)) chunks_[at].list = list;
  }
  /// Cuts, and adds a chunk at the cut, in the other part and in the same direction as c.
  Id cut_off(Id c, bool after) {
    const Id next = towards(chunks_[c], after);
    cut(c, after);
    const Id fresh = next == no_chunk ? add() : add_next_to(next, !after);
    chunks_[fresh].backwards = chunks_[c].backwards;
    return fresh;
  }
  /// Joins two lists: a and b, chunks at their ends, become neighbours. `a_last`: at a's high end; b the same.
  void join(Id a, bool a_last, Id b, bool b_last) {
    if (sizes_[chunks_[a].list] < sizes_[chunks_[b].list]) {
      std::swap(a, b);
      std::swap(a_last, b_last);
    }
    const std::uint32_t list = chunks_[a].list;
    const std::uint32_t gone = chunks_[b].list;
    const std::uint32_t moving = sizes_[gone];
    const std::uint32_t step = stride(sizes_[list] + moving);
    if (from_middle(chunks_[a].rank) + std::uint64_t{moving} * step > reach_) spread(a, step);
    const bool turn = a_last == b_last;
    std::uint32_t rank = chunks_[a].rank;
    for (Id last = a, at = b; at != no_chunk;) {
      Chunk& chunk = chunks_[at];
      const Id next = towards(chunk, !b_last);
      chunk.list = list;
      chunk.rank = rank = a_last ? rank + step : rank - step;
      chunk.backwards = chunk.backwards != turn;
      connect(last, at, a_last);
      (a_last ? chunk.after : chunk.before) = no_chunk;
      last = at;
      at = next;
    }
    sizes_[list] += moving;
    sizes_[gone] = 0;
    free_lists_.push_back(gone);
  }

 private:
  static constexpr std::uint32_t middle = 1U << 31;

  [[nodiscard]] static Id towards(const Chunk& chunk, bool after) noexcept {
    return after ? chunk.after : chunk.before;
  }
  // Makes b follow a, or precede it. Either may be no_chunk.
  void connect(Id a, Id b, bool after) noexcept {
    if (a != no_chunk) (after ? chunks_[a].after : chunks_[a].before) = b;
    if (b != no_chunk) (after ? chunks_[b].before : chunks_[b].after) = a;
  }
  [[nodiscard]] static std::uint32_t from_middle(std::uint32_t rank) noexcept {
    return rank < middle ? middle - rank : rank - middle;
  }
  // Between ranks at an end of a list of N chunks, or in all of it after spread(): then half the reach is left at
  // both ends.
  [[nodiscard]] std::uint32_t stride(std::uint32_t chunks) const noexcept {
    return std::clamp(reach_ / (chunks + 1), 1U, 1U << 16);
  }
  // Evenly spaced ranks about the middle, for the list of c.
  void spread(Id c) noexcept { spread(c, stride(sizes_[chunks_[c].list])); }
  void spread(Id c, std::uint32_t step) noexcept {
    while (chunks_[c].before != no_chunk) c = chunks_[c].before;
    std::uint32_t rank = middle - sizes_[chunks_[c].list] / 2 * step;
    for (; c != no_chunk; c = chunks_[c].after, rank += step) chunks_[c].rank = rank;
  }
  // Gives c, which has the rank of a neighbour, another rank: the ranks of the smallest aligned range around it that
  // is sparse enough are spaced evenly. A range of 2^i ranks is sparse when it holds no more than (2 / 1.25)^i chunks.
  void make_room(Id c) noexcept {
    const std::uint64_t rank = chunks_[c].rank;
    Id low = c;
    Id high = c;
    std::uint64_t count = 1;
    double sparse = 1;
    for (unsigned bits = 1;; ++bits) {
      sparse *= 2 / 1.25;
      const std::uint64_t from = rank >> bits << bits;
      const std::uint64_t to = from + (std::uint64_t{1} << bits);
      if (from < middle - reach_ || to > std::uint64_t{middle} + reach_) return spread(c);
      for (Id next = chunks_[low].before; next != no_chunk && chunks_[next].rank >= from; next = chunks_[low].before) {
        low = next;
        ++count;
      }
      for (Id next = chunks_[high].after; next != no_chunk && chunks_[next].rank < to; next = chunks_[high].after) {
        high = next;
        ++count;
      }
      if (static_cast<double>(count) > sparse) continue;
      const std::uint64_t step = (to - from) / count;
      std::uint64_t fresh = from + step / 2;
      for (Id at = low;; at = chunks_[at].after, fresh += step) {
        chunks_[at].rank = static_cast<std::uint32_t>(fresh);
        if (at == high) return;
      }
    }
  }
  // Puts an element at an unused place, or at the end.
  template <class Element>
  static std::uint32_t put(const Element& element, std::vector<Element>& all, std::vector<std::uint32_t>& unused) {
    if (unused.empty()) {
      all.push_back(element);
      return static_cast<std::uint32_t>(all.size() - 1);
    }
    const std::uint32_t place = unused.back();
    unused.pop_back();
    all[place] = element;
    return place;
  }
  std::uint32_t new_list(std::uint32_t size) { return put(size, sizes_, free_lists_); }
  Id new_chunk() { return put(Chunk{}, chunks_, free_chunks_); }

  std::vector<Chunk> chunks_;
  std::vector<Id> free_chunks_;
  std::vector<std::uint32_t> sizes_;  // of lists, in chunks
  std::vector<std::uint32_t> free_lists_;
  std::uint32_t reach_;
};

}  // namespace restrip::detail
