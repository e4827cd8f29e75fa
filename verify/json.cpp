#include "json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "input.hpp"

namespace restrip::verify {
namespace {

constexpr unsigned deepest = 8;  // an operation file has lists of edges in terms in criteria in the cost: six

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](std::uint32_t six) { text += static_cast<char>(0x80U + six % 64); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0U + code / 64);
    tail(code);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xe0U + code / 4096);
    tail(code / 64);
    tail(code);
  } else {
    text += static_cast<char>(0xf0U + code / 262144);
    tail(code / 4096);
    tail(code / 64);
    tail(code);
  }
}

/// How many bytes the UTF-8 character at the beginning has; 0 when there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : (first >= 0xe0 ? 3 : 2);
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  // Longer than need be, half of a surrogate pair, beyond the last character.
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) || (first == 0xf0 && byte(1) < 0x90) ||
      (first == 0xf4 && byte(1) > 0x8f))
    return 0;
  return length;
}

class JsonParser {
 public:
  JsonParser(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  Json whole() {
    Json value = this->value(0);
    skip_space();
    if (at_ != text_.size()) fail("the end of the file");
    return value;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  TextPlace place() const { return {line_, static_cast<unsigned>(at_ - line_start_) + 1}; }

  [[noreturn]] void fail(const std::string& expected) const {
    const char c = peek();
    const std::string found = at_ == text_.size()     ? "the end of the file"
                              : (c > ' ' && c <= '~') ? fmt::format("\"{}\"", c)
                                                      : fmt::format("byte {:#04x}", static_cast<unsigned char>(c));
    fail_at(file_, place(), fmt::format("expected {}, found {}", expected, found));
  }

  void skip_space() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      } else if (text_[at_] != ' ' && text_[at_] != '\t' && text_[at_] != '\r') {
        return;
      }
    }
  }

  bool taken(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  Json value(unsigned depth) {
    skip_space();
    if (depth > deepest) fail_at(file_, place(), "expected fewer lists and objects inside one another");
    Json value;
    value.place = place();
    const char c = peek();
    if (c == '{')
      object(value, depth);
    else if (c == '[')
      array(value, depth);
    else if (c == '"')
      value.kind = Json::Kind::string, value.text = string();
    else if (c == '-' || is_digit(c))
      number(value);
    else
      word(value);
    return value;
  }

  void object(Json& value, unsigned depth) {
    value.kind = Json::Kind::object;
    ++at_;
    if (taken('}')) return;
    do {
      skip_space();
      Json::Name name{{}, place()};
      if (peek() != '"') fail("the name of a member in quotes");
      name.text = string();
      for (const Json::Name& other : value.names)
        if (other.text == name.text)
          fail_at(file_, name.place,
                  fmt::format("expected each member once, \"{}\" is in line {} already", name.text, other.place.line));
      if (!taken(':')) fail("\":\"");
      value.names.push_back(std::move(name));
      value.items.push_back(this->value(depth + 1));
    } while (taken(','));
    if (!taken('}')) fail("\",\" or \"}\"");
  }

  void array(Json& value, unsigned depth) {
    value.kind = Json::Kind::array;
    ++at_;
    if (taken(']')) return;
    do value.items.push_back(this->value(depth + 1));
    while (taken(','));
    if (!taken(']')) fail("\",\" or \"]\"");
  }

  std::string string() {
    std::string text;
    for (++at_; peek() != '"' || at_ == text_.size();) {
      if (at_ == text_.size() || static_cast<unsigned char>(text_[at_]) < ' ') fail("the end of the string");
      if (text_[at_] == '\\') {
        ++at_;
        escape(text);
        continue;
      }
      const std::size_t length = utf8_length(text_.substr(at_));
      if (length == 0) fail("UTF-8");
      text += text_.substr(at_, length);
      at_ += length;
    }
    ++at_;
    return text;
  }

  void escape(std::string& text) {
    constexpr std::string_view names = "\"\\/bfnrt";
    constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
    const char c = peek();
    if (const std::size_t name = at_ == text_.size() ? std::string_view::npos : names.find(c);
        name != std::string_view::npos) {
      text += meanings[name];
      ++at_;
      return;
    }
    if (c != 'u') fail("one of \"\\/bfnrtu after a backslash");
    ++at_;
    std::uint32_t code = code_unit();
    if (code >= 0xd800 && code < 0xdc00 && text_.substr(at_, 2) == "\\u") {
      at_ += 2;
      const std::uint32_t low = code_unit();
      if (low < 0xdc00 || low > 0xdfff) fail("the second half of a surrogate pair before this");
      code = 0x10000 + (code - 0xd800) * 1024 + (low - 0xdc00);
    }
    if (code >= 0xd800 && code < 0xe000) fail("a whole surrogate pair before this");
    append_utf8(text, code);
  }

  std::uint32_t code_unit() {
    std::uint32_t code = 0;
    const std::string_view digits = text_.substr(at_, 4);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc() || end != digits.data() + 4) fail("four hexadecimal digits");
    at_ += 4;
    return code;
  }

  void digits() {
    if (!is_digit(peek())) fail("a digit");
    while (is_digit(peek())) ++at_;
  }

  void number(Json& value) {
    const std::size_t start = at_;
    if (peek() == '-') ++at_;
    if (peek() == '0')
      ++at_;
    else
      digits();
    value.kind = Json::Kind::integer;
    if (peek() == '.') {
      value.kind = Json::Kind::other_number;
      ++at_;
      digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      value.kind = Json::Kind::other_number;
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      digits();
    }
    value.text = text_.substr(start, at_ - start);
    const auto [end, error] = std::from_chars(value.text.data(), value.text.data() + value.text.size(), value.integer);
    if (value.kind == Json::Kind::integer && error != std::errc())
      fail_at(file_, value.place, fmt::format("expected an integer of 64 bits, found {}", value.text));
  }

  void word(Json& value) {
    for (const std::string_view word : {"null", "true", "false"})
      if (text_.substr(at_, word.size()) == word) {
        value.kind = word == "null" ? Json::Kind::null : Json::Kind::boolean;
        value.text = word;
        at_ += word.size();
        return;
      }
    fail("a value");
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  unsigned line_ = 1;
};

}  // namespace

std::string Json::described() const {
  switch (kind) {
    case Kind::array:
      return "a list";
    case Kind::object:
      return "an object";
    case Kind::string:
      return fmt::format("\"{}\"", text);
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::other_number:
      break;
  }
  return text;
}

Json parse_json(const std::string& file, std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf"))
    fail_at(file, {}, "expected no byte order mark before the file; save it as UTF-8 without one");
  return JsonParser(file, text).whole();
}

std::string shown(std::string_view text) {
  std::string shown;
  for (const char c : text)
    shown += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return shown;
}

void fail_at(const std::string& file, TextPlace place, const std::string& what) {
  throw InputError(fmt::format("{}:{}", file, place.line), place.column, shown(what));
}

}  // namespace restrip::verify
