#pragma once
// All configurations and all recolourings that share their solid ports. Everything is enumerated, nothing skipped.

#include <vector>

#include "operation.hpp"
#include "survey.hpp"

namespace restrip::verify {

struct SurveyedColoring {
  Coloring colors;
  Survey survey;
};

struct PortSlice {
  Mask ports = 0;                        ///< solid before the operation
  std::vector<SurveyedColoring> before;  ///< configurations, in ascending order of their inner mask
  std::vector<SurveyedColoring> after;   ///< recolourings; a flip may also give ports up; none unless searched
};

/// Without the recolourings if the operation is not searched.
PortSlice slice_of(const Operation& operation, Mask ports);

}  // namespace restrip::verify
