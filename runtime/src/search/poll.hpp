// Whether a long search is to end.
#pragma once

#include "restrip/search/stripify.hpp"

namespace restrip::detail {

/// Asks an Interrupt at every 64th step of a search, of which none takes more than about a millisecond.
class Poll {
 public:
  explicit Poll(const Interrupt& interrupt) noexcept : interrupt_(interrupt) {}

  /// Call it once a step. After the first true, always true.
  bool stops() {
    if (interrupt_.stop == nullptr || stopped_) return stopped_;
    if (++steps_ % 64 == 0) stopped_ = interrupt_.stop(interrupt_.context);
    return stopped_;
  }

 private:
  Interrupt interrupt_;
  unsigned steps_ = 0;
  bool stopped_ = false;
};

}  // namespace restrip::detail
