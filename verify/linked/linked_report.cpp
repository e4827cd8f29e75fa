#include "linked/linked_report.hpp"

#include <fmt/format.h>

namespace restrip::verify {
namespace {

LinkedCheck sum_of(const std::vector<LinkedCheck>& checks) {
  LinkedCheck sum;
  for (const LinkedCheck& check : checks) {
    sum.searched = sum.searched && check.searched;
    sum.recolorings += check.recolorings;
    sum.worlds += check.worlds;
    sum.beside += check.beside;
    sum.configurations += check.configurations;
    for (std::size_t i = 0; i < list_claim_count; ++i) sum.lists[i].add(check.lists[i]);
    sum.condition.add(check.condition);
    sum.best.add(check.best);
    sum.local.add(check.local);
    sum.claims.add(check.claims);
    sum.counts[1] += check.counts[1];
    sum.listing_seconds += check.listing_seconds;
    sum.beside_seconds += check.beside_seconds;
  }
  return sum;
}

}  // namespace

void report_linked(const LinkedFamily& family, const std::vector<LinkedCheck>& checks, const ClaimListener& listener) {
  const LinkedCheck sum = sum_of(checks);
  const auto rows = static_cast<std::uint64_t>(sum.counts[1]);
  std::uint64_t lists = 0;
  for (const Section& section : family.local.sections) lists += mask_count(section.ports);
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
                          const Failures& failures) {
    listener({family.name, claim, method, cases, seconds, failures.count, failures.first});
  };
  const std::string limit = sum.searched ? "" : fmt::format(", k <= {}", most_searched_ports);
  const auto of = [&](ListClaim claim) { return sum.lists[static_cast<std::size_t>(claim)]; };

  report("every port mask has its list", "all port masks", lists, 0, of(ListClaim::present));
  report("every alternative is legal", "degrees counted, cycles looked for", rows, 0, of(ListClaim::legal));
  report("lists are in order of preference", "solid edges, isolated triangles counted", rows, 0,
         of(ListClaim::ordered));
  report("no alternative is covered by an earlier one", "ports joined compared", rows, 0, of(ListClaim::uncovered));
  report("lists are complete", "all recolourings, ports joined compared", sum.recolorings, sum.listing_seconds,
         of(ListClaim::complete));
  report("an alternative is sound just when its pairs say so", "patch and outside as one graph, all worlds" + limit,
         sum.beside, 0, sum.condition);
  report("beside any outside nothing beats the first sound one", "the same graphs, search of all recolourings" + limit,
         sum.worlds, sum.beside_seconds, sum.best);
  report("where only colours are known it equals the local rule",
         fmt::format("the same graphs; {}.cert{}", family.local.name, limit), sum.configurations, 0, sum.local);
  report("the stated numbers", "recounted", linked_claim_words.size() * checks.size(), 0, sum.claims);
}

}  // namespace restrip::verify
