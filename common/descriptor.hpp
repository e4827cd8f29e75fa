#pragma once
// A file descriptor that is closed when its owner is destroyed.

#include <cerrno>
#include <cstddef>
#include <utility>

#include "common/system_calls.hpp"

namespace restrip::files {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int file) noexcept : file_(file) {}
  ~Descriptor() {
    if (file_ >= 0) system_calls().close(file_);
  }
  Descriptor(Descriptor&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  [[nodiscard]] int get() const noexcept { return file_; }
  [[nodiscard]] bool is_open() const noexcept { return file_ >= 0; }
  /// False when closing reports an error, with errno set; the descriptor is closed either way.
  [[nodiscard]] bool close() noexcept { return system_calls().close(std::exchange(file_, -1)) == 0; }

 private:
  int file_ = -1;
};

/// Writes all bytes, in any number of calls. False with errno set if it fails.
[[nodiscard]] inline bool write_fully(int file, const char* bytes, std::size_t size) noexcept {
  while (size > 0) {
    const ssize_t written = system_calls().write(file, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      if (written == 0) errno = ENOSPC;
      return false;
    }
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace restrip::files
