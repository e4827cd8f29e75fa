// Medians of repeated timings, in processor time of this thread. Other load on the machine is not counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace restrip::tools {

class Medians {
 public:
  template <class Work>
  void time(Work&& work) {
    const double start = now();
    work();
    runs_.push_back(now() - start);
  }
  /// The median of all runs so far; 0 before the first run.
  [[nodiscard]] double nanoseconds() const {
    if (runs_.empty()) return 0;
    std::vector<double> sorted = runs_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
  }

  std::vector<double> runs_;
};

}  // namespace restrip::tools
