// Compiled tables beyond k = 8: every rule and every list of k = 9 is as good as the result of the runtime's exact
// solver, and so is the choice of the linked look-up if no strip is followed to its end. Run by wide_tables.sh.
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "../runtime/naive_patch.hpp"
#include "restrip/operations/linked.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/tables/boundary_split.hpp"
#include "restrip/tables/collapse.hpp"
#include "restrip/tables/fan_collapse.hpp"
#include "restrip/tables/flip.hpp"
#include "restrip/tables/linked.hpp"
#include "restrip/tables/open_split.hpp"
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

Word partner(Word pairing, unsigned port) { return pairing >> (4 * port) & 15U; }

/// The first alternative of a list that joins only ports joined according to the key: nothing else is known.
template <class Table>
Word first_of(const Table& table, unsigned place, Word ports, Word joined) {
  const auto known = naive::pairs_of(naive::closed_fan(k), naive::bits_of(ports, k), naive::bits_of(joined, k));
  const std::size_t list = table.first[k] + (std::size_t{place} << k) + ports;
  for (std::size_t at = table.start[list]; at < table.start[list + 1]; ++at) {
    const Word pairing = tables::pairings[table.rules[at].pairing];
    bool sound = true;
    for (unsigned port = 0; port < k; ++port) {
      const auto other = static_cast<unsigned>(partner(pairing, port));
      if (other >= k || partner(pairing, other) != port) return ~Word{0};
      sound = sound && (other == port || known.count({std::min(port, other), std::max(port, other)}) != 0);
    }
    if (sound) return table.rules[at].recoloring;
  }
  return ~Word{0};
}

void closed_families(Word loop, Word ports, Word joined) {
  const auto nothing_seen = [](std::size_t) { return restrip::out_of_sight; };
  for (unsigned a = 1; 2 * a <= k; ++a) {
    const naive::Patch ring = naive::ring_with_chord(k, a);
    const Value best = restrip::exact::best_split(k, a, ports, joined).value;
    expect(value_of(ring, cell(tables::split, tables::closed_rows, a - 1, ports, joined), ports), best);
    expect(value_of(ring, first_of(tables::linked_split, a - 1, ports, joined), ports), best);
    expect(value_of(ring, restrip::linked_split_rule({k, a}, loop, ports, nothing_seen).colors, ports), best);
  }
  const Value best = restrip::exact::best_collapse(k, ports, joined).value;
  const naive::Patch fan = naive::closed_fan(k);
  expect(value_of(fan, cell(tables::collapse, tables::closed_rows, 0, ports, joined), ports), best);
  expect(value_of(fan, first_of(tables::linked_collapse, 0, ports, joined), ports), best);
}

void open_families(Word ports, Word joined) {
  unsigned place = 0;
  for (unsigned i = 0; i < k; ++i)
    for (unsigned j = i + 1; j <= k && i + j <= k; ++j)
      expect(value_of(naive::path_with_chord(k, i, j),
                      cell(tables::open_split, tables::open_rows, place++, ports, joined), ports),
             restrip::exact::best_open_split(k, i, j, ports, joined).value);
  for (unsigned i = 0; 2 * i <= k; ++i)
    expect(value_of(naive::path(k, i), cell(tables::boundary_split, tables::open_rows, i, ports, joined), ports),
           restrip::exact::best_boundary_split(k, i, ports, joined).value);
  expect(value_of(naive::open_fan(k), cell(tables::fan_collapse, tables::open_rows, 0, ports, joined), ports),
         restrip::exact::best_fan_collapse(k, ports, joined).value);
}

}  // namespace

int main() {
  std::map<std::pair<Word, Word>, Word> closed_keys;  // each with a loop that has it
  std::set<std::pair<Word, Word>> open_keys;
  for (Word loop = 0; loop < Word{1} << k; ++loop)
    for (Word ports = 0; ports < Word{1} << k; ++ports) {
      if (restrip::valid_closed(k, loop, ports)) closed_keys[{ports, restrip::joined_closed(k, loop, ports)}] = loop;
      if (loop < Word{1} << (k - 1) && restrip::valid_open(k, loop, ports))
        open_keys.emplace(ports, restrip::joined_open(k, loop, ports));
    }
  for (const auto& [key, loop] : closed_keys) closed_families(loop, key.first, key.second);
  for (const auto& [ports, joined] : open_keys) open_families(ports, joined);
  std::printf("%zu and %zu keys of k = %u: %d rules and lists, %d wrong\n", closed_keys.size(), open_keys.size(), k,
              checked, wrong);
  return wrong == 0 && checked > 0 ? 0 : 1;
}
