#include "linked.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

#include "section.hpp"

namespace restrip::generator {
namespace {

using Pairs = std::vector<Mask>;

struct Candidate {
  Alternative alternative;
  CriterionValues values{};

  [[nodiscard]] auto rank() const { return std::tie(values, alternative.recoloring); }
};

bool is_part_of(const Pairs& some, const Pairs& all) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

std::vector<Alternative> list_of(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports) {
  const Side& after = operation.patch.after;
  // For each pairing its best recolouring; then those that no better one covers.
  std::map<Pairs, Candidate> best;
  for (const Coloring& coloring : colorings) {
    const auto outcome = with_ports(coloring, ports);
    if (!outcome) continue;
    Pairs pairs = outcome->pairs;
    std::sort(pairs.begin(), pairs.end());
    const Candidate candidate{{coloring.inner, outcome->solid, outcome->isolated, pairs},
                              values_of(operation.preference, after, coloring, *outcome, ports, ports)};
    const auto [place, fresh] = best.try_emplace(pairs, candidate);
    if (!fresh && candidate.rank() < place->second.rank()) place->second = candidate;
  }
  std::vector<Candidate> candidates;
  candidates.reserve(best.size());
  for (const auto& [pairs, candidate] : best) candidates.push_back(candidate);
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& x, const Candidate& y) { return x.rank() < y.rank(); });
  std::vector<Alternative> list;
  for (const Candidate& candidate : candidates) {
    const bool covered = std::any_of(list.begin(), list.end(), [&](const Alternative& earlier) {
      return is_part_of(earlier.pairs, candidate.alternative.pairs);
    });
    if (!covered) list.push_back(candidate.alternative);
  }
  return list;
}

}  // namespace

std::vector<LinkedSection> linked_sections_of(const Family& family, unsigned max_k) {
  std::vector<LinkedSection> sections;
  for (const Section& section : sections_of(family.certificate, max_k))
    sections.push_back({section.position, {}, Goal::strips});
  return sections;
}

void solve(LinkedSection& section) {
  const Operation operation = operation_of(section.position, Sight::outside, section.goal);
  const std::vector<Coloring> colorings = legal_colorings(operation.patch.after);
  for (Mask ports = 0; ports < Mask{1} << section.position.k; ++ports)
    section.lists.push_back(list_of(operation, colorings, ports));
}

}  // namespace restrip::generator
