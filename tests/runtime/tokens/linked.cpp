// The reader of the linked tables, and what it asks of the strips outside: every key of small closed fans beside
// several outsides, some of larger and of open fans, which are searched for. How often it looks outward is an answer,
// too.
#include "restrip/operations/linked.hpp"

#include <bit>

#include "judge.hpp"

namespace {

using namespace restrip;
using judge::Digest;
using judge::numbers;
using judge::some_bits;

/// Compilers find a read outside the pairs.
static_assert(detail::pairs_of<detail::WordPairs>(3, 0, 0) == detail::WordPairs{});

/// Where the strips behind the solid ports go: some end, some come back, some are followed in vain.
class Outside {
 public:
  explicit Outside(Word ports) {
    const auto kind = numbers() % 4;
    for (Word rest = ports; rest != 0;) {
      const int i = std::countr_zero(rest);
      rest &= rest - 1;
      ends_[i] = kind == 0 || numbers() % 3 == 0 ? out_of_sight : strip_ends;
      if (kind == 1 || rest == 0 || numbers() % 3 == 0) continue;
      Word others = rest;
      for (auto skipped = numbers() % static_cast<unsigned>(std::popcount(rest)); skipped > 0; --skipped)
        others &= others - 1;
      const int j = std::countr_zero(others);
      ends_[i] = j;
      ends_[j] = i;
      rest &= ~(Word{1} << j);
    }
  }
  int operator()(std::size_t port) {
    ++asked_;
    return ends_[port];
  }
  [[nodiscard]] int asked() const { return asked_; }

 private:
  int ends_[64] = {};
  int asked_ = 0;
};

void tell(Digest& told, const Rule& rule, const Outside& outside) {
  told.add(rule.colors, rule.strips, rule.valid, outside.asked());
}

void asked(Digest& told, std::size_t k, Word colors, Word ports) {
  for (std::size_t a = 1; a < k; ++a) {
    Outside outside(ports);
    tell(told, linked_split_rule({k, a}, colors, ports, outside), outside);
    Outside other(ports);
    tell(told, linked_collapse_rule({k, a}, colors, ports, other), other);
  }
}

void closed_fans() {
  for (std::size_t k = 3; k <= 4; ++k) {
    Digest told("linked", k);
    for (Word colors = 0; colors < bit(k + 3); ++colors)
      for (Word ports = 0; ports < bit(k + 1); ++ports)
        for (int n = 0; n < 4; ++n) asked(told, k, colors, ports);
  }
  for (const std::size_t k : judge::Sizes{5, 6, 7, 8, 9, 12, 61}) {
    Digest told("linked", k);
    for (int n = 0; n < (k < 9 ? 1000 : k < 20 ? 100 : 3); ++n)
      asked(told, k, some_bits(k) & some_bits(k) & (k > 20 ? some_bits(k) : low_bits(k)), some_bits(k));
  }
}

void open_fans() {
  for (const std::size_t k : judge::Sizes{1, 2, 4, 8, 10}) {
    Digest told("searched", k);
    const auto fan = detail::open_fan(k);
    for (int n = 0; n < 60; ++n) {
      const Word ports = some_bits(k);
      judge::each_position(
          k, [](std::size_t) {},
          [&](std::size_t i, std::size_t j) {
            const Word colors = some_bits(k + 2) & some_bits(k + 2);
            const auto patch = detail::path_with_chord(k, i, j);
            Outside outside(ports);
            tell(told, detail::searched_rule(fan, colors & low_bits(k - 1), patch, ports, outside), outside);
            Outside other(ports);
            tell(told, detail::searched_rule(patch, colors, fan, ports, other), other);
          },
          [&](std::size_t i) {
            Outside outside(ports);
            tell(told, detail::searched_rule(detail::path(k, i), some_bits(k), fan, ports, outside), outside);
          });
    }
  }
}

template <class Pairs>
void pairs(Digest& told) {
  for (std::size_t i = 0; i < Pairs::max_ports; ++i)
    for (std::size_t j = 0; j < Pairs::max_ports; ++j) {
      Pairs two;
      if (i != j) two.join(i, j);
      told.add(two.partner(i), two.partner(j), two.partner(0), two == Pairs{});
    }
  told.add(Pairs::max_ports);
}

void every_pair() {
  Digest told("pairs");
  pairs<detail::TablePairs>(told);
  pairs<detail::WordPairs>(told);
  told.add(default_reach, strip_ends, out_of_sight, LinkedRule{}.recoloring, LinkedRule{}.pairing);
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {every_pair, closed_fans, open_fans}); }
