#include "family_check.hpp"

#include <fmt/format.h>

#include "quantity.hpp"
#include "reasons.hpp"
#include "reference.hpp"

namespace restrip::verify {
namespace {

/// The sums of a family.
struct FamilyTally {
  std::uint64_t valid = 0;
  std::uint64_t configurations = 0;
  std::uint64_t counted_by_nauty = 0;
  std::uint64_t with_row = 0;
  std::uint64_t with_sound_row = 0;
  std::uint64_t pairs = 0;
  std::array<Failures, row_claim_count> row_failures;
  Failures extra;
  Failures witnesses;
  Failures claims;
  ReasonTally reasons;
  Failures orbits;
  Failures cost;
  Failures reference;
  std::uint64_t reference_cases = 0;
  int worst_strips = 0;
  int worst_isolated = 0;
  Agreement agreement;
  bool all_searched = true;
  double judging = 0;
  double agreeing = 0;
  double reasoning = 0;
  double burnside = 0;
  double nauty = 0;
};

void compare_with_reference(const Operation& operation, const OperationCheck& check, FamilyTally& tally) {
  for (const ReferenceCount& reference : reference_counts) {
    if (reference.operation != operation.name()) continue;
    const auto compare = [&](const char* what, std::optional<std::uint64_t> published, std::uint64_t counted) {
      if (!published) return;
      ++tally.reference_cases;
      if (*published != counted)
        tally.reference.add(
            fmt::format("{}: {}: {} published, {} counted", operation.name(), what, *published, counted));
    };
    compare("configurations", reference.configurations, check.judgment.configurations);
    compare("valid", reference.valid, check.judgment.valid);
    compare("orbits", reference.orbits, check.burnside.all);
    compare("orbits of valid", reference.valid_orbits, check.burnside.valid);
    compare("costing", reference.costing, check.judgment.costing);
  }
}

/// What its family claims of the rules of an operation.
void check_facts(const Operation& operation, const Judgment& judgment, FamilyTally& tally) {
  const int strips = judgment.worst_strips.value_or(0);
  const int isolated = judgment.worst_isolated.value_or(0);
  tally.worst_strips = std::max(tally.worst_strips, strips);
  tally.worst_isolated = std::max(tally.worst_isolated, isolated);
  if (operation.most_isolated && isolated > *operation.most_isolated)
    tally.cost.add(fmt::format("{}: a rule isolates {} more, the family claims at most {}", operation.name(),
                               quantity(static_cast<std::uint64_t>(isolated), "triangle"), *operation.most_isolated));
  if (operation.most_strips && strips > *operation.most_strips)
    tally.cost.add(fmt::format("{}: a rule costs {}, the family claims at most {}", operation.name(),
                               quantity(static_cast<std::uint64_t>(strips), "strip"), *operation.most_strips));
}

void add(const OperationCheck& check, const Operation& operation, FamilyTally& tally) {
  tally.all_searched = tally.all_searched && searched(operation);
  tally.valid += check.judgment.valid;
  tally.configurations += check.judgment.configurations;
  if (searched(operation)) tally.counted_by_nauty += check.judgment.configurations;
  tally.with_row += check.judgment.with_row;
  tally.with_sound_row += check.judgment.with_sound_row;
  tally.pairs += check.judgment.pairs;
  for (std::size_t i = 0; i < row_claim_count; ++i) tally.row_failures[i].add(check.judgment.failures[i]);
  if (check.burnside != check.nauty)
    tally.orbits.add(fmt::format("{}: {} orbits, {} valid by Burnside; {}, {} by canonical forms", operation.name(),
                                 check.burnside.all, check.burnside.valid, check.nauty.all, check.nauty.valid));
  check_facts(operation, check.judgment, tally);
  compare_with_reference(operation, check, tally);
  tally.agreement.configurations += check.agreement.configurations;
  tally.agreement.pairs += check.agreement.pairs;
  tally.agreement.optima += check.agreement.optima;
  tally.agreement.hitting_set_problems += check.agreement.hitting_set_problems;
  tally.agreement.disagreements.add(check.agreement.disagreements);
  tally.judging += check.judging_seconds;
  tally.agreeing += check.agreement_seconds;
  tally.burnside += check.burnside_seconds;
  tally.nauty += check.nauty_seconds;
}

FamilyTally tally_of(const Family& family, const Certificate& certificate, const std::vector<OperationCheck>& checks) {
  FamilyTally tally;
  auto check = checks.begin();
  for (std::size_t i = 0; i < family.sections.size(); ++i) {
    const Section& section = family.sections[i];
    const SectionRows& rows = certificate.sections[i];
    Recount recount;
    std::vector<bool> used(rows.rows.size());
    for (const Operation& operation : section.operations) {
      add(*check, operation, tally);
      recount.add(check->judgment, check->burnside);
      for (std::size_t row = 0; row < used.size(); ++row) used[row] = used[row] || check->judgment.row_used[row];
      ++check;
    }
    tally.extra.add(extra_rows(section, rows, used, certificate.file));
    tally.witnesses.add(wrong_witnesses(section, rows, certificate.file));
    tally.claims.add(wrong_claims(rows, recount, certificate.file));
    const double start = thread_seconds();
    check_reasons(section, rows, certificate.file, tally.reasons);
    tally.reasoning += thread_seconds() - start;
  }
  return tally;
}

}  // namespace

void report_family(const Family& family, const Certificate& certificate, const std::vector<OperationCheck>& checks,
                   bool second_formulation, const ClaimListener& listener) {
  const FamilyTally tally = tally_of(family, certificate, checks);
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
                          const Failures& failures) {
    listener({family.name, claim, method, cases, seconds, failures.count, failures.first});
  };
  // Fans beyond largest_fan are not searched.
  const std::string limit = tally.all_searched ? "" : fmt::format(", k <= {}", largest_fan);
  const auto rows = [&](RowClaim claim) { return tally.row_failures[static_cast<std::size_t>(claim)]; };

