#include "judge/index_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "common/share.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {
namespace {

/// The edges of one side of an operation in their order around its triangles.
class Turns {
 public:
  explicit Turns(const Side& side) : side_(side), around_(side.triangles) {
    // Edges come in the order of the row; a chord does not continue it.
    for (unsigned e = 0; e < side.inner_edges(); ++e) {
      const auto [one, other] = side.edges[e];
      if (e > 0 && (e == side.triangles || one != side.edges[e - 1][1])) {
        around_[one].third = around_[other].third = e;
        continue;
      }
      around_[one].after = e;
      around_[other].before = e;
    }
    for (unsigned port = 0; port < side.ports(); ++port) {
      Around& own = around_[side.owner_of_port[port]];
      own.is_fan = true;
      own.third = side.inner_edges() + port;
    }
    if (side.ports() == 2 * side.triangles) {  // a flip: the inner edge, and two ports counter-clockwise
      for (unsigned port = 0; port < side.ports(); ++port) {
        Around& own = around_[side.owner_of_port[port]];
        const bool second = side.owner_of_port[(port + side.ports() - 1) % side.ports()] == side.owner_of_port[port];
        own.before = 0;
        (second ? own.after : own.third) = side.inner_edges() + port;
      }
    }
  }

  /// How the strip turns at the owner of a port, seen from the port: 0: it ends; 1: over the next side
  /// counter-clockwise; 2: over the other one.
  unsigned at_port(unsigned port, Mask both) const {
    return turn(side_.owner_of_port[port], side_.inner_edges() + port, both);
  }
  int inner_swaps(Mask both) const {
    int swaps = 0;
    for (unsigned e = 0; e < side_.inner_edges(); ++e)
      if (is_solid(both, e)) swaps += is_swap(turn(side_.edges[e][0], e, both), turn(side_.edges[e][1], e, both));
    return swaps;
  }
  static int is_swap(unsigned one, unsigned other) { return one != 0 && other != 0 && one != other ? 1 : 0; }

 private:
  static constexpr unsigned no_edge = 31;
  struct Around {
    unsigned before = no_edge;
    unsigned third =
        no_edge;  ///< a fan triangle's port lies between its two inner edges; a new triangle's chord does not
    unsigned after = no_edge;
    bool is_fan = false;
  };
  unsigned turn(unsigned triangle, unsigned edge, Mask both) const {
    const Around& own = around_[triangle];
    const std::array<unsigned, 3> sides =
        own.is_fan ? std::array{own.before, own.third, own.after} : std::array{own.before, own.after, own.third};
    const auto at = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
    const auto solid = [&](std::size_t side) { return sides[side % 3] != no_edge && is_solid(both, sides[side % 3]); };
    return solid(at + 1) ? 1 : solid(at + 2) ? 2 : 0;
  }

