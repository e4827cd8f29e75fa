#include "operations/emitted_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "common/json.hpp"
#include "operations/families_text.hpp"

namespace restrip::generator {
namespace {

/// Controls, line and paragraph separators, invisible characters and direction marks.
constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 12> hidden{{{0x00, 0x1f},
                                                                          {0x7f, 0x9f},
                                                                          {0xad, 0xad},
                                                                          {0x61c, 0x61c},
                                                                          {0x180e, 0x180e},
                                                                          {0x200b, 0x200f},
                                                                          {0x2028, 0x202e},
                                                                          {0x2060, 0x206f},
                                                                          {0xfdd0, 0xfdef},
                                                                          {0xfeff, 0xfeff},
                                                                          {0xfff0, 0xfffb},
                                                                          {0xe0000, 0x10ffff}}};

}  // namespace

std::string unprintable(std::string_view text) {
  // Trigraphs have two question marks, and a comment line that ends with a backslash continues in the next line.
  for (const std::string_view mark : {"\\", "*/", "/*", "??"})
    if (text.find(mark) != std::string_view::npos) return fmt::format("'{}'", mark);
  // Valid UTF-8, one code point after another.
  while (!text.empty()) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    std::uint32_t code = length == 1 ? first : first & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(i) & 0x3fU);
    text.remove_prefix(length);
    const bool is_hidden = std::any_of(hidden.begin(), hidden.end(),
                                       [&](const auto& some) { return some.first <= code && code <= some.second; });
    if (is_hidden || (code & 0xfffeU) == 0xfffeU) return fmt::format("U+{:04X}", code);
  }
  return {};
}

std::string name_is(std::string name) {
  static const auto taken = [] {
    std::map<std::string, std::string> by_name;
    for (const JsonValue& owner : parse_json("docs/taken-names.json", taken_names_text)["taken"].elements("owners"))
      for (const JsonValue& word : owner["names"].elements("names", 1, 1000)) by_name[word.text()] = owner["by"].text();
    return by_name;
  }();
  std::replace(name.begin(), name.end(), '-', '_');
  const auto found = taken.find(name);
  return found == taken.end() ? std::string() : found->second;
}

}  // namespace restrip::generator
