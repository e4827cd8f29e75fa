#include "judge/colorings.hpp"

namespace restrip::verify {
namespace {

/// For each triangle its ports.
std::vector<Mask> ports_of_triangles(const Side& side) {
  std::vector<Mask> ports(side.triangles);
  for (unsigned port = 0; port < side.ports(); ++port) ports[side.owner_of_port[port]] |= single(port);
  return ports;
}

}  // namespace

void Colorings::classify(const Side& side, unsigned most_solid, FitTable& table) {
  const std::vector<Mask> ports_of = ports_of_triangles(side);
  std::vector<std::uint32_t> own_number;  // by class of the table
  for (Mask inner = 0; inner < mask_count(side.inner_edges()); ++inner) {
    const std::optional<SolidGraph> graph = inner_graph(side, inner);
    if (!graph) continue;
    const Degrees degree = degrees(side, {inner, 0});
    for (Mask ports = 0; ports < mask_count(ports_); ++ports) {
      bool valid = true;
      unsigned isolated = 0;
      for (unsigned triangle = 0; triangle < side.triangles && valid; ++triangle) {
        const unsigned own = degree[triangle] + solid_count(ports & ports_of[triangle]);
        valid = own <= most_solid;
        isolated += own == 0 ? 1 : 0;
      }
      if (!valid) continue;
      const FitTable::Found found = table.class_of(side, *graph, ports);
      tested_ += table.worlds().of(ports).size();
      if (own_number.size() <= found.fit_class) own_number.resize(table.classes().size(), not_valid);
      std::uint32_t& number = own_number[found.fit_class];
      if (number == not_valid) {
        number = static_cast<std::uint32_t>(classes_.size());
        of_ports_[ports].push_back(number);
        classes_.push_back({found.fit_class, {inner, ports}, 0, {}, {}});
      }
      const Mask both = concatenated(inner, ports, ports_);
      if (found.joined != table.classes()[found.fit_class].joined && odd_one_ == not_valid) odd_one_ = both;
      ColoringClass& own = classes_[number];
      ++own.colorings;
      ++own.with_solid[solid_count(inner) + solid_count(ports)];
      ++own.with_isolated[isolated];
      class_of_[both] = number;
    }
  }
}

}  // namespace restrip::verify
