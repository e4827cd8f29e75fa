// The numbers of the automaton of all valences, and a digest of the results of its look-up
// (docs/reference/verifiers.md, "Dump of the automaton").
#include <cstdint>
#include <initializer_list>
#include <string>

#include "dump_output.hpp"
#include "restrip/rules/exact.hpp"

namespace restrip::dump {

namespace {

template <class Numbers>
void array(Output& out, const char* name, const Numbers& numbers) {
  out.line(std::string("array ") + name + ' ' + std::to_string(numbers.size()));
  for (const auto number : numbers) {
    out.hex(number, '\n');
    out.entry_done();
  }
}

struct Key {
  Word ports = 0;
  Word joined = 0;
};

/// The key with number n of the keys of a fan: a digit to the base 3 for each port, port 0 first; 0 dashed, 1 solid, 2
/// solid and joined.
Key written_key(std::size_t k, std::uint64_t n) {
  Key key;
  for (std::size_t i = k; i-- > 0; n /= 3) {
    const std::uint64_t letter = n % 3;
    if (letter == 0) continue;
    key.ports |= bit(i);
    if (letter == 2) key.joined |= bit(i);
  }
  return key;
}

/// Calls visit(operation, p, q, best) for every position of fans of k triangles: best(ports, joined) is the answer
/// there.
template <class Visit>
void for_each_position_of(std::size_t k, Visit&& visit) {
  constexpr std::size_t nowhere = 0;
  for (std::size_t a = 1; a < k && k >= 3; ++a)
    visit(0U, a, nowhere, [=](Word ports, Word joined) { return exact::best(ring_with_chord(k, a), ports, joined); });
  if (k >= 3)
    visit(1U, nowhere, nowhere, [=](Word ports, Word joined) { return exact::best(closed_fan(k), ports, joined); });
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = i + 1; j <= k; ++j)
      visit(2U, i, j, [=](Word ports, Word joined) { return exact::best(path_with_chord(k, i, j), ports, joined); });
  visit(3U, nowhere, nowhere, [=](Word ports, Word joined) { return exact::best(open_fan(k), ports, joined); });
  for (std::size_t i = 0; i <= k; ++i)
    visit(4U, i, nowhere, [=](Word ports, Word joined) { return exact::best(path(k, i), ports, joined); });
}

}  // namespace

bool automaton_digests(std::size_t max_k) {
  for (std::size_t k = 1; k <= max_k; ++k) {
    // A digest is made of all keys, a letter for each port, the last one the lowest digit; or, if there are more than
    // 7,000, of 64 drawn at random.
    std::uint32_t keys = 1;
    for (std::size_t i = 0; i < k && keys <= 7000; ++i) keys *= 3;
    const bool draws = keys > 7000;
    if (draws) keys = 64;
    const auto drawn = [&](std::uint32_t n, Word i) {
      return (mix(n, i, 0) | Word{mix(n, i + 8, 0)} << 32) & (bit(k) - 1);
    };
    const auto folded = [](Word mask) {
      return static_cast<std::uint32_t>(mask) ^ static_cast<std::uint32_t>(mask >> 32) * 0x9e3779b1U;
    };
    for_each_position_of(k, [&](unsigned operation, std::size_t p, std::size_t q, auto&& best) {
      std::uint32_t digest = 0;
      for (std::uint32_t n = 0; n < keys; ++n) {
        const auto [ports, joined] = draws ? Key{drawn(n, 0), drawn(n, 1)} : written_key(k, n);
        digest += mix(n, folded(ports), 0x80000000U | folded(best(ports, joined).colors));
      }
      std::printf("%u %zu %zu %zu %08x\n", operation, k, p, q, digest);
    });
  }
  std::printf("rules outside the tables: 0\n");
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

void automaton(Output& out, std::size_t max_k) {
  constexpr const auto& numbers = tables::automaton;
  array(out, "next", numbers.next);
  array(out, "before", numbers.before);
  array(out, "closed", numbers.closed);
  array(out, "first", numbers.first);
  array(out, "second", numbers.second);
  array(out, "meet", numbers.meet);
  array(out, "meetings", numbers.meetings);
  array(out, "seconds", std::initializer_list<std::size_t>{numbers.seconds});
  constexpr const char* families[] = {"split", "collapse", "open-split", "fan-collapse", "boundary-split"};
  constexpr std::size_t numbers_of_place[] = {1, 0, 2, 0, 1};
  for (const unsigned wanted : {0U, 1U, 2U, 4U, 3U}) {
    std::uint64_t keys = 1;
    for (std::size_t k = 1; k <= max_k; ++k) {
      keys *= 3;
      for_each_position_of(k, [&](unsigned operation, std::size_t p, std::size_t q, auto&& best) {
        if (operation != wanted) return;
        std::uint64_t digest = 0;
        std::uint64_t told = 0;
        for (std::uint64_t n = 0; n < keys; ++n) {
          const Key key = written_key(k, n);
          const exact::Recoloring found = best(key.ports, key.joined);
          digest = digest * 1000003 + found.colors;
          told = told * 1000003 + static_cast<std::uint64_t>(64 * found.value.solid + found.value.isolated);
        }
        out.text(std::string("answers ") + families[operation] + ' ' + std::to_string(k));
        if (numbers_of_place[operation] > 0) out.text(' ' + std::to_string(p));
        if (numbers_of_place[operation] > 1) out.text(' ' + std::to_string(q));
        out.text(" keys " + std::to_string(keys) + " digest ");
        out.hex(digest, ' ');
        out.text("told ");
        out.hex(told, '\n');
        out.entry_done();
      });
    }
  }
}

}  // namespace restrip::dump
