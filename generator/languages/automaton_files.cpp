// The automaton of all valences in other languages: its arrays, and a look-up by keys, which is the fixed text of
// templates/automaton.*.
#include <fmt/format.h>

#include "languages/languages.hpp"

namespace restrip::generator {
namespace {

/// The values for every template of the automaton; `arrays` is in the language. A split has three edges more than k.
Filling automaton_filling(const std::string& comment, const AutomatonArrays& automaton, unsigned word_bits,
                          const std::string& arrays = {}) {
  std::string operations = fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, "operation", "position", "colours after");
  const auto add = [&](const char* name, const char* position, const char* after) {
    operations += fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, name, position, after);
  };
  add("split", "k >= 3, 1 <= a < k", "inner, k + 3 bits");
  add("collapse", "k >= 3, whatever a", "loop, k bits");
  add("open_split", "k >= 1, 0 <= i < j <= k", "inner, k + 2 bits");
  add("boundary_split", "k >= 1, 0 <= i <= k", "inner, k bits");
  add("fan_collapse", "k >= 1, whatever the gaps", "loop, k - 1 bits: open or boundary collapse");
  return {{"max_k", std::to_string(word_bits - 3)},
          {"bytes", std::to_string(automaton.table.bytes())},
          {"seconds", std::to_string(automaton.seconds)},
          {"operations", operations},
          {"arrays", arrays}};
}

std::string shader_automaton(std::string_view text, const char* array, const AutomatonArrays& automaton) {
  return shader_text(text, array, automaton_filling("//", automaton, 32), automaton.table, "_OF_AUTOMATON");
}

}  // namespace

std::string c_automaton(const AutomatonArrays& automaton) {
  return filled(automaton_h, automaton_filling("//", automaton, 64, c_arrays(automaton.table)));
}

std::string rust_automaton(const AutomatonArrays& automaton) {
  return filled(automaton_rs, automaton_filling("//!", automaton, 64, rust_arrays(automaton.table)));
}

std::string glsl_automaton(const AutomatonArrays& automaton) {
  return shader_automaton(automaton_glsl, glsl_array, automaton);
}

std::string wgsl_automaton(const AutomatonArrays& automaton) {
  return shader_automaton(automaton_wgsl, wgsl_array, automaton);
}

std::string automaton_words_file(const AutomatonArrays& automaton) { return words_file(automaton.table); }

}  // namespace restrip::generator
