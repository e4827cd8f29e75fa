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

// ---- fans of any size: the same on bit strings

inline int count(const LongBits& bits) noexcept {
  int n = 0;
  for (const Word word : bits.words) n += count_bits(word);
  return n;
}

// For colours that no valid stripification has, all edges are dashed, as in Rule.
template <class Best>
Answer<LongBits> long_answer(const Layout& before, LongBits& old_colors, const Layout& after, LongBits& ports,
                             Best&& best) {
  Answer<LongBits> result;
  const Walker walker{before, old_colors.span(before.colors()), ports.span(before.k)};
  if (walker.valid()) {
    LongBits joined;
    walker.joined(joined.span(before.k));
    best(ports.span(before.k), joined.span(before.k), result.colors.span(after.colors()));
  }
  const int nodes = static_cast<int>(after.size()) - static_cast<int>(before.size());
  result.strips = nodes - (count(result.colors) - count(old_colors));
  const BitSpan all_ports = ports.span(before.k);
  result.isolated = isolated(after, result.colors.span(after.colors()), all_ports) -
                    isolated(before, old_colors.span(before.colors()), all_ports);
  return result;
}

inline Answer<WordBits> answer_split(const Fan<WordBits>& fan, bool both) noexcept {
  const std::size_t low = fan.left < fan.right ? fan.left : fan.right;
  const std::size_t high = fan.left < fan.right ? fan.right : fan.left;
  const Word ports = fan.ports.word;
  if (fan.closed)
    return answer(closed_fan(fan.k), fan.loop.word, ring_with_chord(fan.k, fan.right),
                  split_rule({fan.k, fan.right}, fan.loop.word, ports), ports);
  if (both)
    return answer(open_fan(fan.k), fan.loop.word, path_with_chord(fan.k, low, high),
                  open_split_rule({fan.k, low, high}, fan.loop.word, ports), ports);
  return answer(open_fan(fan.k), fan.loop.word, path(fan.k, low),
                boundary_split_rule({fan.k, low}, fan.loop.word, ports), ports);
}

inline Answer<LongBits> answer_split(Fan<LongBits>& fan, bool both) {
  const std::size_t k = fan.k;
  const std::size_t low = fan.left < fan.right ? fan.left : fan.right;
  const std::size_t high = fan.left < fan.right ? fan.right : fan.left;
  if (fan.closed)
    return long_answer(closed_fan(k), fan.loop, ring_with_chord(k, fan.right), fan.ports,
                       [&](BitSpan p, BitSpan j, MutableBitSpan out) { exact::best_split(k, fan.right, p, j, out); });
  if (both)
    return long_answer(
        open_fan(k), fan.loop, path_with_chord(k, low, high), fan.ports,
        [&](BitSpan p, BitSpan j, MutableBitSpan out) { exact::best_open_split(k, low, high, p, j, out); });
  return long_answer(open_fan(k), fan.loop, path(k, low), fan.ports,
                     [&](BitSpan p, BitSpan j, MutableBitSpan out) { exact::best_boundary_split(k, low, p, j, out); });
}

inline Answer<WordBits> answer_collapse(const PatchPlace& at, WordBits& inner, WordBits& ports) noexcept {
  const std::size_t k = at.k;
  switch (at.kind) {
    case PatchPlace::Kind::ring:
      return answer(ring_with_chord(k, at.a), inner.word, closed_fan(k),
                    collapse_rule({k, at.a}, inner.word, ports.word), ports.word);
    case PatchPlace::Kind::path_with_chord:
      return answer(path_with_chord(k, at.i, at.j), inner.word, open_fan(k),
                    open_collapse_rule({k, at.i, at.j}, inner.word, ports.word), ports.word);
    case PatchPlace::Kind::path:
      break;
  }
  return answer(path(k, at.i), inner.word, open_fan(k), boundary_collapse_rule({k, at.i}, inner.word, ports.word),
                ports.word);
}

inline Answer<LongBits> answer_collapse(const PatchPlace& at, LongBits& inner, LongBits& ports) {
  const std::size_t k = at.k;
  const auto onto_open = [k](BitSpan p, BitSpan j, MutableBitSpan out) { exact::best_fan_collapse(k, p, j, out); };
  switch (at.kind) {
    case PatchPlace::Kind::ring:
      return long_answer(ring_with_chord(k, at.a), inner, closed_fan(k), ports,
                         [k](BitSpan p, BitSpan j, MutableBitSpan out) { exact::best_collapse(k, p, j, out); });
    case PatchPlace::Kind::path_with_chord:
      return long_answer(path_with_chord(k, at.i, at.j), inner, open_fan(k), ports, onto_open);
    case PatchPlace::Kind::path:
      break;
  }
  return long_answer(path(k, at.i), inner, open_fan(k), ports, onto_open);
}

}  // namespace restrip::detail
