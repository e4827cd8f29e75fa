// Sets of vertices with multipliers that no arrow is loaded by too much. Included by impl/index_bound.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_set>
#include <vector>

#include "restrip/output/impl/arrow_graph.hpp"

namespace restrip::detail {

// The linear program: as few arrows as cross every set; its dual: as large multipliers as no arrow is loaded by more
// than one unit. A set that lacks 1 modulo 3 is crossed by an arrow inward or two outward, one that lacks 2 by an arrow
// outward or two inward. In halves, so that all is whole: the arrow that does alone weighs 2, the other 1, and loads
// are at most 2 units.
//
// descend() is the primal-dual hybrid gradient method with the step sizes of Pock and Chambolle ("Diagonal
// preconditioning for first order primal-dual algorithms in convex optimization", 2011), in fixed point.
class CutPacking {
 public:
  using Amount = std::int64_t;

  CutPacking(const ArrowGraph& graph, std::uint32_t unit)
      : graph_(graph),
        unit_(static_cast<std::int32_t>(unit)),
        used_(graph.arrows(), 0),
        ahead_(graph.arrows(), 0),
        weights_(graph.arrows(), 0),
        load_(graph.arrows(), 0),
        inside_(graph.vertices(), false) {}

  [[nodiscard]] std::size_t size() const noexcept { return rows_.size() - 1; }
  [[nodiscard]] std::span<const Vertex> vertices(std::size_t row) const noexcept {
    return std::span(vertices_).subspan(rows_[row].vertices, rows_[row + 1].vertices - rows_[row].vertices);
  }

  /// Adds a set, with the multiplier with which single vertices prove the sum of ceil(n / 3) if it is one of them.
  void add(std::span<const Vertex> set) {
    const unsigned lacking = lacking_of(set);
    rows_.back().lacking = static_cast<std::uint8_t>(lacking);
    for_each_leaving(set, [&](std::uint32_t out) {
      border_.push_back(out);
      weights_[out] += lacking;
      weights_[out ^ 1U] += 3 - lacking;
    });
    vertices_.insert(vertices_.end(), set.begin(), set.end());
    std::sort(vertices_.end() - static_cast<std::ptrdiff_t>(set.size()), vertices_.end());
    multipliers_.push_back(set.size() == 1 ? unit_ / 3 * static_cast<std::int32_t>(lacking) : 0);
    rows_.push_back({border_.size(), vertices_.size(), 0});
  }

  /// Adds the set if it lacks something, the arrows used do not cross it by a twentieth of what they should, and it is
  /// not there.
  void add_if_uncrossed(std::span<const Vertex> set) {
    const unsigned lacking = lacking_of(set);
    if (lacking == 0) return;
    Amount crossing = 0;
    for_each_leaving(set, [&](std::uint32_t out) { crossing += crossed(used_, lacking, out); });
    if (crossing < 2 * Amount{unit_} - unit_ / 10 && known_.insert(name_of(set)).second) add(set);
  }

  void descend(unsigned sweeps) {
    for (unsigned sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t a = 0; a < used_.size(); ++a) {
        if (weights_[a] == 0) continue;
        const Amount step = (2 * Amount{unit_} - load_[a]) / weights_[a];
        const auto now = static_cast<std::int32_t>(std::clamp<Amount>(used_[a] - step, 0, 4 * Amount{unit_}));
        ahead_[a] = 2 * now - used_[a];
        used_[a] = now;
        load_[a] = 0;
      }
      for (std::size_t row = 0; row < size(); ++row) {
        const unsigned lacking = rows_[row].lacking;
        const auto border = border_of(row);
        Amount crossing = 0;
        for (const std::uint32_t out : border) crossing += crossed(ahead_, lacking, out);
        const Amount step = (2 * Amount{unit_} - crossing) / (3 * static_cast<Amount>(border.size()));
        const Amount now = std::clamp<Amount>(multipliers_[row] + step, 0, unit_);
        multipliers_[row] = static_cast<std::int32_t>(now);
        if (now != 0) put(load_, row, now);
      }
    }
  }

