// How far some work is, for whoever waits at a terminal.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

namespace restrip::generator {

/// Whether a piece of work shows its own progress, or counts as one of many of its kind.
enum class Watched { no, yes };

/// One line on standard error, "solved 3 of 7 sections", which goes when the work is done; nothing where standard error
/// is no terminal. Several threads may call step().
class Progress {
 public:
  /// "solved", 7, "sections"; of work that is not watched nothing is shown.
  Progress(std::string done, std::size_t all, std::string of_what, Watched watched = Watched::yes)
      : done_(std::move(done)),
        of_what_(std::move(of_what)),
        all_(all),
        terminal_(watched == Watched::yes && isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (terminal_) std::fputs("\r\x1b[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step() {
    if (!terminal_) return;
    const std::lock_guard lock(mutex_);
    ++count_;
    if (count_ * 200 / all_ != (count_ - 1) * 200 / all_)
      fmt::print(stderr, "\r{} {} of {} {}", done_, count_, all_, of_what_);
  }

 private:
  std::string done_;
  std::string of_what_;
  std::size_t all_;
  std::size_t count_ = 0;
  bool terminal_;
  std::mutex mutex_;
};

}  // namespace restrip::generator
