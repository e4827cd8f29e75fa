#include "linked/linked_report.hpp"

#include <fmt/format.h>

namespace restrip::verify {

void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener) {
  std::uint64_t lists = 0;
  for (const Section& section : family.local.sections) lists += mask_count(section.ports);
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
                          const Failures& failures) {
    listener({family.name, claim, method, cases, seconds, failures.count, failures.first});
  };
  const std::string limit = sum.searched ? "" : fmt::format(", k <= {}", most_searched_ports);
  const auto of = [&](ListClaim claim) { return sum.lists[static_cast<std::size_t>(claim)]; };

  report("every port mask has its list", "all port masks", lists, 0, of(ListClaim::present));
  report("every alternative is legal", "degrees counted, cycles looked for", sum.rows, 0, of(ListClaim::legal));
  report("lists are in order of preference", "solid edges, isolated triangles counted", sum.rows, 0,
         of(ListClaim::ordered));
  report("no alternative is covered by an earlier one", "ports joined compared", sum.rows, 0, of(ListClaim::uncovered));
  report("lists are complete", "all recolourings, ports joined compared", sum.recolorings, sum.listing_seconds,
         of(ListClaim::complete));
  report("an alternative is sound just when its pairs say so", "patch and outside as one graph, all worlds" + limit,
         sum.beside, 0, sum.condition);
  report("beside any outside nothing beats the first sound one", "the same graphs, search of all recolourings" + limit,
         sum.worlds, sum.beside_seconds, sum.best);
  report("where only colours are known it equals the local rule",
         fmt::format("the same graphs; {}.cert{}", family.local.name, limit), sum.configurations, 0, sum.local);
  report("the stated numbers", "recounted", linked_claim_words.size() * sum.sections, 0, sum.claims);
}

}  // namespace restrip::verify
