#include "common/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace restrip::files {
namespace {

/// The bytes of the character that the text begins with; 0 when it is not UTF-8, or a control character.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return text[0] == '\n' || (byte(0) >= 0x20 && byte(0) != 0x7F) ? 1 : 0;
  const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const bool is_control = byte(0) == 0xC2 && byte(1) < 0xA0;
  return is_control ? 0 : size;
}

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

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = character_bytes(text);
    if (size == 0)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else
      shown += text.substr(0, size);
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return shown;
}

std::string printable_message(std::string_view text) {
  // The file is at the beginning, the remedy at the end.
  constexpr std::size_t tail = longest_message / 4;
  if (text.size() <= longest_message) return printable(text);
  return printable(text.substr(0, longest_message - tail)) + " [...] " + printable(text.substr(text.size() - tail));
}

std::string printable_ascii(std::string_view text) {
  constexpr std::size_t longest = 400;
  std::string shown;
  for (const char c : text.substr(0, longest))
    shown += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  if (text.size() > longest) shown += "...";
  return shown;
}

std::string unfit_for_comment(std::string_view text) {
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

}  // namespace restrip::files
