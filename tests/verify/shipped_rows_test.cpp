// Every part of the shipped rows matters. Every single-bit flip of a recolouring is noticed, for every configuration
// that the row serves. (A flip in a row's key leaves its old key without a row, which the corpus tests check for every
// row.) A reason becomes invalid if a set is removed, loses an edge or is repeated, or if a case is left unproved.

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <set>
#include <utility>

#include "certificate/certificate.hpp"
#include "judge/reason_check.hpp"
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

/// The alterations, and how often one was not noticed.
struct Altered {
  std::uint64_t all = 0;
  std::uint64_t survivors = 0;
};

Altered flipped_bits(const OperationJudge& judge, Colors configuration, const Row& row) {
  Altered flips;
  const auto try_one = [&](Mask inner, Mask ports) {
    ++flips.all;
    const Colors flipped{row.after.inner ^ inner, row.after.ports ^ ports};
    if (judge.judged(configuration, flipped).verdict == Verdict::right) ++flips.survivors;
  };
  for (unsigned edge = 0; edge < judge.operation().after.inner_edges(); ++edge) try_one(single(edge), 0);
  for (unsigned port = 0; port < judge.operation().ports(); ++port) try_one(0, single(port));
  return flips;
}

Altered damaged_reasons(const OperationJudge& judge, Colors configuration, const Row& row) {
  Altered damages;
  Reason reason = row.reason.value();
  const auto fault = [&] { return fault_of_reason(judge, configuration, row.after, reason); };
  EXPECT_EQ(fault(), "") << row.text();
  for_each_damage(reason, [&](const char* what) {
    ++damages.all;
    if (!fault().empty()) return;
    ++damages.survivors;
    ADD_FAILURE() << row.text() << ": " << what << ": " << reason.text();
  });
  return damages;
}

TEST(ShippedRows, NothingInThemIsIdle) {
  Altered flips;
  Altered damages;
  const auto add = [](Altered& sum, const Altered& more) {
    sum.all += more.all;
    sum.survivors += more.survivors;
  };
  std::uint64_t rules = 0;
  for (const Family& family : all_families()) {
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
          add(flips, flipped_bits(judge, configuration, *row));
          if (row->copy || !done.insert(row->key).second) continue;
          ++rules;
          add(damages, damaged_reasons(judge, configuration, *row));
          ASSERT_FALSE(HasFailure()) << file << ':' << row->line;
        }
      }
    }
  }
  std::cout << flips.all << " flips; " << rules << " rules, " << damages.all << " damages of their reasons\n";
  EXPECT_GT(flips.all, 100'000U);
  EXPECT_EQ(flips.survivors, 0U);
  EXPECT_GT(damages.all, rules);
  EXPECT_EQ(damages.survivors, 0U);
}

}  // namespace
}  // namespace restrip::verify
