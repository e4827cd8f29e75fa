#include "model/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/families_text.hpp"

namespace restrip::verify {
namespace {

/// The character at the beginning of valid UTF-8, and its number of bytes.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
};

Character character_at(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return {lead, 1};
  Character character{lead >= 0xf0 ? lead % 8U : (lead >= 0xe0 ? lead % 16U : lead % 32U),
                      lead >= 0xf0 ? 4U : (lead >= 0xe0 ? 3U : 2U)};
  for (const char next : text.substr(at + 1, character.bytes - 1))
    character.code = character.code * 64 + static_cast<unsigned char>(next) % 64U;
  return character;
}

/// Visible, and written in logical order.
bool is_plain(char32_t code) {
  if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return false;          // controls
  if (code == 0xad || code == 0x61c || code == 0x180e) return false;       // soft hyphen, marks of two scripts
  if (code >= 0x2000 && code < 0x2070)                                     // punctuation, except characters
    return !(code >= 0x200b && code <= 0x200f) &&                          // without width or direction,
           !(code >= 0x2028 && code <= 0x202e) && code < 0x2060;           // line separators, and controls of direction
  if (code >= 0xfdd0 && code <= 0xfdef) return false;                      // noncharacters
  if (code == 0xfeff || (code >= 0xfff0 && code <= 0xfffb)) return false;  // byte order mark, annotations
  return code < 0xe0000 && (code & 0xffffU) < 0xfffe;                      // tags, private use, noncharacters
}

/// Sequences that end or begin a comment, extend it to the next line, or may be interpreted so.
constexpr std::string_view joints[] = {"\\", "*/", "/*", "??"};

}  // namespace

std::optional<std::string> no_comment(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    for (const std::string_view joint : joints)
      if (text.substr(at).starts_with(joint)) return fmt::format("\"{}\"", joint);
    const Character character = character_at(text, at);
    if (!is_plain(character.code))
      return fmt::format("the character U+{:04X}", static_cast<std::uint32_t>(character.code));
    at += character.bytes;
  }
  return {};
}

bool is_words(std::string_view text) {
  for (const char c : text)
    if (c < ' ' || c > '~') return false;
  return !text.empty() && text.front() != ' ' && text.back() != ' ' && text.find("  ") == std::string_view::npos;
}

std::optional<std::string> owner_of_name(std::string_view name) {
  static const std::map<std::string, std::string> owners = [] {
    std::map<std::string, std::string> by_name;
    for (const JsonValue& owner : parse_json("docs/taken-names.json", taken_names_text)["taken"].elements("owners"))
      for (const JsonValue& word : owner["names"].elements("names", 1, 1000)) by_name[word.text()] = owner["by"].text();
    return by_name;
  }();
  std::string in_code(name);
  std::replace(in_code.begin(), in_code.end(), '-', '_');
  const auto found = owners.find(in_code);
  return found == owners.end() ? std::nullopt : std::optional(found->second);
}

bool is_other_operation(std::string_view name, const JsonValue& description) {
  static const std::vector<JsonValue> shipped = parse_json("tables/operations", operations_text).elements("operations");
  return std::any_of(shipped.begin(), shipped.end(),
                     [&](const JsonValue& one) { return one["name"].text() == name && one != description; });
}

}  // namespace restrip::verify
