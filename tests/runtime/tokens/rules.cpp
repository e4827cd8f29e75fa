// Every function of rules.hpp: small fans whole, with bits too many; large ones, which the automaton answers.
#include "restrip/rules/rules.hpp"

#include "judge.hpp"

namespace {

using namespace restrip;
using judge::Digest;
using judge::some_bits;

void tell(Digest& told, const Rule& rule) { told.add(rule.colors, rule.strips, rule.valid); }

void asked(Digest& told, std::size_t k, Word colors, Word ports) {
  judge::each_position(
      k,
      [&](std::size_t a) {
        tell(told, split_rule({k, a}, colors, ports));
        tell(told, collapse_rule({k, a}, colors, ports));
      },
      [&](std::size_t i, std::size_t j) {
        tell(told, open_split_rule({k, i, j}, colors, ports));
        tell(told, open_collapse_rule({k, i, j}, colors, ports));
      },
      [&](std::size_t i) {
        tell(told, boundary_split_rule({k, i}, colors, ports));
        tell(told, boundary_collapse_rule({k, i}, colors, ports));
      });
}

void small() {
  for (std::size_t k = 1; k <= 4; ++k) {
    Digest told("rules", k);
    for (Word colors = 0; colors < bit(k + 4); ++colors)
      for (Word ports = 0; ports < bit(k + 1); ++ports) asked(told, k, colors, ports);
  }
}

/// Sparse colours are valid often enough in large fans.
void large() {
  for (const std::size_t k : judge::Sizes{5, 6, 7, 8, 9, 13, 31, 32, 33, 60, 61}) {
    Digest told("rules", k);
    for (int n = 0; n < (k < 10 ? 2000 : 30); ++n)
      if (k < 14)
        asked(told, k, some_bits(k + 3) & some_bits(k + 3), some_bits(k));
      else
        asked(told, k, some_bits(k + 3) & some_bits(k + 3) & some_bits(k + 3), some_bits(k) & some_bits(k));
  }
}

void flips() {
  Digest told("flips");
  for (const bool inner : {false, true})
    for (unsigned ports = 0; ports < 32; ++ports) {
      const FlipRule rule = flip_rule(inner, ports);
      told.add(rule.inner, rule.ports, rule.strips, rule.valid);
    }
}

void turns() {
  Digest told("turns");
  for (std::size_t n = 0; n <= 64; ++n) {
    const Word mask = some_bits(n);
    told.add(detail::reversed(mask, n));
    for (std::size_t by = 0; by < n && n < 64; ++by) told.add(detail::turned_down(mask, by, n));
  }
}

/// What members hold of which nothing is said.
void defaults() {
  Digest told("defaults");
  tell(told, {});
  const FlipRule flip;
  const SplitPosition split;
  const GapPair gaps;
  const Gap gap;
  told.add(flip.inner, flip.ports, flip.strips, flip.valid, split.k, split.a, gaps.k, gaps.i, gaps.j, gap.k, gap.i);
  told.add(table_max_k, max_word_valence);
  // Tables of k > 8 have larger numbers.
  told.add(sizeof(tables::closed_rows), sizeof(tables::split), sizeof(tables::flip), sizeof(TableIndex<9>),
           sizeof(RowStarts<9>), sizeof(Pairings<1>), sizeof(Pairings<1, 9>), sizeof(RuleTable<Word, 9, 1>),
           sizeof(LinkedTable<8, 1, 1>), sizeof(LinkedTable<9, 1, 1>));
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {defaults, turns, flips, small, large}); }
