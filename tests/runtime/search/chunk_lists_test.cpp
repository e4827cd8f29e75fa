// ChunkLists against lists that are written out: the same neighbours, ranks that grow, the same directions, after any
// mixture of operations; and with so little room for ranks that they must be spread again all the time.
#include "restrip/search/impl/chunk_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace restrip::detail {
namespace {

using Id = ChunkLists::Id;

struct Entry {
  Id chunk;
  bool backwards;
};
using List = std::vector<Entry>;

List reversed(List list) {
  std::reverse(list.begin(), list.end());
  for (Entry& entry : list) entry.backwards = !entry.backwards;
  return list;
}

::testing::AssertionResult agrees(const ChunkLists& lists, const std::vector<List>& written, std::uint32_t reach) {
  if (lists.lists() != written.size())
    return ::testing::AssertionFailure() << lists.lists() << " lists where " << written.size() << " are";
  std::map<std::uint32_t, std::size_t> names;
  for (const List& list : written) {
    const auto name = lists[list.front().chunk].list;
    if (!names.emplace(name, list.size()).second) return ::testing::AssertionFailure() << "two lists with one name";
    if (lists.size(name) != list.size()) return ::testing::AssertionFailure() << "a wrong size";
    // The direction in which a list is counted is its own affair.
    const bool turned = lists[list.front().chunk].rank > lists[list.back().chunk].rank ||
                        (list.size() == 1 && lists[list.front().chunk].backwards != list.front().backwards);
    const List expected = turned ? reversed(list) : list;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto& chunk = lists[expected[i].chunk];
      if (chunk.list != name) return ::testing::AssertionFailure() << "a list with two names";
      if (chunk.before != (i == 0 ? ChunkLists::no_chunk : expected[i - 1].chunk) ||
          chunk.after != (i + 1 == expected.size() ? ChunkLists::no_chunk : expected[i + 1].chunk))
        return ::testing::AssertionFailure() << "wrong neighbours";
      if (i != 0 && chunk.rank <= lists[chunk.before].rank) return ::testing::AssertionFailure() << "ranks do not grow";
      if (chunk.backwards != expected[i].backwards) return ::testing::AssertionFailure() << "a wrong direction";
      const std::uint32_t middle = 1U << 31;
      if ((chunk.rank < middle ? middle - chunk.rank : chunk.rank - middle) > reach + 64)
        return ::testing::AssertionFailure() << "a rank out of reach";
    }
  }
  return ::testing::AssertionSuccess();
}

class Play {
 public:
  Play(std::uint32_t reach, unsigned seed) : reach_(reach), lists_(reach), random_(seed) {}

  void step() {
    const auto kind = below(8);
    if (kind == 0 || written_.empty()) {
      written_.push_back({{lists_.add(), false}});
      return;
    }
    const std::size_t l = below(written_.size());
    const std::size_t i = below(written_[l].size());
    const Id c = written_[l][i].chunk;
    const bool after = below(2) == 0;
    const bool later = after == up(l);  // on which side of c in the list as it is written
    const auto at = [&](std::size_t index) { return written_[l].begin() + static_cast<std::ptrdiff_t>(index); };
    if (kind == 1 && chunks() < 60) {
      const bool backwards = written_[l][i].backwards;
      written_[l].insert(at(i + (later ? 1 : 0)), {lists_.add_next_to(c, after), backwards});
    } else if (kind == 2) {
      lists_.erase(c);
      EXPECT_FALSE(lists_.in_use(c));
      written_[l].erase(at(i));
      if (written_[l].empty()) written_.erase(written_.begin() + static_cast<std::ptrdiff_t>(l));
    } else if (kind == 3) {
      const std::uint32_t name = lists_[c].list;
      const std::size_t before = written_.size();
      lists_.cut(c, after);
      cut(l, i + (later ? 1 : 0));
      if (written_.size() > before) expect_kept(name, written_[l], written_.back());
    } else if (kind == 4 && chunks() < 60) {
      const bool backwards = written_[l][i].backwards;
      const Id fresh = lists_.cut_off(c, after);
      written_[l].insert(at(i + (later ? 1 : 0)), {fresh, backwards});
      cut(l, i + 1);
    } else if (written_.size() > 1) {
      join(l);
    }
  }
  [[nodiscard]] ::testing::AssertionResult right() const { return agrees(lists_, written_, reach_); }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  [[nodiscard]] std::size_t chunks() const {
    std::size_t n = 0;
    for (const List& list : written_) n += list.size();
    return n;
  }
  // Do ranks grow along a list as it is written?
  [[nodiscard]] bool up(std::size_t l) const {
    const Entry& first = written_[l].front();
    const Entry& last = written_[l].back();
    if (first.chunk == last.chunk) return lists_[first.chunk].backwards == first.backwards;
    return lists_[first.chunk].rank < lists_[last.chunk].rank;
  }
  void cut(std::size_t l, std::size_t i) {
    if (i == 0 || i == written_[l].size()) return;
    written_.emplace_back(written_[l].begin() + static_cast<std::ptrdiff_t>(i), written_[l].end());
    written_[l].resize(i);
  }
  // After a cut the larger part has the old name: only the smaller one is written again.
  void expect_kept(std::uint32_t name, const List& one, const List& other) const {
    if (one.size() == other.size()) return;
    EXPECT_EQ(lists_[(one.size() > other.size() ? one : other).front().chunk].list, name);
  }
  void join(std::size_t l) {
    std::size_t m = below(written_.size() - 1);
    if (m >= l) ++m;
    // The end of the one as written, the beginning of the other, each in either direction.
    if (below(2) == 0) written_[l] = reversed(written_[l]);
    if (below(2) == 0) written_[m] = reversed(written_[m]);
    const std::size_t larger = written_[l].size() > written_[m].size() ? l : m;
    const Id member = written_[larger].front().chunk;
    const std::uint32_t name = lists_[member].list;
    lists_.join(written_[l].back().chunk, up(l), written_[m].front().chunk, !up(m));
    if (written_[l].size() != written_[m].size()) {
      EXPECT_EQ(lists_[member].list, name);
    }
    written_[l].insert(written_[l].end(), written_[m].begin(), written_[m].end());
    written_.erase(written_.begin() + static_cast<std::ptrdiff_t>(m));
  }

  std::uint32_t reach_;
  ChunkLists lists_;
  std::vector<List> written_;
  std::mt19937 random_;
};

TEST(ChunkLists, AgreeWithListsThatAreWrittenOut) {
  for (const std::uint32_t reach : {1U << 30, 64U})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      Play play(reach, seed);
      for (int i = 0; i < 5'000; ++i) {
        play.step();
        ASSERT_TRUE(play.right()) << "reach " << reach << ", seed " << seed << ", step " << i;
      }
    }
}

}  // namespace
}  // namespace restrip::detail
