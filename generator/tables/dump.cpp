#include "tables/dump.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solve/section.hpp"

namespace restrip::generator {
namespace {

/// "loop" for the fan alone, "inner" if there are other triangles.
std::string colors_of(const SidePattern& side) {
  const std::vector<Stretch>& elements = side.chains[0].elements;
  return side.chains.size() == 1 && elements.size() == 1 && elements[0].range ? "loop" : "inner";
}

std::string header(const Description& family) {
  std::string text;
  for (const std::string& number : family.numbers) text += number + ",";
  const std::string before = colors_of(std::get<SidePattern>(family.before));
  const std::string after = colors_of(std::get<SidePattern>(family.after));
  text += before + ",ports," + after + (before == after ? "_after," : ",");
  return text + (family.gives_all_up ? "ports_after," : "") + "strips,isolated";
}

}  // namespace

std::string dump_columns() {
  std::string text;
  for (const Description& family : families()) text += fmt::format("  {:<19}{}\n", family.name, header(family));
  return text;
}

void dump(const Description& family, unsigned k, std::FILE* out) {
  const auto sections = solved(family.certificate, std::max(k, 3U), 1);  // all families have positions up to 3
  fmt::print(out, "{}\n", header(family));
  for (const Position& position : positions(family, k)) {
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& s) {
      return std::find(s.serves.begin(), s.serves.end(), position) != s.serves.end();
    });
    const Operation operation = operation_at(position);
    std::string place;
    for (std::size_t i = 0; i < family.numbers.size(); ++i) place += fmt::format("{},", position.numbers().at(i));
    for_each_valid(operation, [&](const Configuration& c) {
      const Row& row = row_of(*section, c.ports, c.outcome.joined);
      const Change change = change_of(operation.patch, c, row);
      fmt::print(out, "{}{},{},{},", place, c.before, c.ports, row.recoloring);
      if (family.gives_all_up) fmt::print(out, "{},", row.kept);
      fmt::print(out, "{},{}\n", change.strips, change.isolated);
    });
  }
}

}  // namespace restrip::generator
