#pragma once
// Every system call by which this folder reads or changes files, in one replaceable table, so that a test can make each
// of them fail in turn. Calls that only inspect (stat, readlink, access) are not in it.

#include <fcntl.h>
#include <signal.h>  // NOLINT: the names below are POSIX
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>

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

}  // namespace restrip::files
