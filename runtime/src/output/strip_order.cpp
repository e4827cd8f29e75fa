// Strips for a vertex cache.
//
// Outline. The strips of the mesh are laid out one after the other; a place is a triangle in this row. Drawing takes
// *runs* out of the row, places in a row that are not drawn yet, in either direction. The next run is the best of those
// that begin next to a cached vertex, by this gain:
//
//   worth of a triangle * triangles - cost,
//   cost = misses and harm to the cache + indices for cutting the row at both ends - indices saved by a join
//
// A *join* continues the last strip in the first triangle of the run, over any edge that they share. *Harm*: a vertex
// leaves the cache although triangles around it are not drawn, so it will be missed again. That is charged when the
// vertex leaves, and the second miss costs less. The *worth of a triangle* is the average cost of the last few hundred
// triangles, a little increased: a run continues as long as it is cheaper than drawing usually is. (This is the optimal
// rule for stopping if costs are independent; it adapts to the mesh and to the weight.)
//
// If no cached vertex has triangles left, drawing continues at the vertex that was missed last and has some.
//
// Costs are whole numbers, 1/256 of an index, so that every machine makes the same choices. The shares below are the
// best of some hundred trials on five scanned and designed meshes, with caches of 16 and 32.
#include "restrip/output/strip_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "output/drawing_cache.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace {

/// The strips of a mesh in a row.
struct StripRow {
  static constexpr std::int8_t no_side = -1;

  std::vector<std::uint32_t> corners;  // three a place; corner s begins side s
  std::vector<std::uint32_t> across;   // three a place: 3 * place + side on the other side, or none
  // The sides to the previous and to the next triangle of a strip.
  std::vector<std::int8_t> previous;
  std::vector<std::int8_t> next;

  [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(previous.size()); }
};

StripRow row_of(const StripMesh& mesh, const std::vector<Triangle>& order) {
  StripRow row;
  std::vector<std::uint32_t> place_of(mesh.triangle_bound(), none);
  for (std::uint32_t p = 0; p < order.size(); ++p) place_of[order[p]] = p;
  row.corners.reserve(3 * order.size());
  row.across.reserve(3 * order.size());
  row.previous.assign(order.size(), StripRow::no_side);
  row.next.assign(order.size(), StripRow::no_side);
  for (std::uint32_t p = 0; p < order.size(); ++p) {
    for (unsigned side = 0; side < 3; ++side) {
      const StripMesh::Halfedge h = StripMesh::halfedge(order[p], side);
      row.corners.push_back(mesh.from(h));
      const StripMesh::Halfedge back = mesh.opposite(h);
      const std::uint32_t q = StripMesh::on_boundary(back) ? none : place_of[StripMesh::triangle(back)];
      const bool joined = q != p && q != none;
      row.across.push_back(joined ? 3 * q + StripMesh::side(back) : none);
      if (joined && mesh.solid(h)) (q == p + 1 ? row.next : row.previous)[p] = static_cast<std::int8_t>(side);
    }
  }
  return row;
}

/// Chooses runs. `order` lists places in drawing order, `start` where strips begin in it; `cuts` are places that are
/// cut off their predecessor in the row, `joins` are sides that become solid after that.
class CacheOrder {
 public:
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> start;
  std::vector<std::uint32_t> cuts;
  std::vector<std::uint32_t> joins;

  CacheOrder(const StripRow& row, const VertexCache& cache)
      : row_(row),
        cache_(static_cast<std::uint32_t>((std::min<std::size_t>)(cache.size, largest_cache))),
        longest_((std::min)(cache_ + cache_ / 2, longest_run)),
        drawing_(cache_, row.corners, ends_of(row)) {
    const double indices = read_row();
    miss_ = static_cast<Cost>(std::llround(weight_of(cache, indices / (std::max)(row.size(), 1U)) * unit));
    first_miss_ = first_miss_share * miss_ / 100;
    later_miss_ = later_miss_share * miss_ / 100;
    harm_ = harm_share * miss_ / 100;
    for (int link = 2; link < 5; ++link)
      cost_of_end_[static_cast<std::size_t>(link)] = (link - 1) * unit * end_share / 100;
    spent_ = miss_ * window * 4 / 5;
    adapt(0, 0);
  }

