#include "drive/driver.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "restrip/search/policy.hpp"
#include "support/failing_new.hpp"

namespace restrip::drive {

std::uint32_t Input::byte() noexcept {
  if (over()) return 0;
  const auto value = static_cast<unsigned char>(bytes_.front());
  bytes_.remove_prefix(1);
  return value;
}

std::uint32_t Input::word() noexcept {
  const std::uint32_t low = byte();
  return low | byte() << 8;
}

std::string random_bytes(std::size_t length, std::uint32_t seed) {
  std::string bytes;
  for (std::size_t i = 0; i < length; ++i) {
    seed = seed * 1'664'525 + 1'013'904'223;
    bytes.push_back(static_cast<char>(seed >> 24));
  }
  return bytes;
}

Tally& Tally::operator+=(const Tally& other) noexcept {
  for (std::size_t i = 0; i < calls; ++i) done[i] += other.done[i], refused[i] += other.refused[i];
  shortages += other.shortages;
  failed += other.failed;
  return *this;
}

namespace {

/// How often each call is made, relative to the others.
struct Share {
  Call call;
  unsigned share;
  const char* name;
};
constexpr std::array shares{Share{Call::split, 12, "split"},
                            Share{Call::collapse, 12, "collapse"},
                            Share{Call::flip, 8, "flip"},
                            Share{Call::split_face, 4, "split_face"},
                            Share{Call::join_faces, 6, "join_faces"},
                            Share{Call::bisect, 4, "bisect"},
                            Share{Call::merge, 6, "merge"},
                            Share{Call::apply, 4, "apply"},
                            Share{Call::replace, 6, "replace"},
                            Share{Call::improve, 2, "improve"},
                            Share{Call::recolor, 1, "recolor"},
                            Share{Call::keep, 2, "keep"},
                            Share{Call::move_to_level, 6, "move_to_level"},
                            Share{Call::pack, 1, "pack"},
                            Share{Call::reload, 1, "reload"},
                            Share{Call::update, 12, "update"},
                            Share{Call::undo, 8, "undo"},
                            Share{Call::redo, 4, "redo"}};
constexpr unsigned sum_of_shares = [] {
  unsigned sum = 0;
  for (const Share& share : shares) sum += share.share;
  return sum;
}();
static_assert(shares.size() == calls && sum_of_shares < 128, "each call has a share, and a byte is enough");

constexpr bool grows(Call call) {
  return call == Call::split || call == Call::split_face || call == Call::bisect || call == Call::apply;
}
constexpr bool shrinks(Call call) { return call == Call::collapse || call == Call::join_faces || call == Call::merge; }

class Driver {
 public:
  Driver(Input& input, Subject& subject, std::span<Oracle* const> oracles, const Limits& limits)
      : input_(input), subject_(subject), oracles_(oracles), limits_(limits) {
    for (Oracle* oracle : oracles_) oracle->begin(subject_);
  }

  Tally run() {
    try {
      return run_all();
    } catch (const std::logic_error& error) {
      std::string trace;
      for (std::size_t i = made_.size() - std::min<std::size_t>(made_.size(), 6); i < made_.size(); ++i)
        trace += (trace.empty() ? ", after " : ", ") + made_[i];
      throw std::logic_error(error.what() + trace + " (call " + std::to_string(made_.size()) + ")");
    }
  }

 private:
  Tally run_all() {
    for (std::size_t step = 0; step < limits_.steps && !input_.over(); ++step) {
      const Step next = any_step();
      if (limits_.failing != 0) memory_fails_ = step == limits_.failing_step ? limits_.failing : 0;
      perform(next);
    }
    memory_fails_ = 0;
    perform({.call = Call::update});
    for (const Call back_or_forth : {Call::undo, Call::redo})
      while (perform({.call = back_or_forth}).moved) perform({.call = Call::update});
    perform({.call = Call::reload});
    perform({.call = Call::update});
    return tally_;
  }

  Outcome perform(const Step& step) {
    if (!subject_.can(step.call)) return {};
    made_.emplace_back(shares[static_cast<std::size_t>(step.call)].name);
    for (Oracle* oracle : oracles_) oracle->before(step, subject_);
    const std::uint32_t failing = std::exchange(memory_fails_, 0);
    if (failing != 0)
      testing_support::fail_allocation(
          failing / 2, failing % 2 == 0 ? testing_support::Shortage::once : testing_support::Shortage::for_good);
    Outcome outcome = subject_.perform(step);
    const bool ran_out = failing != 0 && testing_support::end_shortage();
    promise(outcome.end != Outcome::End::out_of_memory || ran_out, "memory runs out only if an allocation fails");
    if (!outcome.done()) made_.back() += outcome.end == Outcome::End::refused ? " (refused)" : " (failed)";
    for (Oracle* oracle : oracles_) oracle->after(step, outcome, subject_);
    const auto call = static_cast<std::size_t>(step.call);
    const bool moves = step.call == Call::undo || step.call == Call::redo;
    tally_.done[call] += outcome.done() && (!moves || outcome.moved) ? 1U : 0U;
    tally_.refused[call] += outcome.end == Outcome::End::refused ? 1U : 0U;
    tally_.shortages += ran_out ? 1U : 0U;
    tally_.failed += outcome.end == Outcome::End::out_of_memory ? 1U : 0U;
    return outcome;
  }

