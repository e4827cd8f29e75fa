#include "slice.hpp"

namespace restrip::verify {
namespace {

void add_all(const Patch& patch, Mask ports, std::vector<SurveyedColoring>& colorings) {
  for (Mask inner = 0; inner < mask_count(patch.inner_edges()); ++inner)
    colorings.push_back({{inner, ports}, survey(patch, {inner, ports})});
}

}  // namespace

PortSlice slice_of(const Operation& operation, Mask ports) {
  PortSlice slice{ports, {}, {}};
  add_all(operation.before, ports, slice.before);
  if (!searched(operation)) return slice;
  for (Mask kept = 0; kept <= ports; ++kept)
    if (kept == ports || (operation.gives_ports_up && is_subset(kept, ports)))
      add_all(operation.after, kept, slice.after);
  return slice;
}

}  // namespace restrip::verify
