// Policy: how far an operation looks to keep a colouring good. Keepers (keeper.hpp, index_keeper.hpp) say what each
// means for their cost.
#pragma once

namespace restrip {

/// How far an operation looks.
enum class Policy {
  local,   ///< at the patch
  linked,  ///< along the strips that touch the patch
  quick,   ///< as far as it pays, with small searches
  full     ///< the same with large ones
};

}  // namespace restrip