  // ---- what the next bytes say

  Call any_call() {
    std::size_t triangles = 0;
    for (Triangle t = 0; t < subject_.triangle_bound(); ++t) triangles += subject_.has_triangle(t) ? 1U : 0U;
    unsigned number = input_.byte() % sum_of_shares;
    Call call{};
    for (const Share& share : shares) {
      call = share.call;
      if (number < share.share) break;
      number -= share.share;
    }
    if (triangles > limits_.most && grows(call)) return Call::collapse;
    if (triangles < limits_.fewest && shrinks(call)) return Call::split;
    if (subject_.can(call)) return call;
    return subject_.can(Call::move_to_level) ? Call::move_to_level : Call::flip;
  }

  Step any_step() {
    Step step{.call = any_call()};
    const auto how = [&] { return input_.byte(); };
    switch (step.call) {
      case Call::split:
        step.where = place_of_split();
        step.name = new_name();
        break;
      case Call::apply:
        step.number = how();
        step.where.left = side();
        break;
      case Call::replace:
        any_triangles(step);
        break;
      case Call::improve:
        step.number = 1 + 16 * how();
        break;
      case Call::move_to_level:
        step.number = input_.word();
        break;
      case Call::keep:
        step.policy = policies[how() % policies.size()].policy;
        step.number = input_.one_of(std::array{0U, 0U, 40U, 300U});
        if (subject_.live() == nullptr) step.number = 0;  // C has no set_search()
        [[fallthrough]];
      case Call::recolor:
        step.cost = any_cost();
        break;
      case Call::update:
        any_ranges(step);
        break;
      default:
        if (is_operation(step.call)) step.where.left = side();
    }
    if (is_operation(step.call)) step.by_vertices = how() % 4 == 0;
    if (limits_.allocations_fail && how() % 16 == 0) memory_fails_ = 2 + how() % 128;
    return step;
  }

  Cost any_cost() { return input_.one_of(std::array{Cost::strips(), Cost::indices(), Cost{2, 1, 1}, Cost{5, 0, 2}}); }

  /// Any side of any triangle number, or a number that names no side.
  Halfedge side() {
    const std::uint32_t number = input_.word();
    const std::size_t bound = subject_.triangle_bound();
    const std::uint32_t kind = number >> 13;
    if (bound == 0 || (kind == 7 && number % 4 == 0)) return {number * 0x9E3779B1U};
    const Halfedge h = StripMesh::halfedge(static_cast<Triangle>(number % bound), (number >> 8) % 3);
    if (kind == 5 && number % 4 == 0) return StripMesh::across_boundary(h);
    const Halfedge other = kind == 6 ? subject_.opposite(h) : Halfedge{};
    return other == Halfedge{} ? h : other;
  }
  Halfedge turned(Halfedge h) const {
    if (StripMesh::on_boundary(h)) return h;
    const Halfedge other = subject_.opposite(StripMesh::next(StripMesh::next(h)));
    return other == Halfedge{} ? h : other;
  }
  VertexSplit place_of_split() {
    using Spokes = VertexSplit::Spokes;
    VertexSplit where{side(), {}, Spokes::both};
    const std::uint32_t how = input_.byte();
    where.right = (how & 15U) == 15 ? side() : where.left;
    for (std::uint32_t turns = how & 7U; turns > 0; --turns) where.right = turned(where.right);
    constexpr std::array spokes{Spokes::both,      Spokes::both, Spokes::both, Spokes::both,
                                Spokes::left_only, Spokes::both, Spokes::both, Spokes::right_only};
    where.spokes = spokes[how >> 5];
    if (where.spokes == Spokes::left_only) where.right = {};
    if (where.spokes == Spokes::right_only) std::swap(where.left, where.right), where.left = {};
    return where;
  }
  Vertex new_name() {
    const auto next = static_cast<Vertex>(subject_.vertex_bound());
    const Vertex name = input_.one_of(std::array<Vertex, 16>{none, none, none, none, none, none, none, 0, 7, next,
                                                             next + 1, 65'534, 65'535, 65'536, 70'000, none - 1});
    return !limits_.far_names && name > next + 1 ? none : name;
  }