  /// Multipliers that load no arrow too much: those of descend(), lowered where they do, or those of single vertices;
  /// then each raised as far as it goes, the largest first. The sum is never below that of single vertices alone.
  [[nodiscard]] std::vector<Amount> feasible() const {
    std::vector<Amount> plain(size(), 0);
    for (std::size_t row = 0; row < size(); ++row)
      if (vertices(row).size() == 1) plain[row] = Amount{unit_ / 3} * rows_[row].lacking;
    std::vector<Amount> found(multipliers_.begin(), multipliers_.end());
    const std::vector<Amount> load = load_of(found);
    for (std::size_t row = 0; row < size(); ++row) {
      Amount most = 2 * Amount{unit_};
      for (const std::uint32_t out : border_of(row)) most = std::max({most, load[out], load[out ^ 1U]});
      found[row] = found[row] * 2 * unit_ / most;
    }
    raise(plain);
    raise(found);
    const auto sum = [](const std::vector<Amount>& all) { return std::accumulate(all.begin(), all.end(), Amount{0}); };
    return sum(found) > sum(plain) ? found : plain;
  }

 private:
  struct Row {
    std::size_t border;    // where its border begins
    std::size_t vertices;  // where its vertices begin
    std::uint8_t lacking;
  };

  [[nodiscard]] unsigned lacking_of(std::span<const Vertex> set) const {
    unsigned lacking = 0;
    for (const Vertex v : set) lacking += graph_.lacking(v);
    return lacking % 3;
  }

  template <class Visit>
  void for_each_leaving(std::span<const Vertex> set, Visit visit) {
    for (const Vertex v : set) inside_[v] = true;
    for (const Vertex v : set)
      for (const ArrowGraph::Leaving& way : graph_.from(v))
        if (!inside_[way.to]) visit(way.arrow);
    for (const Vertex v : set) inside_[v] = false;
  }

  // By how much the arrows of an edge cross a set that `out` leaves.
  static Amount crossed(const std::vector<std::int32_t>& arrows, unsigned lacking, std::uint32_t out) {
    return Amount{lacking} * arrows[out] + Amount{3 - lacking} * arrows[out ^ 1U];
  }

  [[nodiscard]] std::span<const std::uint32_t> border_of(std::size_t row) const {
    return std::span(border_).subspan(rows_[row].border, rows_[row + 1].border - rows_[row].border);
  }

  // The same for the same vertices in any order. Where two sets share a name, one is left out.
  static std::uint64_t name_of(std::span<const Vertex> set) {
    std::uint64_t name = 0;
    for (const Vertex v : set) {
      std::uint64_t mixed = (v + std::uint64_t{1}) * 0x9E3779B97F4A7C15;
      mixed = (mixed ^ mixed >> 29) * 0xBF58476D1CE4E5B9;
      name += mixed ^ mixed >> 32;
    }
    return name;
  }

  void put(std::vector<Amount>& load, std::size_t row, Amount multiplier) const {
    const unsigned lacking = rows_[row].lacking;
    for (const std::uint32_t out : border_of(row)) {
      load[out] += lacking * multiplier;
      load[out ^ 1U] += (3 - lacking) * multiplier;
    }
  }

  [[nodiscard]] std::vector<Amount> load_of(const std::vector<Amount>& multipliers) const {
    std::vector<Amount> load(graph_.arrows(), 0);
    for (std::size_t row = 0; row < size(); ++row)
      if (multipliers[row] != 0) put(load, row, multipliers[row]);
    return load;
  }

  void raise(std::vector<Amount>& multipliers) const {
    std::vector<Amount> load = load_of(multipliers);
    std::vector<std::uint32_t> order(size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return multipliers[a] > multipliers[b]; });
    for (const std::uint32_t row : order) {
      const unsigned lacking = rows_[row].lacking;
      Amount room = std::numeric_limits<Amount>::max();
      for (const std::uint32_t out : border_of(row))
        room = std::min(
            {room, (2 * Amount{unit_} - load[out]) / lacking, (2 * Amount{unit_} - load[out ^ 1U]) / (3 - lacking)});
      if (room <= 0) continue;
      put(load, row, room);
      multipliers[row] += room;
    }
  }

  const ArrowGraph& graph_;
  std::int32_t unit_;
  std::vector<Row> rows_{{0, 0, 0}};  // and one behind the last
  std::vector<std::uint32_t> border_;
  std::vector<Vertex> vertices_;
  std::vector<std::int32_t> multipliers_;
  std::vector<std::int32_t> used_;      // the arrows: how often each is used, in units
  std::vector<std::int32_t> ahead_;     // and where it is going
  std::vector<std::uint32_t> weights_;  // of all sets that an arrow crosses
  std::vector<Amount> load_;
  std::vector<bool> inside_;
  std::unordered_set<std::uint64_t> known_;
};

}  // namespace restrip::detail
