// An operation: what the search knows of one. Every description (description.hpp) says one for each of its positions.
#pragma once

#include "operations/patch.hpp"
#include "operations/preference.hpp"

namespace restrip::generator {

struct Operation {
  Patch patch;
  Constraint constraint;
  Mask may_give_up = 0;  ///< ports that may be solid before and dashed after
  Preference preference;
  Criterion tie_break;       ///< among recolourings that `preference` finds equal; symmetries need not respect it
  bool turns_first = false;  ///< of two symmetries that serve alike, one that turns the ports is taken before another
};

}  // namespace restrip::generator
