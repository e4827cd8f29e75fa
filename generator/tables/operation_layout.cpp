#include "tables/operation_layout.hpp"

#include <algorithm>

namespace restrip::generator {

OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions) {
  OperationLayout layout;
  // An entry has at least one bit more than a rule, so that all ones means none.
  std::size_t bits = 0;
  for (const auto& [position, section] : positions) {
    layout.positions.push_back({position, 0});
    bits = std::max(bits, position.patch.after.edges.size() + position.patch.after.owner.size());
  }
  layout.width = bits < 8 ? 8 : bits < 16 ? 16 : 32;
  // For matchings, whose keys are the ports, entry P serves every colouring.
  const bool matching = layout.matching();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Operation operation = operation_at(positions[i].position, positions[i].position.patch);
    const Side& before = operation.patch.before;
    const unsigned ports = before.ports();
    const std::size_t first = layout.entries.size();
    layout.positions[i].first = first;
    layout.entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)), layout.none());
    for_each_valid(operation, [&](const Configuration& c) {
      const Row& row = row_of(*positions[i].section, c.ports, c.outcome.joined);
      layout.entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
          row.recoloring << ports | row.kept;
    });
  }
  return layout;
}

std::vector<OperationLayout> operation_layouts(const std::vector<Certificate>& certificates,
                                               const std::vector<Description>& descriptions, unsigned max_k) {
  std::vector<OperationLayout> layouts;
  for (const Certificate& certificate : certificates)
    for (const Description& description : descriptions)
      if (description.certificate == certificate.name)
        layouts.push_back(operation_layout(answers_of(description, certificate.sections, max_k).positions));
  return layouts;
}

}  // namespace restrip::generator
