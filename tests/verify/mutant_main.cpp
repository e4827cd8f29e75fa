// Gives the checker one deliberate fault, named by the argument, and tells the first table of the corpus that shows it.
// With the fault `none` it must find no such table.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "bad_tables.hpp"
#include "corpus.hpp"
#include "mutants.hpp"
#include "named_mutant.hpp"
#include "verdict.hpp"

namespace {

using namespace restrip::verify::test;
using restrip::verify::Mutant;

std::string first_good_table_rejected() {
  for (const NaiveFamily& family : naive_families(corpus_max_k))
    for (const NaiveSection& section : family.sections)
      if (verdict_of(naive_table(family, section)).exit_code != 0)
        return fmt::format("good table {} {}", family.name, section.position);
  return {};
}

std::string first_bad_table_accepted() {
  std::string killer;
  for_each_bad_table(corpus_max_k, [&](const BadTable& bad) {
    if (!verdict_of(bad.table).says(bad.expected)) killer = bad.crime;
    return killer.empty();
  });
  return killer;
}

std::string first_list_misjudged() {
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  std::string killer;
  for (const NaiveLinked& linked : naive_linked(families)) {
    const auto right = [&](const DoubtfulLists& doubtful) {
      if (verdict_of(doubtful.lists, linked.local()).crimes != linked.crimes(doubtful.lists)) killer = doubtful.damage;
      return killer.empty();
    };
    if (right({"good lists", linked.good()})) for_each_doubtful(linked, right);
    if (!killer.empty()) break;
  }
  return killer;
}

std::string first_damage_accepted() {
  for (const Damage& damage : damages()) {
    const Verdict verdict = verdict_of(DamagedTables(damage).path());
    if (verdict.exit_code != damage.exit_code || !verdict.says(damage.message)) return damage.name;
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Mutant> mutant = argc == 2 ? mutant_named<Mutant>(argv[1]) : std::nullopt;
  if (!mutant) {
    fmt::print(stderr, "usage: verify_mutants NAME, with a name from verify/mutants.hpp\n");
    return 2;
  }
  restrip::verify::active_mutant = *mutant;
  for (const auto search :
       {first_damage_accepted, first_good_table_rejected, first_list_misjudged, first_bad_table_accepted})
    if (const std::string killer = search(); !killer.empty()) {
      fmt::print("killed by: {}\n", killer);
      return 0;
    }
  fmt::print("survived\n");
  return 1;
}
