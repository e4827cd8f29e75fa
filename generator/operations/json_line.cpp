#include "operations/json_line.hpp"

#include <algorithm>

namespace restrip::generator {
namespace {

/// Walks over valid JSON.
class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) { skip_space(); }

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  /// Over a bracket, comma or colon, and what space follows.
  void step() {
    ++at_;
    skip_space();
  }
  /// Over a string; its characters as written, escapes and all.
  std::string_view string() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2U : 1U;
    const std::string_view characters = text_.substr(begin, at_ - begin);
    step();
    return characters;
  }
  /// Over a whole value.
  void value() {
    if (here() == '"') {
      string();
      return;
    }
    int depth = 0;
    do {
      const char c = here();
      if (c == '"') {
        string();
        continue;
      }
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      step();
    } while (at_ < text_.size() && (depth > 0 || std::string_view(",}]").find(here()) == std::string_view::npos));
  }

 private:
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Goes to the value that the step leads to, if it is there.
bool enter(Walker& walker, const JsonStep& step) {
  const bool object = walker.here() == '{';
  if (!object && walker.here() != '[') return false;
  Walker inside = walker;
  inside.step();
  for (std::size_t i = 0; inside.here() != (object ? '}' : ']') && inside.here() != '\0'; ++i) {
    bool found = !object && i == step.element && step.member.empty();
    if (object) {
      found = inside.string() == step.member;
      inside.step();
    }
    if (found) {
      walker = inside;
      return true;
    }
    inside.value();
    if (inside.here() == ',') inside.step();
  }
  return false;
}

}  // namespace

std::size_t line_of(std::string_view text, const std::vector<JsonStep>& path) {
  Walker walker(text);
  for (const JsonStep& step : path)
    if (!enter(walker, step)) break;
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(walker.at()), '\n'));
}

}  // namespace restrip::generator
