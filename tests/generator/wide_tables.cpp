// Compiled tables beyond k = 8: every rule of k = 9 is as good as the result of the runtime's exact solver. Run by
// wide_tables.sh.
#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

#include "../runtime/naive_patch.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/tables/collapse.hpp"
#include "restrip/tables/flip.hpp"
#include "restrip/tables/rows.hpp"
#include "restrip/tables/split.hpp"

namespace {

using restrip::Word;
using restrip::exact::Value;
namespace tables = restrip::tables;

constexpr unsigned k = 9;

Value value_of(const naive::Patch& patch, Word colors, Word ports) {
  const auto found = naive::analyze(patch, naive::bits_of(colors, patch.edges.size()), naive::bits_of(ports, k));
  return found.valid ? Value{found.solid, found.isolated} : Value{-1, -1};
}

int checked = 0;
int wrong = 0;

void expect(const Value& found, const Value& best) {
  ++checked;
  wrong += found == best ? 0 : 1;
}

template <class Table, class Rows>
Word cell(const Table& table, const Rows& rows, unsigned place, Word ports, Word joined) {
  return table.rules.at(table.first[k] + std::size_t{place} * table.cells[k] + rows[Word{1} << k | ports] + joined);
}

void closed_families(Word ports, Word joined) {
  for (unsigned a = 1; 2 * a <= k; ++a) {
    const naive::Patch ring = naive::ring_with_chord(k, a);
    const Value best = restrip::exact::best(restrip::ring_with_chord(k, a), ports, joined).value;
    expect(value_of(ring, cell(tables::split, tables::closed_rows, a - 1, ports, joined), ports), best);
  }
  const Value best = restrip::exact::best(restrip::closed_fan(k), ports, joined).value;
  const naive::Patch fan = naive::closed_fan(k);
  expect(value_of(fan, cell(tables::collapse, tables::closed_rows, 0, ports, joined), ports), best);
}

}  // namespace

int main() {
  std::set<std::pair<Word, Word>> closed_keys;
  for (Word loop = 0; loop < Word{1} << k; ++loop)
    for (Word ports = 0; ports < Word{1} << k; ++ports)
      if (const auto fan = restrip::closed_fan(k); fan.valid(loop, ports))
        closed_keys.emplace(ports, fan.joined(loop, ports));
  for (const auto& [ports, joined] : closed_keys) closed_families(ports, joined);
  std::printf("%zu keys of k = %u: %d rules, %d wrong\n", closed_keys.size(), k, checked, wrong);
  return wrong == 0 && checked > 0 ? 0 : 1;
}