  void run() {
    order.reserve(row_.size());
    std::uint32_t first = 0;
    while (order.size() < row_.size()) {
      best_ = {};
      list_joins();
      try_cached();
      if (best_.triangles == 0) try_left_behind();
      if (best_.triangles == 0) {
        while (drawing_.is_drawn(first)) ++first;
        try_both(first);
      }
      draw(best_);
    }
    start.push_back(order.size());
  }

 private:
  using Cost = std::int64_t;
  static constexpr Cost unit = 256;  // an index
  static constexpr Cost restart_cost = 3 * unit;
  static constexpr std::uint32_t largest_cache = 1U << 20U;
  static constexpr std::uint32_t longest_run = 128;
  static constexpr unsigned most_tried = 48;            // runs
  static constexpr unsigned most_met = 4 * most_tried;  // beginnings, for vertices of many triangles
  static constexpr double usual_indices = 1.19;         // a triangle, of scanned meshes
  static constexpr Cost window = 512;                   // triangles whose average cost is the worth of one

  // Percentages.
  static constexpr Cost first_miss_share = 95;
  static constexpr Cost later_miss_share = 40;
  static constexpr Cost harm_share = 20;
  static constexpr Cost join_share = 70;
  static constexpr Cost end_share = 80;
  static constexpr Cost worth_share = 108;
  static constexpr Cost give_up_share = 250;  // of a miss, below the highest gain of a run

  enum Turn : std::int8_t { no_turn, left, right };

  struct Place {
    // The vertices that it adds when it is entered backwards or forwards.
    std::array<std::uint32_t, 2> apex{};
    // What cutting before it saves and costs, in indices and one more; 0: it is not joined to its predecessor.
    std::uint8_t link = 0;
  };
  struct Run {
    Cost gain = 0;
    Cost cost = 0;
    std::uint32_t first = 0;
    std::uint32_t triangles = 0;
    bool forward = true;
  };
  // Continues the last strip over one of its sides.
  struct Join {
    std::uint32_t place;
    std::int8_t from;
    std::int8_t into;
  };

  static Turn turn(std::int8_t in, std::int8_t out) noexcept {
    if (in == StripRow::no_side || out == StripRow::no_side) return no_turn;
    return (in + 1) % 3 == out ? right : left;
  }
  // Where strips repeat many indices anyway, a cut costs little, and what it saves in misses is worth more: the weight
  // grows with the eighth power of the indices a triangle. Products alone are rounded the same way on every machine.
  static double weight_of(const VertexCache& cache, double indices) noexcept {
    if (cache.weight != 0) return cache.weight;
    double factor = indices / usual_indices;
    for (int square = 0; square < 3; ++square) factor *= factor;
    return (cache.size < 24 ? 1.3 : 0.85) * std::clamp(factor, 0.62, 4.0);
  }
  static bool is_swap(Turn one, Turn other) noexcept { return one != no_turn && one == other; }
  [[nodiscard]] std::uint32_t corner(std::uint32_t place, int side) const noexcept {
    return row_.corners[3 * std::size_t{place} + static_cast<unsigned>(side % 3)];
  }
  // ---- the row, seen in one direction or the other

  [[nodiscard]] std::uint8_t link(std::uint32_t place, bool after) const noexcept {
    return places_[place + std::uint32_t{after}].link;
  }
  [[nodiscard]] Cost cost_of_cut(std::uint32_t place, bool after) const noexcept {
    return (link(place, after) - 1) * unit;
  }
  [[nodiscard]] static std::uint32_t step(std::uint32_t place, bool forward) noexcept {
    return forward ? place + 1 : place - 1;
  }
  [[nodiscard]] std::int8_t side_out(std::uint32_t place, bool forward) const noexcept {
    if (link(place, forward) == 0) return StripRow::no_side;
    return forward ? row_.next[place] : row_.previous[place];
  }
  [[nodiscard]] std::int8_t side_in(std::uint32_t place, bool forward) const noexcept {
    return forward ? row_.previous[place] : row_.next[place];
  }

