#include "operations/operation_layout.hpp"

#include <algorithm>

namespace restrip::generator {
namespace {

/// Bits of an entry's type: one more at least than a rule has, so that all ones is none.
unsigned width_of(const std::vector<OperationLayout::At>& positions) {
  std::size_t bits = 0;
  for (const OperationLayout::At& at : positions)
    bits = std::max(bits, at.patch.after.edges.size() + at.patch.after.owner.size());
  return bits < 8 ? 8 : bits < 16 ? 16 : 32;
}

/// Appends the entries of one position.
void append_entries(const AnsweredPosition& answered, OperationLayout& layout) {
  const Operation operation = operation_at(answered.position);
  const Side& before = operation.patch.before;
  const unsigned ports = before.ports();
  const std::size_t first = layout.entries.size();
  // For matchings, whose keys are the ports, entry P serves every colouring.
  const bool matching = layout.matching();
  layout.entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)), layout.none());
  for_each_valid(operation, [&](const Configuration& c) {
    const Row& row = row_of(*answered.section, c.ports, c.outcome.joined);
    layout.entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
        row.recoloring << ports | row.kept;
  });
}

}  // namespace

OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions) {
  OperationLayout layout;
  for (const AnsweredPosition& answered : positions)
    layout.positions.push_back({answered.position, make_patch(answered.position), 0});
  layout.width = width_of(layout.positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    layout.positions[i].first = layout.entries.size();
    append_entries(positions[i], layout);
  }
  return layout;
}

}  // namespace restrip::generator
