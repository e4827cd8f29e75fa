#include "solve/port_pairs.hpp"

#include <algorithm>

namespace restrip::generator {

const std::array<PortPairs::Pair, PortPairs::most*(PortPairs::most - 1) / 2> PortPairs::pair_at = [] {
  std::array<Pair, most*(most - 1) / 2> pairs{};
  for (std::uint8_t low = 0; low < most; ++low)
    for (std::uint8_t high = low + 1; high < most; ++high) pairs[place_of(low, high)] = {low, high};
  return pairs;
}();

std::vector<Mask> PortPairs::masks() const {
  std::vector<Mask> pairs;
  visit([&](unsigned low, unsigned high) { pairs.push_back(Mask{1} << low | Mask{1} << high); });
  return pairs;
}

PortPairs PortPairs::moved(const std::vector<unsigned>& to) const {
  PortPairs image;
  visit([&](unsigned low, unsigned high) {
    const auto [a, b] = std::minmax(to[low], to[high]);
    image.add(a, b);
  });
  return image;
}

std::string PortPairs::text() const {
  std::array<unsigned, most*(most - 1) / 8> digits{};
  visit([&](unsigned low, unsigned high) {
    const unsigned place = written_place_of(low, high);
    digits[place / 4] |= 1U << place % 4;
  });
  std::string text;
  for (std::size_t i = digits.size(); i-- > 0;)
    if (!text.empty() || digits[i] != 0 || i == 0) text += "0123456789abcdef"[digits[i]];
  return text;
}

}  // namespace restrip::generator
