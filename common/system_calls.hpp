#pragma once
// Every system call by which this folder reads or changes files, in one replaceable table, so that a test can make each
// of them fail in turn. Calls that only inspect (stat, readlink, access) are not in it.

#include <sys/types.h>

#include <cstddef>

namespace restrip::files {

struct SystemCalls {
  int (*open)(const char* path, int flags, mode_t mode);
  ssize_t (*read)(int file, void* bytes, std::size_t size);
  ssize_t (*write)(int file, const void* bytes, std::size_t size);
  int (*fchmod)(int file, mode_t mode);
  int (*fsync)(int file);
  int (*close)(int file);
  int (*rename)(const char* from, const char* to);
  int (*unlink)(const char* path);
  int (*mkdir)(const char* path, mode_t mode);
};

/// The table in use. Tests replace entries of it; programs do not.
[[nodiscard]] SystemCalls& system_calls() noexcept;

/// From now on a write beyond the file size limit (ulimit -f) is an error instead of the end of the program. Programs
/// call this first of all.
void ignore_file_size_signal() noexcept;

}  // namespace restrip::files
