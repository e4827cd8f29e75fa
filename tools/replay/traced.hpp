// An upkeep whose operations are recorded (restrip/output/trace.hpp).
#pragma once

#include <memory>
#include <optional>

#include "replay/upkeep.hpp"
#include "replay/ways.hpp"
#include "restrip/output/trace.hpp"

namespace restrip::tools {

/// What a trace of that plan claims.
[[nodiscard]] Trace::Claim claim_of(const Plan& plan);

/// Keeps strips as `kept` does, which began on the mesh. `trace` begins with the mesh as it is now, and again with each
/// restart. It has one record for each operation, and another one for what is done between two operations, if that is
/// anything. Both must outlive the result. Nobody else may watch the mesh meanwhile.
[[nodiscard]] std::unique_ptr<Upkeep> traced(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim,
                                             std::optional<Trace>& trace);

}  // namespace restrip::tools
