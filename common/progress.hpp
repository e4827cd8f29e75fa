// Shows the progress of work on a terminal.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

namespace restrip {

/// Whether a piece of work shows its progress, or is one of many of its kind.
enum class Watched { no, yes };

/// One line on standard error, "baking … 12 %", or "baking …" if the total is 1, wiped when the work is done. Nothing
/// is shown if standard error is a pipe or a file, if the total is 0, or if the work is not watched.
class Progress {
 public:
  /// Shows that the work has begun.
  Progress(std::string label, std::size_t total, Watched watched = Watched::yes)
      : label_(std::move(label)),
        total_(total),
        next_(watched == Watched::yes && total != 0 && isatty(STDERR_FILENO) != 0 ? 0 : never) {
    at(0);
  }
  ~Progress() {
    if (next_ != never) fmt::print(stderr, "\r\033[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call it at any rate: a line is written when another percent is done. For one thread.
  void at(std::size_t done) {
    if (done < next_) return;
    fmt::print(stderr, "\r\033[K{} …{}", label_, total_ == 1 ? "" : fmt::format(" {} %", 100 * done / total_));
    std::fflush(stderr);
    next_ = done + std::max<std::size_t>(1, total_ / 100);
  }

  /// Counts one more as done; for any thread, if none calls at().
  void step() {
    const std::lock_guard lock(mutex_);
    at(++done_);
  }

 private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  std::string label_;
  std::size_t total_;
  std::size_t next_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

}  // namespace restrip
