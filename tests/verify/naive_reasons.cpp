// Reasons by exhaustive search, and wrong ones that a checker would accept if it omitted one of its checks.

#include <fmt/format.h>

#include <algorithm>

#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

int count(int mask) { return __builtin_popcount(static_cast<unsigned>(mask)); }

/// Edges are numbered consecutively: inner edges, then ports.
struct Problem {
  int edges = 0;        ///< edges that a recolouring may leave dashed
  int goal = 0;         ///< the number of edges to show dashed
  int lonely = 0;       ///< for exactly this number: isolated triangles and ports given up
  int given_up = 0;     ///< and ports given up
  std::set<int> sound;  ///< sets that may be all solid
  const NaiveOperation* operation = nullptr;
  int fixed_ports = 0;
  Careless careless = Careless::not_at_all;
};

NaiveColors colors_of(const Problem& problem, int solid) {
  const int inner_masks = 1 << problem.operation->operation().after.edges.size();
  return {solid % inner_masks, problem.fixed_ports | solid / inner_masks};
}

int given_up(const Problem& problem, int dashed) {
  return count(dashed >> problem.operation->operation().after.edges.size());
}

int lonely(const Problem& problem, int dashed) {
  return problem.operation->isolated(true, colors_of(problem, problem.edges & ~dashed)) + given_up(problem, dashed);
}

Problem problem_of(const NaiveOperation& operation, NaiveColors before, NaiveColors after, Careless careless) {
  Problem problem;
  problem.operation = &operation;
  problem.careless = careless;
  const auto inner = static_cast<int>(operation.operation().after.edges.size());
  const int all_ports = (1 << operation.ports()) - 1;
  const int open_ports = before.ports & static_cast<int>(operation.operation().may_give_up);
  problem.fixed_ports = before.ports & ~open_ports;
  problem.edges = ((1 << inner) - 1) | open_ports << inner;
  const int dashed = problem.edges & ~(after.inner | (after.ports & open_ports) << inner);
  problem.goal = count(dashed);
  problem.lonely = lonely(problem, dashed);
  problem.given_up = given_up(problem, dashed);
  if (careless == Careless::foreign_edges && operation.operation().may_give_up != 0)
    problem.edges |= all_ports << inner;
  const int joined = operation.joined(false, before);
  for (int edges = 0; edges <= problem.edges; ++edges) {
    if ((edges & problem.edges) != edges) continue;
    const NaiveColors colors = colors_of(problem, edges);
    if (operation.valid(true, colors) && (operation.joined(true, colors) | joined) == joined)
      problem.sound.insert(edges);
  }
  return problem;
}

/// Disjoint sets for a leaf, of this number.
bool choose(const Problem& problem, int wanted, int taken, std::size_t from, const std::vector<int>& sets,
            std::vector<int>& chosen) {
  if (wanted <= 0) return true;
  for (std::size_t i = from; i < sets.size(); ++i) {
    if ((sets[i] & taken) != 0) continue;
    chosen.push_back(sets[i]);
    const bool again = problem.careless == Careless::overlapping_sets;
    if (choose(problem, wanted - 1, again ? taken : taken | sets[i], again ? i : i + 1, sets, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

std::optional<std::string> leaf(const Problem& problem, int solid, int dashed) {
  std::vector<int> sets;
  for (int set = 1; set <= problem.edges; ++set) {
    if ((set & problem.edges & ~solid) != set) continue;
    const bool minimal = !problem.sound.contains(set | solid) &&
                         std::none_of(sets.begin(), sets.end(), [&](int other) { return (set & other) == other; });
    if (minimal || (problem.careless == Careless::sound_sets && count(set) == 1)) sets.push_back(set);
  }
  std::stable_sort(sets.begin(), sets.end(), [](int x, int y) { return count(x) < count(y); });
  const bool twice = problem.careless == Careless::count_dashed_twice;
  const int missing = problem.goal - count(dashed) - (problem.careless == Careless::off_by_one ? 1 : 0);
  for (const int wanted : {missing, missing + 1}) {
    std::vector<int> chosen;
    if (!choose(problem, wanted, twice ? 0 : dashed, 0, sets, chosen)) return {};
    int surely = dashed;
    for (const int set : chosen) surely |= count(set) == 1 ? set : 0;
    const int ports = given_up(problem, surely);
    const int alone = lonely(problem, surely);
    if (wanted == missing && problem.careless != Careless::only_dashed &&
        (alone < problem.lonely || (alone == problem.lonely && ports < problem.given_up)))
      continue;
    std::string text;
    for (const int set : chosen) text += fmt::format("{}{:x}", text.empty() ? "" : " ", set);
    return text.empty() ? "-" : text;
  }
  return {};
}

std::optional<std::string> tree(const Problem& problem, int solid, int dashed, int leaves) {
  if (leaves == 1) return leaf(problem, solid, dashed);
  for (int edge = 0; problem.edges >> edge != 0; ++edge) {
    const int bit = 1 << edge;
    if ((problem.edges & bit & ~solid & ~dashed) == 0) continue;
    for (int first = 1; first < leaves; ++first) {
      const auto one = problem.careless == Careless::skip_solid_case ? std::optional<std::string>("-")
                                                                     : tree(problem, solid | bit, dashed, first);
      if (!one) continue;
      const int carried = problem.careless == Careless::solid_in_both_cases ? solid | bit : solid;
      const auto other = problem.careless == Careless::skip_dashed_case
                             ? std::optional<std::string>("-")
                             : tree(problem, carried, dashed | bit, leaves - first);
      if (other) return fmt::format("if {} then {} else {}", edge, *one, *other);
    }
  }
  return {};
}

}  // namespace

std::optional<std::string> naive_reason(const NaiveOperation& operation, NaiveColors before, NaiveColors after,
                                        Careless careless) {
  const Problem problem = problem_of(operation, before, after, careless);
  // A careless reason is found at once or does not exist.
  for (int leaves = 1; leaves <= (careless == Careless::not_at_all ? 6 : 3); ++leaves)
    if (auto reason = tree(problem, 0, 0, leaves)) return reason;
  return {};
}

}  // namespace restrip::verify::test
