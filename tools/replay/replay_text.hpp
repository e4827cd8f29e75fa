// ReplayReport as text and as JSON (docs/reference/programs.md, "The report of a replay").
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "replay/replay.hpp"
#include "replay/walk.hpp"

namespace restrip::tools {

/// The costs of baked strips.
struct BakedCosts {
  double flips_per_record = 0;
  double bytes_per_record = 0;  ///< of the file, vertex positions and connectivity included
  double seconds = 0;           ///< of baking; 0 if they were read from a file
};

/// What was replayed.
struct Subject {
  std::string name;
  std::size_t wanted_triangles = 0;  ///< of the base; 0 if the base was given
  LeftOut left_out;
  Mended mended;       ///< of the file, if it was read
  std::string policy;  ///< the way's name
  Search search;       ///< of the way
  Cost cost;           ///< the minimised cost
  std::optional<BakedCosts> baked;
};

[[nodiscard]] std::string as_text(const ReplayReport& report, const Subject& subject);
[[nodiscard]] std::string as_text(const WalkReport& walk);
[[nodiscard]] nlohmann::ordered_json as_json(const ReplayReport& report, const Subject& subject,
                                             const std::optional<WalkReport>& walk);

}  // namespace restrip::tools
