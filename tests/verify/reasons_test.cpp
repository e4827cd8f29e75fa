// Nothing in a shipped reason is idle: with a set left out, a set that lost an edge, a set that stands twice, or a case
// left unproved it is a reason no more.

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <utility>

#include "certificate/certificate.hpp"
#include "judge/reason_check.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// Calls back for each damage, which is undone afterwards.
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

TEST(Reasons, NothingInThemIsIdle) {
  std::uint64_t rules = 0;
  std::uint64_t damages = 0;
  int survivors = 0;
  std::map<unsigned, FitTable> tables;
  for (const Family& family : all_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const Certificate certificate = parse_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < family.sections.size(); ++i) {
      std::set<Key> done;  // in some position of the section
      for (const Operation& operation : family.sections[i].operations) {
        const RuleJudge judge(
            operation, tables.try_emplace(operation.ports(), Constraint::strips, operation.ports()).first->second);
        for (const ColoringClass& configurations : judge.before().classes()) {
          const Row* const row = certificate.sections[i].row_of(judge.key_of(configurations.first));
          ASSERT_NE(row, nullptr) << operation.name();
          if (row->copy || !done.insert(row->key).second) continue;
          ++rules;
          Reason reason = row->reason.value();
          const auto fault = [&] { return fault_of_reason(judge, configurations.first, row->after, reason); };
          ASSERT_EQ(fault(), "") << file << ':' << row->line;
          for_each_damage(reason, [&](const char* what) {
            ++damages;
            if (fault().empty() && ++survivors < 5)
              ADD_FAILURE() << file << ':' << row->line << ": " << what << ": " << reason.text();
          });
        }
      }
    }
  }
  std::cout << rules << " rules, " << damages << " damages\n";
  EXPECT_GT(damages, rules);
  EXPECT_EQ(survivors, 0);
}

}  // namespace
}  // namespace restrip::verify
