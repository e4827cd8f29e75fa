// The numbers of the automaton of all valences, and a digest of what its look-up answers (docs/certificate.md, "Dump of
// the automaton").
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

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

/// The key with number n of the 3^k keys of a fan: one digit to the base 3 for each port, port 0 first; 0 dashed, 1
/// solid, 2 solid and joined.
struct KeyMasks {
  Word ports = 0;
  Word joined = 0;

  KeyMasks(std::size_t k, std::uint64_t n) {
    for (std::size_t i = k; i-- > 0; n /= 3) {
      if (n % 3 != 0) ports |= bit(i);
      if (n % 3 == 2) joined |= bit(i);
    }
  }
};

template <class Best>
void answers(Output& out, const std::string& family, std::initializer_list<std::size_t> position, Best&& best) {
  const std::size_t k = *position.begin();
  std::uint64_t keys = 1;
  for (std::size_t i = 0; i < k; ++i) keys *= 3;
  std::uint64_t digest = 0;
  std::uint64_t told = 0;
  for (std::uint64_t n = 0; n < keys; ++n) {
    const KeyMasks key(k, n);
    const exact::Recoloring found = best(key.ports, key.joined);
    digest = digest * 1000003 + found.colors;
    told = told * 1000003 + static_cast<std::uint64_t>(64 * found.value.solid + found.value.isolated);
  }
  std::string words = "answers " + family;
  for (const std::size_t number : position) words += ' ' + std::to_string(number);
  words += " keys " + std::to_string(keys) + " digest ";
  for (const char c : words) out.text(c);
  out.hex(digest, ' ');
  for (const char c : std::string_view("told ")) out.text(c);
  out.hex(told, '\n');
  out.entry_done();
}

}  // namespace

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
  for (std::size_t k = 3; k <= max_k; ++k)
    for (std::size_t a = 1; a < k; ++a)
      answers(out, "split", {k, a}, [&](Word ports, Word joined) { return exact::best_split(k, a, ports, joined); });
  for (std::size_t k = 3; k <= max_k; ++k)
    answers(out, "collapse", {k}, [&](Word ports, Word joined) { return exact::best_collapse(k, ports, joined); });
  for (std::size_t k = 1; k <= max_k; ++k)
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = i + 1; j <= k; ++j)
        answers(out, "open-split", {k, i, j},
                [&](Word ports, Word joined) { return exact::best_open_split(k, i, j, ports, joined); });
  for (std::size_t k = 1; k <= max_k; ++k)
    for (std::size_t i = 0; i <= k; ++i)
      answers(out, "boundary-split", {k, i},
              [&](Word ports, Word joined) { return exact::best_boundary_split(k, i, ports, joined); });
  for (std::size_t k = 1; k <= max_k; ++k)
    answers(out, "fan-collapse", {k},
            [&](Word ports, Word joined) { return exact::best_fan_collapse(k, ports, joined); });
}

}  // namespace restrip::dump