  const Side& side_;
  std::vector<Around> around_;
};

/// If one side has a fan and the other the same fan with inserted triangles: inner edges of both sides that carry the
/// same strip.
struct Carried {
  unsigned fan = 0;            ///< an edge of the side without inserted triangles
  std::array<unsigned, 2> in;  ///< one or two edges of the other side
};
std::optional<std::vector<Carried>> carried(const Side& fan, const Side& with) {
  if (fan.triangles >= with.triangles || fan.ports() != fan.triangles) return {};
  std::vector<unsigned> port_of(fan.triangles);
  for (unsigned port = 0; port < fan.ports(); ++port) port_of[fan.owner_of_port[port]] = port;
  std::vector<Carried> all;
  for (unsigned e = 0; e < fan.inner_edges(); ++e) {
    const unsigned one = with.owner_of_port[port_of[fan.edges[e][0]]];
    const unsigned other = with.owner_of_port[port_of[fan.edges[e][1]]];
    if (const auto same = with.edge_between(one, other)) {
      all.push_back({e, {*same, *same}});
      continue;
    }
    const unsigned between =
        std::find_if(with.edges.begin(), with.edges.end(), [&](const auto& edge) { return edge[0] == one; })->at(1);
    all.push_back({e, {with.edge_between(one, between).value(), with.edge_between(between, other).value()}});
  }
  return all;
}

struct AddedIndices {
  std::uint64_t configurations = 0;
  int by_rule = 0;
  int at_most = 0;
};

/// One operation at one position.
AddedIndices added_indices(const Operation& operation, const SectionRows& rows) {
  const Keys keys(operation);
  const Turns turns_before(operation.before);
  const Turns turns_after(operation.after);
  const std::optional<std::vector<Carried>> inserts = carried(operation.before, operation.after);
  const std::optional<std::vector<Carried>> removes = carried(operation.after, operation.before);
  const auto passed_on = [&](Mask inner) {
    Mask passed = 0;
    for (const auto& [fan, in] : inserts ? *inserts : *removes) {
      if (inserts && is_solid(inner, fan)) passed |= single(in[0]) | single(in[1]);
      if (!inserts && is_solid(inner, in[0]) && is_solid(inner, in[1])) passed |= single(fan);
    }
    return passed;
  };
  // The most that the recolouring adds, over all turns beyond the ports.
  const auto added = [&](Colors before, Colors after) {
    const Mask old = concatenated(before.ports, before.inner, operation.before.inner_edges());
    const Mask now = concatenated(after.ports, after.inner, operation.after.inner_edges());
    int sum = 3 * (strips_of(operation.after, after) - strips_of(operation.before, before)) +
              turns_after.inner_swaps(now) - turns_before.inner_swaps(old);
    for (unsigned port = 0; port < operation.ports(); ++port) {
      if (!is_solid(after.ports, port)) continue;  // a port that is given up is not a swap any more
      const unsigned turn = turns_after.at_port(port, now);
      if (turn != 0 && turn != turns_before.at_port(port, old)) ++sum;  // beyond it the strip turns the other way
    }
    return sum;
  };

  AddedIndices found;
  for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports)
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner) {
      const Colors before{inner, ports};
      const std::optional<Key> key = keys.key_of(before);
      const Row* const row = key ? rows.row_of(*key) : nullptr;
      if (row == nullptr) continue;
      ++found.configurations;
      const int by_rule = added(before, row->after);
      found.by_rule = std::max(found.by_rule, by_rule);
      if (inserts || removes)
        found.at_most = std::max(found.at_most, std::min(by_rule, added(before, {passed_on(inner), ports})));
      else
        found.at_most = found.by_rule;
    }
  return found;
}

}  // namespace

void report_index_cost(const Family& family, const Certificate& certificate, unsigned threads,
                       const ClaimListener& listener) {
  std::vector<std::pair<const Operation*, const SectionRows*>> tasks;
  for (std::size_t i = 0; i < family.sections.size(); ++i)
    for (const Operation& operation : family.sections[i].operations)
      if (operation.most_indices) tasks.emplace_back(&operation, &certificate.sections[i]);
  if (tasks.empty()) return;
  std::mutex mutex;
  Failures wrong;
  AddedIndices all;
  double seconds = 0;
  share(tasks.size(), threads, [&](std::size_t i) {
    const double start = thread_seconds();
    const auto& [operation, rows] = tasks[i];
    const AddedIndices found = added_indices(*operation, *rows);
    const std::lock_guard lock(mutex);
    seconds += thread_seconds() - start;
    all.configurations += found.configurations;
    all.by_rule = std::max(all.by_rule, found.by_rule);
    all.at_most = std::max(all.at_most, found.at_most);
    if (found.at_most > *operation->most_indices)
      wrong.add(fmt::format("{}: adds {} to 3 strips + swaps, the family claims at most {}", operation->name(),
                            found.at_most, *operation->most_indices));
  });
  listener({family.name, fmt::format("adds at most {} to 3 strips + swaps, a rule alone {}", all.at_most, all.by_rule),
            "all configurations, all turns beyond the ports", all.configurations, seconds, wrong});
}

}  // namespace restrip::verify
