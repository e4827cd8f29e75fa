#pragma once
// on_threads(), for work shared by several threads, and the processor time of a thread.

#include <ctime>

#include "common/share.hpp"

namespace restrip::verify {

/// Processor seconds of the calling thread.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace restrip::verify
