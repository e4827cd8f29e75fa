// An operation: what the search knows of one. The families of docs/notation.md are such (family_operation.hpp), and so
// are those of operation files (operations/).
#pragma once

#include "patch.hpp"
#include "preference.hpp"

namespace restrip::generator {

struct Operation {
  Patch patch;
  Constraint constraint;
  Mask may_give_up = 0;  ///< ports that may be solid before and dashed after
  Preference preference;
};

}  // namespace restrip::generator
