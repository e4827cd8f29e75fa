#include "common/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace restrip::tools {
namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), next_(total != 0 && isatty(STDERR_FILENO) != 0 ? 0 : never) {
  at(0);
}

Progress::~Progress() {
  // Wipes its line: what remains on the terminal is the result.
  if (next_ != never) fmt::print(stderr, "\r\033[K");
}

void Progress::show(std::size_t done) {
  fmt::print(stderr, "\r\033[K{} … {} %", label_, 100 * done / total_);
  std::fflush(stderr);
  next_ = done + std::max<std::size_t>(1, total_ / 100);
}

}  // namespace restrip::tools
