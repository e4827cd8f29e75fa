// An upkeep that records its operations (restrip/output/trace.hpp).
#pragma once

#include <memory>
#include <optional>

#include "replay/upkeep.hpp"
#include "replay/ways.hpp"
#include "restrip/output/trace.hpp"

namespace restrip::tools {

/// The claim in a trace of that plan.
[[nodiscard]] Trace::Claim claim_of(const Plan& plan);

/// Keeps strips as `kept` does, which must already work on the mesh. `trace` starts with the current mesh, and again
/// with each restart. It has one record per operation, and another one for changes between two operations, if any. Both
/// must outlive the result. Nothing else may watch the mesh meanwhile.
[[nodiscard]] std::unique_ptr<Upkeep> traced(StripMesh& mesh, std::unique_ptr<Upkeep> kept, Trace::Claim claim,
                                             std::optional<Trace>& trace);

}  // namespace restrip::tools
