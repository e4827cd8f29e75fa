// The automaton of all valences in other languages: its arrays, and a look-up by keys, which is the fixed text of
// templates/automaton.*.
#include <fmt/format.h>

#include "common/number_lines.hpp"
#include "languages/languages.hpp"
#include "languages/templates.hpp"

namespace restrip::generator {
namespace {

/// What every template of the automaton names; `arrays` is in the language. A split has three edges more than k.
Filling automaton_filling(const std::string& comment, const AutomatonArrays& automaton, const std::string& arrays,
                          unsigned word_bits) {
  std::string operations = fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, "operation", "position", "colours after");
  const auto add = [&](const char* name, const char* position, const char* after) {
    operations += fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, name, position, after);
  };
  add("split", "k >= 3, 1 <= a < k", "inner, k + 3 bits");
  add("collapse", "k >= 3, whatever a", "loop, k bits");
  add("open_split", "k >= 1, 0 <= i < j <= k", "inner, k + 2 bits");
  add("boundary_split", "k >= 1, 0 <= i <= k", "inner, k bits");
  add("fan_collapse", "k >= 1, whatever the gaps", "loop, k - 1 bits: open or boundary collapse");
  const Weights& weights = automaton.weights;
  return {{"max_k", std::to_string(word_bits - 3)},
          {"bytes", std::to_string(automaton.table.bytes())},
          {"cost", fmt::format("{},{},{}", weights.restart, weights.swap, weights.isolated)},
          {"restart", std::to_string(weights.restart)},
          {"swap", std::to_string(weights.swap)},
          {"isolated", std::to_string(weights.isolated)},
          {"letters", std::to_string(automaton.letters)},
          {"seconds", std::to_string(automaton.seconds)},
          {"operations", operations},
          {"arrays", arrays}};
}

/// `array` is how the language writes where an array is: its name, the word with which it begins, bits of an element.
std::string shader_automaton(std::string_view text, const AutomatonArrays& automaton, const char* array) {
  const TableWords data = table_words(automaton.table);
  std::string arrays;
  for (const TableWords::Array& one : data.arrays)
    arrays += fmt::format(fmt::runtime(array), one.name, one.word, one.bits);
  Filling filling = automaton_filling("//", automaton, arrays, 32);
  filling["words"] = std::to_string(data.words.size());
  filling["checksum"] = fmt::format("{:#010x}", data.words[0]);
  return filled(text, filling);
}

}  // namespace

std::string c_automaton(const AutomatonArrays& automaton) {
  std::string arrays;
  for (const TableArray& array : automaton.table.arrays)
    arrays += fmt::format("static const uint{}_t restrip_{}[{}] = {{\n{}}};\n", array.bits, array.name,
                          array.values.size(), numbers(array.values));
  return filled(automaton_h, automaton_filling("//", automaton, arrays, 64));
}

std::string rust_automaton(const AutomatonArrays& automaton) {
  std::string arrays;
  for (const TableArray& array : automaton.table.arrays)
    arrays += fmt::format("\nconst {}: &[u{}; {}] = &[\n{}];\n", capitals(array.name), array.bits, array.values.size(),
                          numbers(array.values));
  return filled(automaton_rs, automaton_filling("//!", automaton, arrays, 64));
}

std::string glsl_automaton(const AutomatonArrays& automaton) {
  return shader_automaton(automaton_glsl, automaton, "const uvec2 RESTRIP_{}_OF_AUTOMATON = uvec2({}u, {}u);\n");
}

std::string wgsl_automaton(const AutomatonArrays& automaton) {
  return shader_automaton(automaton_wgsl, automaton, "const RESTRIP_{}_OF_AUTOMATON = vec2<u32>({}u, {}u);\n");
}

std::string automaton_words_file(const AutomatonArrays& automaton) { return words_file(automaton.table); }

}  // namespace restrip::generator
