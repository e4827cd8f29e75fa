#include "automaton/automaton_digests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "automaton/answers.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<std::string_view, 5> operations = {"split", "collapse", "open-split", "fan-collapse",
                                                        "boundary-split"};
constexpr std::uint32_t most_keys = 7000;
constexpr std::uint32_t drawn_keys = 64;

FanKey drawn_key(unsigned k, std::uint32_t n) {
  const auto drawn = [&](Mask place) { return low_part(mixed_number(n, place, 0), k); };
  return {drawn(0), drawn(1)};
}

}  // namespace

Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k) {
  const AutomatonReader reader(certificate);
  Digests digests;
  std::uint32_t keys = 1;
  for (unsigned k = 1; k <= max_k; ++k) {
    if (keys <= most_keys) keys *= 3;
    for (const FanPlace& place : all_places(k)) {
      const auto operation = std::find(operations.begin(), operations.end(), place.family) - operations.begin();
      std::uint32_t& digest = digests[fmt::format("{} {} {} {}", operation, k, place.a, place.b)];
      for (std::uint32_t n = 0; n < (keys <= most_keys ? keys : drawn_keys); ++n) {
        const FanKey key = keys <= most_keys ? written_key(k, n) : drawn_key(k, n);
        digest += mixed_number(n, key.ports, 0x80000000U | reader.answer(place, seen_key(key, place)).inner);
      }
    }
  }
  return digests;
}

}  // namespace restrip::verify
