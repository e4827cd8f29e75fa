#pragma once
// What an operation adds at most to the length of an index buffer, 3 strips + swaps, counted over all configurations
// and all ways in which strips may turn behind the ports.

#include "certificate/certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// The family's claim "indices" (docs/reference/operation-file.md), if its description makes one. A keeper takes the
/// colours of the rule or, if these cost more, the colours before, passed on: a strip that an inserted triangle cuts
/// goes through it, a strip through a triangle that goes closes up. Where no triangle is inserted or goes there is only
/// the rule.
void report_index_cost(const Family& family, const Certificate& certificate, unsigned threads,
                       const ClaimListener& listener);

}  // namespace restrip::verify
