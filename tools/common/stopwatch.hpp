// Timings in processor time of this thread, and their medians. Other load on the machine is not counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace restrip::tools {

/// The nanoseconds that work() takes.
template <class Work>
double nanoseconds_of(Work&& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

class Medians {
 public:
  template <class Work>
  void time(Work&& work) {
    runs_.push_back(nanoseconds_of(work));
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
  std::vector<double> runs_;
};

}  // namespace restrip::tools
