#include "languages/templates.hpp"

namespace restrip::generator {

std::string filled(std::string_view text, const Filling& filling) {
  constexpr std::string_view name_characters = "abcdefghijklmnopqrstuvwxyz_";
  std::string made;
  for (std::size_t at = text.find('@'); at != std::string_view::npos; at = text.find('@')) {
    const std::size_t end = text.find_first_not_of(name_characters, at + 1);
    if (end == std::string_view::npos || text[end] != '@' || end == at + 1) {  // an attribute of WGSL
      made += text.substr(0, at + 1);
      text.remove_prefix(at + 1);
      continue;
    }
    const bool whole_line = (at == 0 ? made.empty() || made.back() == '\n' : text[at - 1] == '\n') &&
                            end + 1 < text.size() && text[end + 1] == '\n';
    made += text.substr(0, at);
    made += filling.at(std::string(text.substr(at + 1, end - at - 1)));
    text.remove_prefix(end + (whole_line ? 2 : 1));
  }
  return made += text;
}

}  // namespace restrip::generator
