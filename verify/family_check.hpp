#pragma once
// All claims about one family, given its certificate and the checks of its operations.

#include "operation_check.hpp"
#include "report.hpp"
#include "section_check.hpp"

namespace restrip::verify {

/// `checks` holds one entry for each operation of each section, in order. Every claim is handed to the listener.
void report_family(const Family& family, const Certificate& certificate, const std::vector<OperationCheck>& checks,
                   bool second_formulation, const ClaimListener& listener);

}  // namespace restrip::verify
