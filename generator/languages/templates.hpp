// The fixed text of the files in other languages: the files of templates/, embedded at build time (cmake/Embed.cmake).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace restrip::generator {

extern const std::string_view automaton_check_c;
extern const std::string_view automaton_check_comp;
extern const std::string_view automaton_check_mjs;
extern const std::string_view automaton_check_rs;
extern const std::string_view automaton_check_wgsl;
extern const std::string_view automaton_h;
extern const std::string_view automaton_mjs;
extern const std::string_view automaton_rs;
extern const std::string_view automaton_glsl;
extern const std::string_view automaton_wgsl;
extern const std::string_view operation_h;
extern const std::string_view operation_rs;
extern const std::string_view operation_glsl;
extern const std::string_view operation_wgsl;
extern const std::string_view tables_check_c;
extern const std::string_view tables_check_comp;
extern const std::string_view tables_check_mjs;
extern const std::string_view tables_check_rs;
extern const std::string_view tables_check_wgsl;
extern const std::string_view tables_h;
extern const std::string_view tables_mjs;
extern const std::string_view tables_rs;
extern const std::string_view tables_glsl;
extern const std::string_view tables_wgsl;

/// The value of each `@name@` in a template. A placeholder on a separate line stands for whole lines: its value ends
/// with a line break, or is empty.
using Filling = std::map<std::string, std::string>;

/// The template with its placeholders replaced. Replacements are not searched again. Throws std::out_of_range for a
/// placeholder without a value.
[[nodiscard]] std::string filled(std::string_view text, const Filling& filling);

}  // namespace restrip::generator
