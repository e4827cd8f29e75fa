#include "dump.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::generator {
namespace {

std::string certificate_family(Family family) {
  if (family == Family::open_collapse || family == Family::boundary_collapse) return "fan-collapse";
  return name_of(family);
}

std::string place_columns(const Position& p) {
  switch (p.family) {
    case Family::flip:
      return "";
    case Family::open_split:
    case Family::open_collapse:
      return fmt::format("{},{},{},", p.k, p.at, p.to);
    default:
      return fmt::format("{},{},", p.k, p.at);
  }
}

const char* header(Family family) {
  switch (family) {
    case Family::split:
      return "k,a,loop,ports,inner,strips,isolated";
    case Family::collapse:
      return "k,a,inner,ports,loop,strips,isolated";
    case Family::open_split:
      return "k,i,j,loop,ports,inner,strips,isolated";
    case Family::open_collapse:
      return "k,i,j,inner,ports,loop,strips,isolated";
    case Family::boundary_split:
      return "k,i,loop,ports,inner,strips,isolated";
    case Family::boundary_collapse:
      return "k,i,inner,ports,loop,strips,isolated";
    case Family::flip:
      break;
  }
  return "inner,ports,inner_after,ports_after,strips,isolated";
}

}  // namespace

void dump(Family family, unsigned k, std::FILE* out) {
  const auto sections = solve(certificate_family(family), k, 1);
  fmt::print(out, "{}\n", header(family));
  for (const Position& position : positions(family, k)) {
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& s) {
      return std::find(s.serves.begin(), s.serves.end(), position) != s.serves.end();
    });
    const Patch patch = make_patch(position);
    const std::string place = place_columns(position);
    for_each_valid(position, patch.before, [&](const Configuration& c) {
      const Row& row = row_of(*section, c.key);
      const Cost cost = cost_of(patch, c, row);
      fmt::print(out, "{}{},{},{},", place, c.before, c.ports, row.recoloring);
      if (family == Family::flip) fmt::print(out, "{},", row.kept);
      fmt::print(out, "{},{}\n", cost.strips, cost.isolated);
    });
  }
}

}  // namespace restrip::generator
