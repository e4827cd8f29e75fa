// How far a long step has come, on a terminal; nothing at all where standard error is a pipe or a file.
#pragma once

#include <cstddef>
#include <string>

namespace restrip::tools {

class Progress {
 public:
  /// Shows that the step has begun; `total` = 0 shows nothing.
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call as often as you like: a line is written when another percent is done.
  void at(std::size_t done) {
    if (done >= next_) show(done);
  }

 private:
  void show(std::size_t done);

  std::string label_;
  std::size_t total_;
  std::size_t next_;
};

}  // namespace restrip::tools
