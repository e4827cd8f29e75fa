#include "dump.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::generator {
namespace {

/// "loop" for the fan alone, "inner" where there are other triangles.
std::string colors_of(const SidePattern& side) {
  return side.stretches.size() == 1 && side.stretches[0].name == "t" ? "loop" : "inner";
}

std::string header(const Family& family) {
  std::string text;
  for (const std::string& number : family.numbers) text += number + ",";
  const std::string before = colors_of(family.before);
  const std::string after = colors_of(family.after);
  text += before + ",ports," + after + (before == after ? "_after," : ",");
  return text + (family.gives_ports_up ? "ports_after," : "") + "strips,isolated";
}

}  // namespace

std::string dump_columns() {
  std::string text;
  for (const Family& family : families()) text += fmt::format("  {:<19}{}\n", family.name, header(family));
  return text;
}

void dump(const Family& family, unsigned k, std::FILE* out) {
  const auto sections = solve(family.certificate, k, 1);
  fmt::print(out, "{}\n", header(family));
  for (const Position& position : positions(family, k)) {
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& s) {
      return std::find(s.serves.begin(), s.serves.end(), position) != s.serves.end();
    });
    const Patch patch = make_patch(position);
    std::string numbers;
    for (std::size_t i = 0; i < family.numbers.size(); ++i) numbers += fmt::format("{},", position.numbers().at(i));
    for_each_valid(position, patch.before, [&](const Configuration& c) {
      const Row& row = row_of(*section, c.key);
      const Change change = change_of(patch, c, row);
      fmt::print(out, "{}{},{},{},", numbers, c.before, c.ports, row.recoloring);
      if (family.gives_ports_up) fmt::print(out, "{},", row.kept);
      fmt::print(out, "{},{}\n", change.strips, change.isolated);
    });
  }
}

}  // namespace restrip::generator
