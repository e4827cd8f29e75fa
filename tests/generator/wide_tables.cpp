// Compiled tables beyond k = 8: every rule and every list of k = 9 is as good as the result of the runtime's exact
// solver, and so is the choice of the linked look-up if no strip is followed to its end. Run by wide_tables.sh.
#include <bit>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

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

/// A row of elements, each joined to the next, perhaps in a ring, perhaps with a chord; some have a port.
struct Shape {
  unsigned elements = k;
  bool ring = false;
  unsigned chord_from = 0;
  unsigned chord_to = 0;  ///< no chord if both are 0
};

Value value_of(const Shape& shape, Word colors, Word ports, Word elements_without_port) {
  Word covered = 0;
  const auto cover = [&](unsigned edge, unsigned u, unsigned v) {
    if ((colors >> edge & 1U) != 0) covered |= Word{1} << u | Word{1} << v;
  };
  const unsigned edges = shape.ring ? shape.elements : shape.elements - 1;
  for (unsigned e = 0; e < edges; ++e) cover(e, e, (e + 1) % shape.elements);
  if (shape.chord_to != 0) cover(edges, shape.chord_from, shape.chord_to);
  unsigned port = 0;
  for (unsigned element = 0; element < shape.elements; ++element) {
    if ((elements_without_port >> element & 1U) != 0) continue;
    covered |= (ports >> port++ & 1U) << element;
  }
  return {std::popcount(colors), static_cast<int>(shape.elements) - std::popcount(covered)};
}

int checked = 0;
int wrong = 0;

void expect(const Value& found, const Value& best) {
  ++checked;
  wrong += found == best ? 0 : 1;
}

using Keys = std::set<std::pair<Word, Word>>;

template <class Table, class Rows>
Word cell(const Table& table, const Rows& rows, unsigned place, Word ports, Word joined) {
  return table.rules.at(table.first[k] + std::size_t{place} * table.cells[k] + rows[Word{1} << k | ports] + joined);
}

Word partner(Word pairing, unsigned port) { return pairing >> (4 * port) & 15U; }

/// The first alternative of a list that joins only ports joined according to the key: nothing else is known.
template <class Table>
Word first_of(const Table& table, unsigned place, Word ports, Word joined) {
  const std::size_t list = table.first[k] + (std::size_t{place} << k) + ports;
  for (std::size_t at = table.start[list]; at < table.start[list + 1]; ++at) {
    const Word pairing = tables::pairings[table.rules[at].pairing];
    bool sound = true;
    for (unsigned port = 0; port < k; ++port) {
      const auto other = static_cast<unsigned>(partner(pairing, port));
      if (other >= k || partner(pairing, other) != port) return ~Word{0};
      if (other == port) continue;
      // The predecessor of the port, or the port that it precedes.
      const auto precedes = [&](unsigned low, unsigned high) {
        if ((joined >> high & 1U) == 0) return false;
        unsigned i = high;
        do i = (i + k - 1) % k;
        while ((ports >> i & 1U) == 0);
        return i == low;
      };
      sound = sound && (precedes(other, port) || precedes(port, other));
    }
    if (sound) return table.rules[at].recoloring;
  }
  return ~Word{0};
}

void closed_families(Word loop, Word ports, Word joined) {
  const auto nothing_seen = [](std::size_t) { return restrip::out_of_sight; };
  for (unsigned a = 1; 2 * a <= k; ++a) {
    const Shape ring{k + 2, true, 0, a + 1};
    const Word inserted = Word{1} | Word{1} << (a + 1);
    const Value best = restrip::exact::best_split(k, a, ports, joined).value;
    expect(value_of(ring, cell(tables::split, tables::closed_rows, a - 1, ports, joined), ports, inserted), best);
    expect(value_of(ring, first_of(tables::linked_split, a - 1, ports, joined), ports, inserted), best);
    expect(value_of(ring, restrip::linked_split_rule({k, a}, loop, ports, nothing_seen).colors, ports, inserted), best);
  }
  const Shape fan{k, true, 0, 0};
  const Value best = restrip::exact::best_collapse(k, ports, joined).value;
  expect(value_of(fan, cell(tables::collapse, tables::closed_rows, 0, ports, joined), ports, 0), best);
  expect(value_of(fan, first_of(tables::linked_collapse, 0, ports, joined), ports, 0), best);
}

void open_families(Word ports, Word joined) {
  unsigned place = 0;
  for (unsigned i = 0; i < k; ++i)
    for (unsigned j = i + 1; j <= k && i + j <= k; ++j)
      expect(value_of({k + 2, false, i, j + 1}, cell(tables::open_split, tables::open_rows, place++, ports, joined),
                      ports, Word{1} << i | Word{1} << (j + 1)),
             restrip::exact::best_open_split(k, i, j, ports, joined).value);
  for (unsigned i = 0; 2 * i <= k; ++i)
    expect(value_of({k + 1, false, 0, 0}, cell(tables::boundary_split, tables::open_rows, i, ports, joined), ports,
                    Word{1} << i),
           restrip::exact::best_boundary_split(k, i, ports, joined).value);
  expect(value_of({k, false, 0, 0}, cell(tables::fan_collapse, tables::open_rows, 0, ports, joined), ports, 0),
         restrip::exact::best_fan_collapse(k, ports, joined).value);
}

}  // namespace

int main() {
  std::map<std::pair<Word, Word>, Word> closed_keys;  // each with a loop that has it
  Keys open_keys;
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