  // Returns the number of indices of the strips; a first one that turns the wrong way is not counted.
  double read_row() {
    double indices = row_.size();
    places_.resize(row_.size() + std::size_t{1});
    const auto turn_at = [this](std::uint32_t place) { return turn(row_.previous[place], row_.next[place]); };
    for (std::uint32_t p = 1; p < row_.size(); ++p) {
      if (row_.previous[p] == StripRow::no_side) {
        indices += 3;
        continue;
      }
      // The turns on both sides of the cut vanish, and their swaps.
      unsigned swaps = is_swap(turn_at(p - 1), turn_at(p)) ? 1 : 0;
      indices += swaps;
      if (row_.previous[p - 1] != StripRow::no_side && is_swap(turn_at(p - 2), turn_at(p - 1))) ++swaps;
      if (row_.next[p] != StripRow::no_side && is_swap(turn_at(p), turn_at(p + 1))) ++swaps;
      places_[p].link = static_cast<std::uint8_t>(4 - swaps);
    }
    for (std::uint32_t p = 0; p < row_.size(); ++p)
      places_[p].apex = {corner(p, row_.next[p] + 2), corner(p, row_.previous[p] + 2)};
    return indices;
  }
  // Of the corners of each place.
  static std::vector<std::uint32_t> ends_of(const StripRow& row) {
    std::vector<std::uint32_t> ends(row.size());
    for (std::uint32_t p = 0; p < ends.size(); ++p) ends[p] = 3 * p + 3;
    return ends;
  }

  // ---- candidates

  // Beginnings around cached vertices. A run that could begin one triangle earlier, at a cached vertex too, does.
  void try_cached() {
    drawing_.for_each_near(most_tried, most_met, [this](std::uint32_t place) {
      unsigned tried = 0;
      for (const bool forward : {true, false}) {
        if (could_begin_earlier(place, forward)) continue;
        try_run(place, forward);
        ++tried;
      }
      return tried;
    });
  }
  [[nodiscard]] bool could_begin_earlier(std::uint32_t place, bool forward) const noexcept {
    if (link(place, !forward) == 0) return false;
    return drawing_.is_cached(places_[step(place, !forward)].apex[forward ? 0 : 1]);
  }
  void try_left_behind() {
    unsigned met = 0;
    drawing_.for_each_left_behind([&](std::uint32_t place) {
      try_both(place);
      return ++met < most_tried;
    });
  }
  void try_both(std::uint32_t place) {
    try_run(place, true);
    try_run(place, false);
  }

  void try_run(std::uint32_t place, bool forward) {
    std::uint32_t misses = drawing_.try_from_here();
    Cost cost = 0;
    const auto look_up = [&](std::uint32_t v) {
      const auto found = drawing_.try_look_up(v, misses);
      if (found == detail::DrawingCache::Lookup::hit) return;
      cost += found == detail::DrawingCache::Lookup::first_miss ? first_miss_ : later_miss_;
      if (drawing_.harms(misses)) cost += harm_;
    };
    Cost indices = 0;
    if (const auto [join, saved] = best_join(place, forward); join != nullptr)
      indices -= saved * join_share / 100;
    else if (begins_wrong(place, forward))
      indices += unit;
    if (link(place, !forward) != 0) indices += cost_of_cut(place, !forward);
    const std::uint32_t first = place;
    const Cost give_up = give_up_share * miss_ / 100;
    Cost highest = -give_up;
    for (int side = 0; side < 3; ++side) look_up(corner(place, side));
    for (std::uint32_t triangles = 1;; ++triangles) {
      const bool ends = link(place, forward) == 0;
      const Cost all = cost + indices + cost_of_end_[link(place, forward)];
      const Cost gain = worth_ * Cost{triangles} - all;
      if (best_.triangles == 0 || gain > best_.gain) best_ = {gain, all, first, triangles, forward};
      highest = triangles == 1 ? gain : (std::max)(highest, gain);
      if (ends || triangles >= longest_ || gain < highest - give_up) return;
      place = step(place, forward);
      look_up(places_[place].apex[forward ? 1 : 0]);
    }
  }
  // A strip that turns right first takes one more index.
  [[nodiscard]] bool begins_wrong(std::uint32_t place, bool forward) const noexcept {
    if (link(place, forward) == 0) return false;
    place = step(place, forward);
    return turn(side_in(place, forward), side_out(place, forward)) == right;
  }

  // ---- joins

