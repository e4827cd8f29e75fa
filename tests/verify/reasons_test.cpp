// Nothing in a shipped reason is idle: with a set left out, a set that lost an edge, a set that stands twice, or a case
// left unproved it is a reason no more.

#include "reasons.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <utility>

#include "input.hpp"

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
  for (const Family& family : all_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const Certificate certificate = parse_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < family.sections.size(); ++i)
      for (Row row : certificate.sections[i].rows) {
        if (row.copy) continue;
        ++rules;
        const Section& section = family.sections[i];
        ASSERT_EQ(fault_of_reason(row, section), "") << file << ':' << row.line;
        for_each_damage(row.reason, [&](const char* what) {
          ++damages;
          if (fault_of_reason(row, section).empty() && ++survivors < 5)
            ADD_FAILURE() << file << ':' << row.line << ": " << what << ": " << row.reason.text();
        });
      }
  }
  std::cout << rules << " rules, " << damages << " damages\n";
  EXPECT_GT(damages, rules);
  EXPECT_EQ(survivors, 0);
}

}  // namespace
}  // namespace restrip::verify
