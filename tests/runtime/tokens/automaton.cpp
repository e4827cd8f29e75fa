// The automaton's reader: every key and position of small fans, some of large ones; on words and on bit strings. The
// automaton in which swaps have a price is asked where one is first on the include path.
#include <type_traits>

#include "guarded_new.hpp"
#include "judge.hpp"
#include "restrip/rules/exact.hpp"

namespace {

using namespace restrip;
using judge::Digest;
using judge::some_bits;

constexpr bool with_turns = std::remove_cvref_t<decltype(tables::automaton)>::letters == 8;

void tell(Digest& told, const exact::Value& value) { told.add(value.solid, value.isolated); }
void tell(Digest& told, const exact::Recoloring& found) {
  told.add(found.colors);
  tell(told, found.value);
}

/// The same on words and on bit strings.
void asked(Digest& told, std::size_t k, Word ports, Word joined, exact::Turns turns) {
  const BitSpan p = BitSpan::of(ports);
  const BitSpan j = BitSpan::of(joined);
  const exact::LongTurns long_turns{BitSpan::of(turns.left), BitSpan::of(turns.right)};
  Word colors = ~Word{0};
  const MutableBitSpan to = MutableBitSpan::of(colors);
  const auto both = [&](const exact::Recoloring& found, const exact::Value& value) {
    tell(told, found);
    tell(told, value);
    told.add(colors);
  };
  both(exact::best_collapse(k, ports, joined, turns), exact::best_collapse(k, p, j, to, long_turns));
  both(exact::best_fan_collapse(k, ports, joined, turns), exact::best_fan_collapse(k, p, j, to, long_turns));
  for (std::size_t a = 1; a < k; ++a)
    both(exact::best_split(k, a, ports, joined, turns), exact::best_split(k, a, p, j, to, long_turns));
  judge::each_position(
      k, [](std::size_t) {},
      [&](std::size_t from, std::size_t goal) {
        both(exact::best_open_split(k, from, goal, ports, joined, turns),
             exact::best_open_split(k, from, goal, p, j, to, long_turns));
      },
      [&](std::size_t i) {
        both(exact::best_boundary_split(k, i, ports, joined, turns),
             exact::best_boundary_split(k, i, p, j, to, long_turns));
      });
}

exact::Turns some_turns(std::size_t k) {
  const Word left = with_turns ? some_bits(k) : 0;
  return {left, with_turns ? some_bits(k) & ~left : 0};
}

void words() {
  for (std::size_t k = 1; k <= 4; ++k) {
    Digest told("automaton", k);
    for (Word ports = 0; ports < bit(k); ++ports)
      for (Word joined = 0; joined < bit(k); ++joined) asked(told, k, ports, joined, some_turns(k));
  }
  for (const std::size_t k : judge::Sizes{5, 8, 17, 61}) {
    Digest told("automaton", k);
    for (int n = 0; n < (k < 10 ? 300 : k < 20 ? 30 : 4); ++n)
      asked(told, k, some_bits(k), n % 2 == 0 ? some_bits(k) : low_bits(k), some_turns(k));
  }
}

void strings() {
  for (const std::size_t k : judge::Sizes{2, 3, 61, 62, 63, 64, 65, 66, 126, 128, 129, 130}) {
    Digest told("strings", k);
    for (int n = 0; n < 20; ++n) {
      const judge::SomeBits ports(k);
      const judge::SomeBits joined(k);
      const judge::SomeBits left(k);
      const judge::SomeBits right(k);
      const BitSpan p = ports.read();
      const BitSpan j = joined.read();
      const exact::LongTurns turns = n % 2 == 0 ? exact::LongTurns{} : exact::LongTurns{left.read(), right.read()};
      const auto answer = [&](std::size_t edges, auto&& best) {
        const judge::Bits colors(edges, ~Word{0});
        const std::size_t before = judge::allocated;
        tell(told, best(colors.write()));
        told.add(judge::allocated - before);
        colors.tell(told);
      };
      answer(k + 3, [&](MutableBitSpan to) { return exact::best_split(k, k / 2, p, j, to, turns); });
      answer(k + 3, [&](MutableBitSpan to) { return exact::best_split(k, k - 1, p, j, to, turns); });
      answer(k, [&](MutableBitSpan to) { return exact::best_collapse(k, p, j, to, turns); });
      answer(k + 2, [&](MutableBitSpan to) { return exact::best_open_split(k, k / 3, k - 1, p, j, to, turns); });
      answer(k, [&](MutableBitSpan to) { return exact::best_boundary_split(k, k / 4, p, j, to, turns); });
      answer(k - 1, [&](MutableBitSpan to) { return exact::best_fan_collapse(k, p, j, to, turns); });
    }
  }
}

/// Compilers find reads and writes outside the room of the largest fans.
constexpr Word widest = exact::best_split(61, 30, 0, 0).colors ^ exact::best_open_split(61, 10, 30, 0, 0).colors ^
                        exact::best_boundary_split(61, 30, 0, 0).colors;

/// What members hold of which nothing is said.
void defaults() {
  Digest told("defaults");
  tell(told, exact::Recoloring{});
  const detail::WordLetters word;
  const detail::LongLetters bits;
  told.add(word.ports, word.joined, word.turns.left, word.turns.right, bits.pair, bits.first);
  told.add(bits.ports.words == nullptr, bits.turns.left.words == nullptr);
  using Automaton = std::remove_cvref_t<decltype(tables::automaton)>;
  told.add(Automaton::letters, Automaton::classes, Automaton::seconds, Automaton::tells_turns, Automaton::boundary,
           Automaton::solid, Automaton::no_class);
  told.add(exact::detail::max_stack_valence, widest);
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {defaults, words, strings}); }
