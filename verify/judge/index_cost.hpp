#pragma once
// The most that an operation adds to the length of an index buffer, 3 strips + swaps, over all configurations and all
// turns of strips beyond the ports.

#include "certificate/certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// Checks the family's claim "indices" (docs/reference/operation-file.md), if its description has one. A keeper uses
/// the colours of the rule or, if they cost more, the previous colours passed on: a strip cut by an inserted triangle
/// continues through it, and a strip through a removed triangle closes up. If no triangle is inserted or removed, only
/// the rule is possible.
void report_index_cost(const Family& family, const Certificate& certificate, unsigned threads,
                       const ClaimListener& listener);

}  // namespace restrip::verify
