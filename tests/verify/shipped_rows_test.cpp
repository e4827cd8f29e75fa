// Every part of the shipped rows matters. Every single-bit flip of a recolouring is noticed, for every configuration
// that the row serves. (A flip in a row's key leaves its old key without a row, which the corpus tests check for every
// row.) A reason becomes invalid if a set is removed, loses an edge or is repeated, or if a case is left unproved.

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <set>
#include <utility>

#include "certificate/certificate.hpp"
#include "judge/operation_judge.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// Calls back for each damage, and then undoes it.
void for_each_damage(Reason& reason, const std::function<void(const char*)>& visit) {
  for (Reason& each : reason.cases) {
    for_each_damage(each, visit);
    const Reason whole = std::exchange(each, Reason{});
    if (!whole.cases.empty() || !whole.sets.empty()) visit("a case is left unproved");
    each = whole;
  }
  const std::vector<Mask> sets = reason.sets;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    reason.sets.erase(reason.sets.begin() + static_cast<std::ptrdiff_t>(i));
    visit("a set is left out");
    reason.sets = sets;
    for (unsigned edge = 0; edge < 32; ++edge) {
      if (!is_solid(sets[i], edge)) continue;
      reason.sets[i] = sets[i] & ~single(edge);
      visit("a set lost an edge");
      reason.sets = sets;
    }
    if (i == 0) continue;
    reason.sets[i] = sets[0];
    visit("a set stands twice");
    reason.sets = sets;
  }
}

/// Each flip is noticed; returns their number.
std::uint64_t flip_bits(const OperationJudge& judge, Colors configuration, const Row& row) {
  const auto try_one = [&](Mask inner, Mask ports) {
    const Colors flipped{row.after.inner ^ inner, row.after.ports ^ ports};
    EXPECT_NE(judge.judged(configuration, flipped).verdict, Verdict::right) << row.text();
  };
  for (unsigned edge = 0; edge < judge.operation().after.inner_edges(); ++edge) try_one(single(edge), 0);
  for (unsigned port = 0; port < judge.operation().ports(); ++port) try_one(0, single(port));
  return judge.operation().after.inner_edges() + judge.operation().ports();
}

/// Each damage is noticed; returns their number.
std::uint64_t damage_reason(const OperationJudge& judge, Colors configuration, const Row& row) {
  std::uint64_t damages = 0;
  Reason reason = row.reason.value();
  const auto fault = [&] { return fault_of_reason(judge, configuration, row.after, reason); };
  EXPECT_EQ(fault(), "") << row.text();
  for_each_damage(reason, [&](const char* what) {
    ++damages;
    EXPECT_NE(fault(), "") << row.text() << ": " << what << ": " << reason.text();
  });
  return damages;
}

TEST(ShippedRows, NothingInThemIsIdle) {
  std::uint64_t flips = 0;
  std::uint64_t damages = 0;
  std::uint64_t rules = 0;
  for (const Family& family : tabled_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const Certificate certificate = parse_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < family.sections.size(); ++i) {
      std::set<Key> done;  // in some position of the section
      for (const Operation& operation : family.sections[i].operations) {
        const OperationJudge judge(operation);
        std::set<const std::vector<unsigned>*>
            judged;  // worlds: configurations that may stand in the same are one case
        for (Mask both = 0; both < mask_count(operation.before.colors()); ++both) {
          const Colors configuration{high_part(both, operation.ports()), low_part(both, operation.ports())};
          const std::optional<Key> key = judge.key_of(configuration);
          if (!key || !judged.insert(&judge.definition()->worlds(configuration)).second) continue;
          const Row* const row = certificate.sections[i].row_of(*key);
          ASSERT_NE(row, nullptr) << operation.name();
          flips += flip_bits(judge, configuration, *row);
          if (row->copy || !done.insert(row->key).second) continue;
          ++rules;
          damages += damage_reason(judge, configuration, *row);
          ASSERT_FALSE(HasFailure()) << file << ':' << row->line;
        }
      }
    }
  }
  std::cout << flips << " flips; " << rules << " rules, " << damages << " damages of their reasons\n";
  EXPECT_GT(flips, 100'000U);
  EXPECT_GT(damages, rules);
}

}  // namespace
}  // namespace restrip::verify