  /// A hole, a triangle across an edge, another vertex for v, a fill, a face in three parts, or anything.
  void any_triangles(Step& step) {
    const std::size_t bound = subject_.triangle_bound();
    if (bound == 0) return;
    const auto t = static_cast<Triangle>(input_.word() % bound);
    const auto [v, w, x] = subject_.corners(t);
    const auto fresh = static_cast<Vertex>(subject_.vertex_bound());
    const std::uint32_t kind = input_.byte() % 6;
    if (kind == 0) step.out = {t};
    if (kind == 1) step.in = {{w, v, fresh}};
    if (kind == 2)
      for (Triangle other = 0; other < bound; ++other) {
        Corners corners = subject_.corners(other);
        if (std::count(corners.begin(), corners.end(), v) == 0 || v == none) continue;
        std::replace(corners.begin(), corners.end(), v, fresh);
        step.out.push_back(other);
        step.in.push_back(corners);
      }
    if (kind == 3) step.in = {{w, v, x}};
    if (kind == 4) step.out = {t}, step.in = {{v, w, fresh}, {w, x, fresh}, {x, v, fresh}};
    if (kind == 5) {
      for (std::uint32_t n = input_.byte() % 3; n > 0; --n)
        step.out.push_back(static_cast<Triangle>(input_.word() % bound));
      const auto vertex = [&] { return static_cast<Vertex>(input_.byte() % (subject_.vertex_bound() + 1)); };
      for (std::uint32_t n = input_.byte() % 3; n > 0; --n) step.in.push_back({vertex(), vertex(), vertex()});
    }
  }

  void any_ranges(Step& step) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    const std::uint32_t how = input_.byte();
    step.lost = how % 16 == 1 && subject_.live() != nullptr;  // C has no keep_upload()
    if (how % 2 == 0) return;
    step.ranges.merge_gap = std::array{std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{30},
                                       most / 2,       most - 39,      most,           std::size_t{2}}[how / 2 % 8];
    step.ranges.align = std::array{std::size_t{2},  std::size_t{4},   std::size_t{8}, std::size_t{12},
                                   std::size_t{16}, std::size_t{256}, most / 2 + 1,   most - 3}[how / 16 % 8];
  }

  Input& input_;
  Subject& subject_;
  std::span<Oracle* const> oracles_;
  Limits limits_;
  Tally tally_;
  std::vector<std::string> made_;   // the calls, for messages
  std::uint32_t memory_fails_ = 0;  // in the next call: twice the number of the allocation, plus one for good
};

/// A sheet of w by h squares, closed in both directions if `wraps`.
Triangles sheet(std::uint32_t w, std::uint32_t h, bool wraps) {
  Triangles triangles;
  const std::uint32_t row = wraps ? w : w + 1;
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return (wraps ? y % h * row + x % w : y * row + x); };
  for (std::uint32_t y = 0; y < h; ++y)
    for (std::uint32_t x = 0; x < w; ++x) {
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return triangles;
}

}  // namespace

Tally drive(Input& input, Subject& subject, std::span<Oracle* const> oracles, const Limits& limits) {
  return Driver(input, subject, oracles, limits).run();
}

Triangles any_mesh(Input& input) {
  const std::uint32_t kind = input.byte() % 8;
  const std::uint32_t size = input.byte();
  if (kind < 3) return sheet(1 + size % 8, 1 + size / 8 % 8, false);
  if (kind < 5) return sheet(3 + size % 5, 3 + size / 8 % 5, true);
  if (kind == 5) return {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  Triangles any;  // also with corners twice or out of range, edges of many triangles
  for (std::uint32_t t = 0; t < size % 40; ++t)
    any.push_back({input.byte() % 16, input.byte() % 16, input.byte() % 17});
  return any;
}

LiveOptions any_options(Input& input) {
  LiveOptions options;
  const std::uint32_t policy = input.byte();
  options.policy = policies[policy % policies.size()].policy;
  options.effort = static_cast<Effort>(policy / 16 % 3);
  options.cost = input.one_of(std::array{Cost::strips(), Cost::indices(), Cost{2, 1, 1}});
  options.history = input.one_of(std::array{std::size_t{0}, std::size_t{1}, std::size_t{60}, std::size_t{100'000},
                                            std::numeric_limits<std::size_t>::max(), std::size_t{100'000}});
  const std::uint32_t format = input.byte();
  options.format.form = static_cast<StripForm>(format % 4);
  options.format.width =
      std::array{IndexWidth::automatic, IndexWidth::automatic, IndexWidth::bits16, IndexWidth::bits32}[format / 4 % 4];
  const std::uint32_t layout = input.byte();
  options.layout.cache = std::array{32U, 32U, 32U, 16U, 1U, 64U, 0U, layout == 255 ? 65U : 3U}[layout % 8];
  options.layout.waste = std::array{95U, 95U, 0U, 2000U}[layout / 8 % 4];
  options.layout.work = std::array{5U, 5U, 0U, 1U, 100U, 5U, 5U, 5U}[layout / 32];
  const std::uint32_t limits = input.byte();
  if (limits == 255) options.format.most_vertices = 3;
  if (limits >= 254) options.format.most_indices = std::numeric_limits<std::size_t>::max() - 2;
  return options;
}

}  // namespace restrip::drive
