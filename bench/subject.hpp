// The progressive meshes that benchmarks replay.
#pragma once

#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "replay/ways.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::bench {

struct Subject {
  tools::ProgressiveMesh mesh;  ///< quadric collapses to 2 %
  StripMesh base;               ///< with strips from scratch
  std::size_t triangles = 0;    ///< of the finest level
};

/// "made", and "bunny" and "dragon" if their files exist.
[[nodiscard]] std::vector<std::string> subject_names();
/// Made on first use, and kept.
[[nodiscard]] const Subject& subject(const std::string& name);

/// Baking the dragon takes minutes (docs/how-to/baked-strips.md has its figures), so it is left out here.
[[nodiscard]] bool has_plan(const std::string& name, const tools::Way& way);
/// Made on first use, and kept. Costs other than strips only for ways that weigh.
[[nodiscard]] const tools::Plan& plan(const std::string& name, const tools::Way& way,
                                      const Cost& cost = Cost::strips());

}  // namespace restrip::bench
