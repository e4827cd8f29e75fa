#include "automaton/index_automaton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace restrip::generator::indices {
namespace {

int least_of(const Costs& costs) {
  std::optional<int> least;
  for (const auto& cost : costs)
    if (cost && (!least || *cost < *least)) least = cost;
  return least.value_or(0);
}

Costs minus(Costs costs, int by) {
  for (auto& cost : costs)
    if (cost) *cost -= by;
  return costs;
}

/// Finds all classes breadth first. Nothing when there are more than `limit`.
std::optional<std::vector<ArcClass>> closure(const Weights& weights, bool drop, std::size_t limit) {
  std::vector<ArcClass> classes;
  std::map<Costs, std::size_t> numbers;
  classes.push_back({"", costs_of_empty_arc(), {}});
  for (std::size_t i = 0; i < classes.size(); ++i)
    for (const Letter letter : all_letters) {
      const Appended longer = i == 0 ? append_to_empty(letter, weights) : append(classes[i].costs, letter, weights);
      const Costs kept = drop ? without_dispensable(longer.costs, weights) : longer.costs;
      const int least = least_of(kept);
      const Costs costs = minus(kept, least);
      const auto [place, is_new] = numbers.emplace(costs, classes.size());
      if (is_new) {
        if (classes.size() > limit) return {};
        classes.push_back({classes[i].witness + text_of(letter), costs, {}});
      }
      ArcStep& step = classes[i].steps[static_cast<std::size_t>(letter)];
      step = {place->second, least, {}};
      for (Case c = 0; c < case_codes; ++c)
        if (costs[c]) step.before[c] = longer.before[c];
    }
  return classes;
}

void expect_weight(const char* name, int weight, int least) {
  if (weight < least || weight > largest_weight)
    throw std::invalid_argument(
        fmt::format("the weight of {} is {}; it must be from {} to {}", name, weight, least, largest_weight));
}

}  // namespace

Automaton make_automaton(const Weights& weights) {
  expect_weight("a strip", weights.restart, 1);
  expect_weight("a swap", weights.swap, 0);
  expect_weight("an isolated triangle", weights.isolated, 0);
  auto classes = closure(weights, true, most_classes);
  if (!classes)
    throw std::invalid_argument(
        fmt::format("the weights {},{},{} need more than {} classes of arcs; divide them by a common factor, or take "
                    "smaller ones in about the same proportion",
                    weights.restart, weights.swap, weights.isolated, most_classes));
  Automaton automaton{weights, std::move(*classes), {}};
  if (const auto all = closure(weights, false, most_classes)) automaton.undropped = all->size() - 1;
  return automaton;
}

}  // namespace restrip::generator::indices
