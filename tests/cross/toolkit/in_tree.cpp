// Claim: a program linked with custom tables uses them, although the library is named first, and they are as good as
// the automaton's answers; C tables generated with them answer the same.
#include <cstdio>

#include "restrip/rules/exact.hpp"
#include "restrip/rules/rules.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#define RESTRIP_RULE_OF_BISECT_IMPLEMENTATION
#include "restrip_rule_of_bisect.h"
#define RESTRIP_TABLES_IMPLEMENTATION
#include "restrip_tables.h"

static_assert(restrip::table_max_k == 4);
static_assert(restrip::tables::rule_of(restrip::tables::bisect_rules, 0, 0).valid);
static_assert(restrip::tables::rule_of(restrip::tables::bisect_boundary_rules, 0, 0).valid);

int main() {
  int compared = 0;
  for (std::size_t k = 3; k <= 5; ++k)  // 5 is answered without a table
    for (std::size_t a = 1; a < k; ++a)
      for (restrip::Word loop = 0; loop < restrip::bit(k); ++loop)
        for (restrip::Word ports = 0; ports < restrip::bit(k); ++ports) {
          const restrip::Rule rule = restrip::split_rule({k, a}, loop, ports);
          if (rule.valid != restrip::closed_fan(k).valid(loop, ports)) return 1;
          if (!rule.valid) continue;
          const restrip_rule in_c = restrip_split(static_cast<unsigned>(k), static_cast<unsigned>(a),
                                                  static_cast<unsigned>(loop), static_cast<unsigned>(ports));
          if ((in_c.valid != 0) != (k <= 4)) return 1;
          if (k <= 4 && in_c.colors != rule.colors) return 1;
          const auto best =
              restrip::exact::best(restrip::ring_with_chord(k, a), ports, restrip::closed_fan(k).joined(loop, ports));
          if (std::popcount(rule.colors) != best.value.solid) return 1;
          ++compared;
        }
  for (unsigned inner = 0; inner < 2; ++inner)
    for (unsigned ports = 0; ports < 16; ++ports) {
      const restrip::tables::OperationRule rule = restrip::tables::rule_of(restrip::tables::bisect_rules, inner, ports);
      const restrip_operation_rule in_c = restrip_rule_of_bisect(inner, ports);
      if (in_c.valid != rule.valid || in_c.colors != rule.colors || in_c.ports != rule.ports ||
          in_c.strips != rule.strips)
        return 1;
      ++compared;
    }
  std::printf("%d rules\n", compared);
  return compared == 2 * 44 + 3 * 160 + 4 * 572 + 32 ? 0 : 1;
}
