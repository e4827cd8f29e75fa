#include "judge/index_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "common/share.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {
namespace {

enum class Turn { none, one_way, other_way };

/// How a strip turns at a triangle, seen from one of its sides: over the next side counter-clockwise, or over the other
/// one; `none` if it ends there.
Turn turn_at(const Side& side, Colors colors, unsigned triangle, unsigned from) {
  const auto& around = side.around[triangle];
  const auto solid = [&](std::size_t place) {
    const unsigned at = around[place % 3];
    if (at == boundary_side) return false;
    return at < first_port_side ? is_solid(colors.inner, at) : is_solid(colors.ports, at - first_port_side);
  };
  const auto place = static_cast<std::size_t>(std::find(around.begin(), around.end(), from) - around.begin());
  return solid(place + 1) ? Turn::one_way : solid(place + 2) ? Turn::other_way : Turn::none;
}

Turn turn_at_port(const Side& side, Colors colors, unsigned port) {
  return turn_at(side, colors, side.owner_of_port[port], first_port_side + port);
}

/// Seen from an edge between them, two triangles turn the same way if their turns have different names.
int inner_swaps(const Side& side, Colors colors) {
  int swaps = 0;
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge) {
    if (!is_solid(colors.inner, edge)) continue;
    const Turn one = turn_at(side, colors, side.edges[edge][0], edge);
    const Turn other = turn_at(side, colors, side.edges[edge][1], edge);
    swaps += one != Turn::none && other != Turn::none && one != other ? 1 : 0;
  }
  return swaps;
}

}  // namespace

IndexCost::IndexCost(const Operation& operation) : operation_(operation) {
  if (!operation.is_fan()) return;
  inserts_ = carried(operation.before, operation.after);
  removes_ = carried(operation.after, operation.before);
}

std::optional<std::vector<IndexCost::Carried>> IndexCost::carried(const Side& fan, const Side& with) {
  if (fan.triangles >= with.triangles || fan.ports() != fan.triangles) return {};
  std::vector<unsigned> port_of(fan.triangles);
  for (unsigned port = 0; port < fan.ports(); ++port) port_of[fan.owner_of_port[port]] = port;
  std::vector<Carried> all;
  for (unsigned edge = 0; edge < fan.inner_edges(); ++edge) {
    Carried& one = all.emplace_back();
    one.fan = edge;
    // Along the chain of the other side, over inserted triangles, to the next port.
    unsigned at = with.owner_of_port[port_of[fan.edges[edge][0]]];
    const unsigned end = with.owner_of_port[port_of[fan.edges[edge][1]]];
    for (bool is_inserted = false; at != end; is_inserted = true) {
      const unsigned after = with.around[at][is_inserted ? 1 : 2];
      if (after >= first_port_side) return {};
      one.through |= single(after);
      at = with.edges[after][1];
    }
  }
  return all;
}

std::optional<Mask> IndexCost::passed_on(Mask inner) const {
  if (!inserts_ && !removes_) return {};
  Mask passed = 0;
  for (const Carried& one : inserts_ ? *inserts_ : *removes_) {
    if (inserts_ && is_solid(inner, one.fan)) passed |= one.through;
    if (!inserts_ && is_subset(one.through, inner)) passed |= single(one.fan);
  }
  return passed;
}

int IndexCost::change(Colors before, Colors after) const {
  const Side& old = operation_.before;
  const Side& now = operation_.after;
  int sum = 3 * (strips_of(now, after) - strips_of(old, before)) + inner_swaps(now, after) - inner_swaps(old, before);
  for (unsigned port = 0; port < operation_.ports(); ++port) {
    if (!is_solid(after.ports, port)) continue;
    const Turn turn = turn_at_port(now, after, port);
    sum += turn != Turn::none && turn != turn_at_port(old, before, port) ? 1 : 0;
  }
  return sum;
}

IndexCost::Added IndexCost::added(Colors before, Colors rule) const {
  const int by_rule = change(before, rule);
  const std::optional<Mask> passed = passed_on(before.inner);
  return {by_rule, passed ? std::min(by_rule, change(before, {*passed, before.ports})) : by_rule};
}

void report_index_cost(const Family& family, const Certificate& certificate, unsigned threads,
                       const ClaimListener& listener) {
  std::vector<std::pair<const Operation*, const SectionRows*>> tasks;
  for (std::size_t i = 0; i < family.sections.size(); ++i)
    for (const Operation& operation : family.sections[i].operations)
      if (operation.most_indices) tasks.emplace_back(&operation, &certificate.sections[i]);
  if (tasks.empty()) return;
  std::mutex mutex;
  Failures wrong;
  std::uint64_t configurations = 0;
  std::optional<int> by_rule;
  std::optional<int> at_most;
  double seconds = 0;
  share(tasks.size(), threads, [&](std::size_t i) {
    const double start = thread_seconds();
    const auto& [operation, rows] = tasks[i];
    const Keys keys(*operation);
    const IndexCost cost(*operation);
    std::optional<int> own_by_rule;
    std::optional<int> own_at_most;
    std::uint64_t own_configurations = 0;
    for (Mask both = 0; both < mask_count(operation->before.colors()); ++both) {
      const Colors before{high_part(both, operation->ports()), low_part(both, operation->ports())};
      const std::optional<Key> key = keys.key_of(before);
      const Row* const row = key ? rows->row_of(*key) : nullptr;
      if (row == nullptr) continue;
      ++own_configurations;
      const IndexCost::Added added = cost.added(before, row->after);
      own_by_rule = std::max(own_by_rule.value_or(added.by_rule), added.by_rule);
      own_at_most = std::max(own_at_most.value_or(added.at_most), added.at_most);
    }
    const std::lock_guard lock(mutex);
    seconds += thread_seconds() - start;
    configurations += own_configurations;
    by_rule = std::max(by_rule, own_by_rule);
    at_most = std::max(at_most, own_at_most);
    if (own_at_most && *own_at_most > *operation->most_indices)
      wrong.add(fmt::format("{}: adds {} to 3 strips + swaps, the family claims at most {}", operation->name(),
                            *own_at_most, *operation->most_indices));
  });
  listener(
      {family.name,
       fmt::format("adds at most {} to 3 strips + swaps, a rule alone {}", at_most.value_or(0), by_rule.value_or(0)),
       "all configurations, all turns beyond the ports", configurations, seconds, wrong});
}

}  // namespace restrip::verify
