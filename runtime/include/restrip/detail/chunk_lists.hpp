// Lists of chunks, cut, joined and reversed: the upper level of StripIndex.
//
// A chunk knows its list, its rank in it, its two neighbours and whether it reads backwards, so a look costs one memory
// read. Cutting and joining rewrite the smaller part, which two walkers that start at the cut at the same time find;
// and now and then, when they have drifted far, the ranks of the larger one. (The upper level of the two-level lists of
// Fredman, Johnson, McGeoch, Ostheimer, "Data structures for traveling salesmen", 1995. They reverse a list by one bit;
// here the smaller part is written anew in any case. The smaller half is the rule of Even and Shiloach, "An on-line
// edge-deletion problem", 1981.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace restrip::detail {

class ChunkLists {
 public:
  using Id = std::uint32_t;
  static constexpr Id nobody = std::numeric_limits<Id>::max();

  struct Chunk {
    Id before = nobody;  // in the order of ranks
    Id after = nobody;
    std::uint32_t list = nobody;  // nobody: the chunk is not in use
    std::uint32_t rank = middle;  // grows along the list
    std::uint32_t count = 0;      // of triangles, for the owner's use
    bool backwards = false;       // the chunk's own order is the reverse of the list's
  };

  /// Joining spreads the ranks of a list anew when they would be further than `reach` from the middle of their range.
  /// Smaller values are for tests.
  explicit ChunkLists(std::uint32_t reach = middle / 2) : reach_(reach) {}

  [[nodiscard]] const Chunk& operator[](Id c) const noexcept { return chunks_[c]; }
  [[nodiscard]] std::uint32_t& count(Id c) noexcept { return chunks_[c].count; }
  [[nodiscard]] bool in_use(Id c) const noexcept { return chunks_[c].list != nobody; }
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

  /// A new chunk, in a list of its own.
  Id add() {
    const Id c = new_chunk();
    chunks_[c].list = new_list(1);
    return c;
  }
  /// A new chunk beside c, in the same list, that reads as c does. O(chunks) at worst: those that stand in the way move
  /// on by one rank.
  Id add_beside(Id c, bool after) {
    const Id fresh = new_chunk();
    Chunk& chunk = chunks_[fresh];
    const Chunk& by = chunks_[c];
    const Id next = towards(by, after);
    chunk.list = by.list;
    chunk.backwards = by.backwards;
    chunk.rank = after ? by.rank + 1 : by.rank - 1;
    connect(c, fresh, after);
    connect(fresh, next, after);
    ++sizes_[by.list];
    std::uint32_t taken = chunk.rank;
    for (Id at = next; at != nobody && chunks_[at].rank == taken; at = towards(chunks_[at], after))
      chunks_[at].rank = taken = after ? taken + 1 : taken - 1;
    return fresh;
  }
  /// Takes a chunk out of its list. A list without chunks is none.
  void erase(Id c) {
    Chunk& chunk = chunks_[c];
    connect(chunk.before, chunk.after, true);
    if (--sizes_[chunk.list] == 0) free_lists_.push_back(chunk.list);
    chunk.list = nobody;
    free_chunks_.push_back(c);
  }

  /// Cuts the list of c behind c (`after`) or before it. Nothing happens at the end of a list.
  void cut(Id c, bool after) {
    Id low = after ? c : chunks_[c].before;
    Id high = after ? chunks_[c].after : c;
    if (low == nobody || high == nobody) return;
    chunks_[low].after = nobody;
    chunks_[high].before = nobody;
    std::uint32_t smaller = 1;
    Id down = chunks_[low].before;
    Id up = chunks_[high].after;
    while (down != nobody && up != nobody) {
      down = chunks_[down].before;
      up = chunks_[up].after;
      ++smaller;
    }
    const bool upwards = up == nobody;  // the part that is smaller
    sizes_[chunks_[c].list] -= smaller;
    const std::uint32_t list = new_list(smaller);
    for (Id at = upwards ? high : low; at != nobody; at = towards(chunks_[at], upwards)) chunks_[at].list = list;
  }
  /// The same with a new chunk at the cut, which goes with the other part and reads as c does.
  Id cut_off(Id c, bool after) {
    const Id next = towards(chunks_[c], after);
    cut(c, after);
    const Id fresh = next == nobody ? add() : add_beside(next, !after);
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
    const std::uint32_t at_a = chunks_[a].rank;
    if ((at_a < middle ? middle - at_a : at_a - middle) + moving > reach_) spread(a, a_last);
    const bool turn = a_last == b_last;
    std::uint32_t rank = chunks_[a].rank;
    for (Id last = a, at = b; at != nobody;) {
      Chunk& chunk = chunks_[at];
      const Id next = towards(chunk, !b_last);
      chunk.list = list;
      chunk.rank = rank = a_last ? rank + 1 : rank - 1;
      chunk.backwards = chunk.backwards != turn;
      connect(last, at, a_last);
      (a_last ? chunk.after : chunk.before) = nobody;
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
  // Makes b follow a, or precede it. Either may be nobody.
  void connect(Id a, Id b, bool after) noexcept {
    if (a != nobody) (after ? chunks_[a].after : chunks_[a].before) = b;
    if (b != nobody) (after ? chunks_[b].before : chunks_[b].after) = a;
  }
  // Ranks one by one again, about the middle; c is at an end.
  void spread(Id c, bool is_last) noexcept {
    const std::uint32_t half = sizes_[chunks_[c].list] / 2;
    std::uint32_t rank = is_last ? middle + half : middle - half;
    for (Id at = c; at != nobody; at = towards(chunks_[at], !is_last)) chunks_[at].rank = is_last ? rank-- : rank++;
  }
  std::uint32_t new_list(std::uint32_t size) {
    if (free_lists_.empty()) {
      sizes_.push_back(size);
      return static_cast<std::uint32_t>(sizes_.size() - 1);
    }
    const std::uint32_t list = free_lists_.back();
    free_lists_.pop_back();
    sizes_[list] = size;
    return list;
  }
  Id new_chunk() {
    if (free_chunks_.empty()) {
      chunks_.emplace_back();
      return static_cast<Id>(chunks_.size() - 1);
    }
    const Id c = free_chunks_.back();
    free_chunks_.pop_back();
    chunks_[c] = {};
    return c;
  }

  std::vector<Chunk> chunks_;
  std::vector<Id> free_chunks_;
  std::vector<std::uint32_t> sizes_;  // of lists, in chunks
  std::vector<std::uint32_t> free_lists_;
  std::uint32_t reach_;
};

}  // namespace restrip::detail
