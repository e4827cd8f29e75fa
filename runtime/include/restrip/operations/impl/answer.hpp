// The changes by a rule in a patch that has been read: colours, strips and isolated triangles. Fans of at most
// max_word_valence triangles are answered on words, longer ones on bit strings.
#pragma once

#include <cstddef>

#include "restrip/operations/impl/patch_walk.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::detail {

/// The colours of a rule and the changes that it makes.
template <class Bits>
struct Answer {
  Bits colors;
  int strips = 0;
  int isolated = 0;
};

inline Answer<WordBits> answer(const Layout& before, Word old_colors, const Layout& after, const Rule& rule,
                               Word ports) noexcept {
  return {{rule.colors}, rule.strips, isolated(after, rule.colors, ports) - isolated(before, old_colors, ports)};
}

/// The rule of rules.hpp for these layouts.
inline Rule rule_between(const Layout& before, Word colors, const Layout& after, Word ports) noexcept {
  const std::size_t k = after.k;
  if (after.ring)
    return after.has_chord() ? split_rule({k, after.opposite - 1}, colors, ports)
                             : collapse_rule({k, before.opposite - 1}, colors, ports);
  if (after.has_chord()) return open_split_rule({k, after.inserted, after.opposite - 1}, colors, ports);
  if (before.has_chord()) return open_collapse_rule({k, before.inserted, before.opposite - 1}, colors, ports);
  return after.inserted != nowhere ? boundary_split_rule({k, after.inserted}, colors, ports)
                                   : boundary_collapse_rule({k, before.inserted}, colors, ports);
}

inline Answer<WordBits> answer_by_rule(const PatchColors<WordBits>& patch) noexcept {
  const auto& [before, after, gap, inner, ports] = patch;
  return answer(before, inner.word, after, rule_between(before, inner.word, after, ports.word), ports.word);
}

inline int count(const LongBits& bits) noexcept {
  int n = 0;
  for (const Word word : bits.words) n += count_bits(word);
  return n;
}

/// The same on bit strings. For colours that no valid stripification has, all edges are dashed, as in Rule.
inline Answer<LongBits> answer_by_rule(PatchColors<LongBits>& patch) {
  const Layout before = patch.before;
  const Layout after = patch.after;
  const BitSpan inner = patch.inner.span(before.colors());
  const BitSpan ports = patch.ports.span(before.k);
  Answer<LongBits> result;
  const Walker walker{before, inner, ports};
  if (walker.valid()) {
    LongBits joined;
    walker.joined(joined.span(before.k));
    best_recoloring(after, ports, joined.span(before.k), result.colors.span(after.colors()));
  }
  const int nodes = static_cast<int>(after.size()) - static_cast<int>(before.size());
  result.strips = nodes - (count(result.colors) - count(patch.inner));
  result.isolated = isolated(after, result.colors.span(after.colors()), ports) - isolated(before, inner, ports);
  return result;
}

}  // namespace restrip::detail
