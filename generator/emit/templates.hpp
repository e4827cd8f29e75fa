// The fixed text of the files in other languages: the files of templates/, embedded at build time (cmake/Embed.cmake).
#pragma once

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
extern const std::string_view operation_check_c;
extern const std::string_view operation_check_mjs;
extern const std::string_view operation_check_rs;
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

}  // namespace restrip::generator
