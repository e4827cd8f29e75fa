#include "fit_classes.hpp"

#include <algorithm>
#include <map>

#include "operation_mutants.hpp"

namespace restrip::verify::operations {

FitClasses::FitClasses(const Side& side, unsigned most_solid, const Worlds& worlds)
    : ports(side.ports()),
      of_ports(mask_count(side.ports())),
      class_of_coloring(mask_count(side.inner_edges() + side.ports()), not_valid) {
  std::vector<std::map<NumberSet, std::uint32_t>> known(mask_count(ports));
  std::vector<NumberSet> fitted;
  for (Mask mask = 0; mask < mask_count(ports); ++mask) fitted.emplace_back(worlds.of(mask).size());
  for (Mask inner = 0; inner < mask_count(side.inner_edges()); ++inner) {
    const std::optional<SolidGraph> graph = inner_graph(side, inner);
    if (!graph) continue;
    for (Mask mask = 0; mask < mask_count(ports); ++mask) {
      const Colors colors{inner, mask};
      const auto count = degrees(side, colors);
      if (*std::max_element(count.begin(), count.end()) >
          most_solid + (mutated(OperationMutant::loosen_degree) ? 1 : 0))
        continue;
      NumberSet& set = fitted[mask];
      set.clear();
      for (std::size_t world = 0; world < worlds.of(mask).size(); ++world)
        if (fits(side, *graph, mask, worlds.of(mask)[world])) set.add(world);
      tested += worlds.of(mask).size();
      const auto [place, is_new] = known[mask].try_emplace(set, static_cast<std::uint32_t>(classes.size()));
      if (is_new) {
        of_ports[mask].push_back(place->second);
        classes.push_back({colors, set, joined_ports(side, *graph, mask), 0});
      }
      ++classes[place->second].colorings;
      class_of_coloring[concatenated(inner, mask, ports)] = place->second;
    }
  }
}

}  // namespace restrip::verify::operations