  report("every valid configuration has a row", "all configurations as graphs", tally.valid, 0,
         rows(RowClaim::covered));
  report("every row has a valid configuration", "all configurations as graphs", certificate.rows, 0, tally.extra);
  report("every row is sound", "strips walked, ports joined compared", tally.with_row, 0, rows(RowClaim::sound));
  report("no sound recolouring has more solid edges", "search of all recolourings" + limit, tally.pairs, tally.judging,
         rows(RowClaim::most_solid));
  report("none with as many isolates fewer triangles", "the same search" + limit, tally.pairs, 0,
         rows(RowClaim::fewest_isolated));
  if (family.sections.front().operations.front().gives_ports_up)
    report("none with as many of both keeps more ports", "the same search", tally.pairs, 0,
           rows(RowClaim::most_ports_kept));
  report("every rule has a reason why nothing is preferred to it",
         fmt::format("{} by disjoint sets, {} case trees to {} leaves", tally.reasons.rules - tally.reasons.trees,
                     tally.reasons.trees, tally.reasons.most_cases),
         tally.reasons.rules, tally.reasoning, tally.reasons.wrong);
  if (second_formulation) {
    const std::string problems = fmt::format("{} smallest hitting sets", tally.agreement.hitting_set_problems);
    report("strips and forbidden sets agree on what is sound", "no forbidden set contained" + limit,
           tally.agreement.pairs, tally.agreeing, tally.agreement.disagreements);
    report("and on every optimum", problems + limit, tally.agreement.optima, 0, tally.agreement.disagreements);
  }
  report("copies follow from rules by symmetry", "symmetries as graph automorphisms", certificate.rows, 0,
         tally.witnesses);
  report("the stated numbers", "recounted; orbits by Burnside's lemma", claim_words.size() * family.sections.size(),
         tally.burnside, tally.claims);
  report("the orbits once more", "nauty, canonical coloured graphs" + limit, tally.counted_by_nauty, tally.nauty,
         tally.orbits);
  report(fmt::format("no rule costs above {}, isolates above {}",
                     quantity(static_cast<std::uint64_t>(tally.worst_strips), "strip"), tally.worst_isolated),
         "maximum; and what the family claims", tally.with_sound_row, 0, tally.cost);
  if (tally.reference_cases != 0)
    report("the published counts", "docs/theory.md, section 5", tally.reference_cases, 0, tally.reference);
}

}  // namespace restrip::verify