  void list_joins() {
    joins_here_ = 0;
    if (order.empty()) return;
    const std::uint32_t last = order.back();
    for (std::int8_t side = 0; side < 3; ++side) {
      const std::uint32_t other = row_.across[3 * std::size_t{last} + static_cast<std::size_t>(side)];
      if (side == last_in_ || other == none || drawing_.is_drawn(other / 3)) continue;
      join_[joins_here_++] = {other / 3, side, static_cast<std::int8_t>(other % 3)};
    }
  }
  struct BestJoin {
    const Join* join = nullptr;
    Cost saved = 0;
  };
  // Saves a restart and the three indices of a strip, but for swaps.
  [[nodiscard]] BestJoin best_join(std::uint32_t place, bool forward) const noexcept {
    BestJoin best;
    for (unsigned i = 0; i < joins_here_; ++i) {
      const Join& join = join_[i];
      if (join.place != place) continue;
      const std::int8_t out = side_out(place, forward);
      if (join.into == out) continue;
      const Turn before = turn(last_in_, join.from);
      const Turn here = turn(join.into, out);
      Cost saved = restart_cost;
      if (is_swap(turn_before_last_, before)) saved -= unit;
      if (is_swap(before, here)) saved -= unit;
      if (out != StripRow::no_side) {
        const std::uint32_t after = step(place, forward);
        if (is_swap(here, turn(side_in(after, forward), side_out(after, forward)))) saved -= unit;
      }
      if (saved > best.saved) best = {&join, saved};
    }
    return best;
  }

  // ---- drawing

  void draw(const Run& run) {
    const std::uint32_t last = run.forward ? run.first + (run.triangles - 1) : run.first - (run.triangles - 1);
    if (const Join* join = best_join(run.first, run.forward).join; join != nullptr) {
      joins.push_back(3 * join->place + static_cast<unsigned>(join->into));
      turn_before_last_ = turn(last_in_, join->from);
      last_in_ = join->into;
    } else {
      start.push_back(order.size());
      turn_before_last_ = no_turn;
      last_in_ = StripRow::no_side;
    }
    for (std::uint32_t p = run.first;; p = step(p, run.forward)) {
      drawing_.draw(p);
      order.push_back(p);
      for (int side = 0; side < 3; ++side) drawing_.look_up(corner(p, side));
      if (p == last) break;
      turn_before_last_ = turn(last_in_, side_out(p, run.forward));
      last_in_ = side_in(step(p, run.forward), run.forward);
    }
    cut((std::min)(run.first, last));
    cut((std::max)(run.first, last) + 1);
    adapt(run.cost, run.triangles);
  }
  void cut(std::uint32_t place) {
    if (std::exchange(places_[place].link, std::uint8_t{0}) != 0) cuts.push_back(place);
  }
  void adapt(Cost cost, Cost triangles) noexcept {
    spent_ += cost - spent_ * (std::min)(triangles, window) / window;
    worth_ = (std::max<Cost>)(spent_ * worth_share / 100 / window, 1);
  }

  const StripRow& row_;
  std::uint32_t cache_;
  std::uint32_t longest_;
  Cost miss_ = 0;
  Cost first_miss_ = 0;
  Cost later_miss_ = 0;
  Cost harm_ = 0;
  std::array<Cost, 5> cost_of_end_{};  // by link
  Cost spent_ = 0;                     // for the last `window` triangles
  Cost worth_ = 1;
  std::vector<Place> places_;     // and one after the last
  detail::DrawingCache drawing_;  // of places
  Run best_;
  std::array<Join, 3> join_{};
  unsigned joins_here_ = 0;
  // Of the last triangle drawn, if its strip is older: the side over which it was entered, and the turn before it.
  std::int8_t last_in_ = StripRow::no_side;
  Turn turn_before_last_ = no_turn;
};

}  // namespace

Strips strips_for_vertex_cache(StripMesh& mesh, const VertexCache& cache) {
  if (!(cache.weight >= 0 && cache.weight <= 1000))
    RESTRIP_THROW(std::invalid_argument, "restrip: the weight of a cache miss must be from 0 to 1000");
  RESTRIP_ASSERT(check_coloring(mesh).valid, "strips_for_vertex_cache", "the colouring is not valid");
  Strips strips = extract_strips(mesh);
  if (cache.size == 0) return strips;
  const StripRow row = row_of(mesh, strips.order);
  CacheOrder drawing(row, cache);
  drawing.run();
  const auto set = [&](std::uint32_t place, unsigned side, bool solid) {
    mesh.set_solid(StripMesh::halfedge(strips.order[place], side), solid);
  };
  for (const std::uint32_t place : drawing.cuts) set(place, static_cast<unsigned>(row.previous[place]), false);
  for (const std::uint32_t join : drawing.joins) set(join / 3, join % 3, true);
  for (std::uint32_t& place : drawing.order) place = strips.order[place];
  return {std::move(drawing.order), std::move(drawing.start), true};
}

}  // namespace restrip
