// Every system call by which this folder reads or changes files, in one replaceable table, so that a test can make each
// of them fail in turn. Calls that only inspect (stat, readlink, access) are not in it. And what is built on them: a
// file descriptor that is closed when its owner is destroyed.
#pragma once

#include <fcntl.h>
#include <signal.h>  // NOLINT: the names below are POSIX
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace restrip::files {

struct SystemCalls {
  int (*open)(const char* path, int flags, mode_t mode) = [](const char* path, int flags, mode_t mode) {
    return ::open(path, flags, mode);
  };
  ssize_t (*read)(int file, void* bytes, std::size_t size) = ::read;
  ssize_t (*write)(int file, const void* bytes, std::size_t size) = ::write;
  int (*fchmod)(int file, mode_t mode) = ::fchmod;
  int (*fsync)(int file) = ::fsync;
  int (*close)(int file) = ::close;
  int (*rename)(const char* from, const char* to) = ::rename;
  int (*unlink)(const char* path) = ::unlink;
  int (*mkdir)(const char* path, mode_t mode) = ::mkdir;
};

/// The table in use. Tests replace entries of it; programs do not.
[[nodiscard]] inline SystemCalls& system_calls() noexcept {
  static SystemCalls table;
  return table;
}

/// From now on a write beyond the file size limit (ulimit -f) is an error instead of the end of the program. Programs
/// call this first of all.
inline void ignore_file_size_signal() noexcept { ::signal(SIGXFSZ, SIG_IGN); }

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
