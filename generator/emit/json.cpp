// The tables as JSON; docs/tables.schema.json is the schema. The table of an operation is as in
// docs/how-to/other-languages.md.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "emit/languages.hpp"
#include "emit/number_lines.hpp"

namespace restrip::generator {
namespace {

/// A member whose value is an array of numbers; removes the last comma of `numbers`.
std::string json_numbers(const TableArray& array, const std::string& key) {
  std::string text = numbers(array.values);
  text.erase(text.find_last_of(','), 1);
  return fmt::format("\"{}\": [\n{}]", key, text);
}

}  // namespace

std::string json_tables(const TableLayout& layout) {
  std::string text = fmt::format(
      "{{\n\"format\": \"restrip-tables\",\n\"version\": 2,\n"
      "\"license\": \"MIT, Copyright (c) 2026 The restrip authors\",\n"
      "\"command\": \"restrip-generate tables --language json --max-k {0}\",\n\"max_k\": {0},\n\"operations\": [",
      layout.max_k);
  std::string between = "\n    ";
  for (const LookUp& look_up : look_ups()) {
    std::string position;
    for (const std::string& number : look_up.position)
      position += fmt::format("{}\"{}\"", position.empty() ? "" : ", ", number);
    text += fmt::format(
        "{}{{\"name\": \"{}\", \"position\": [{}], \"family\": \"{}\", \"from_fan\": {}, \"before_bits\": {}, "
        "\"after_bits\": {}, \"triangles\": {}}}",
        between, look_up.name, position, look_up.family, look_up.from_fan, look_up.before_bits, look_up.after_bits,
        look_up.triangles);
    between = ",\n    ";
  }
  text += "\n],\n" + json_numbers(*layout.find("closed_rows"), "rows") + ",\n\"families\": {";
  between = "\n";
  std::set<std::string> written;
  for (const LookUp& look_up : look_ups()) {
    if (look_up.position.empty() || !written.insert(look_up.family).second) continue;
    text += fmt::format("{}\"{}\": {{", between, look_up.family);
    between = "\n";
    for (const char* part : {"first", "cells", "rules"})
      if (const TableArray* array = layout.find(look_up.family + "_" + part)) {
        text += between + json_numbers(*array, part);
        between = ",\n";
      }
    text += "\n}";
    between = ",\n";
  }
  return text + "\n},\n" + json_numbers(*layout.find("flip_rules"), "flip") + "\n}\n";
}

std::string json_automaton(const AutomatonArrays& automaton) {
  std::string text = fmt::format(
      "{{\n\"format\": \"restrip-automaton\",\n\"version\": 2,\n"
      "\"license\": \"MIT, Copyright (c) 2026 The restrip authors\",\n"
      "\"command\": \"restrip-generate automaton --language json\",\n\"seconds\": {}",
      automaton.seconds);
  for (const TableArray& array : automaton.table.arrays) text += ",\n" + json_numbers(array, array.name);
  return text + "\n}\n";
}

std::string json_operation(const OperationLayout& layout) {
  const Description& named = layout.named();
  const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
  std::vector<std::string> positions;
  const auto listed = [](const std::vector<SurfaceTriangle>& triangles) {
    std::vector<std::string> words;
    words.reserve(triangles.size());
    for (const SurfaceTriangle& t : triangles)
      words.push_back(
          fmt::format("[{}, {}, {}, {}]", t.from, t.from_side, fmt::join(t.vertex, ", "), fmt::join(t.side, ", ")));
    return fmt::format("[{}]", fmt::join(words, ", "));
  };
  for (const OperationLayout::At& at : layout.positions) {
    const PositionNumbers all = at.position.numbers();
    const auto& [before, after, vertices] = at.position.patch.surface;
    const std::string surface =
        fmt::format(",\n     \"vertices\": {}, \"triangles_before\": {}, \"triangles_after\": {}", vertices,
                    listed(before), listed(after));
    const auto size = [](const Side& side) {
      return fmt::format("{{\"triangles\": {}, \"edges\": {}}}", side.nodes, side.edges.size());
    };
    positions.push_back(
        fmt::format("    {{\"numbers\": [{}], \"before\": {}, \"after\": {}, \"ports\": {}, \"first\": {}{}}}",
                    fmt::join(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(named.numbers.size()), ", "),
                    size(at.position.patch.before), size(at.position.patch.after), at.position.patch.before.ports(),
                    at.first, surface));
  }
  return fmt::format(
      "{{\n\"format\": \"restrip-operation-table\",\n\"version\": 1,\n"
      "\"command\": \"restrip-generate rules --language json\",\n\"name\": {},\n\"about\": {},\n\"matching\": {},\n"
      "\"numbers\": {},\n\"positions\": [\n{}\n],\n\"none\": {},\n{}\n}}\n",
      quoted(named.name), quoted(named.about), layout.matching(), nlohmann::json(named.numbers).dump(),
      fmt::join(positions, ",\n"), layout.none(), json_numbers({"entries", layout.width, layout.entries}, "entries"));
}

}  // namespace restrip::generator
