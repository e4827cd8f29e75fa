#include "common/system_calls.hpp"

#include <fcntl.h>
#include <signal.h>  // NOLINT: the names below are POSIX
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

namespace restrip::files {

SystemCalls& system_calls() noexcept {
  static SystemCalls table{
      .open = [](const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); },
      .read = [](int file, void* bytes, std::size_t size) { return ::read(file, bytes, size); },
      .write = [](int file, const void* bytes, std::size_t size) { return ::write(file, bytes, size); },
      .fchmod = [](int file, mode_t mode) { return ::fchmod(file, mode); },
      .fsync = [](int file) { return ::fsync(file); },
      .close = [](int file) { return ::close(file); },
      .rename = [](const char* from, const char* to) { return ::rename(from, to); },
      .unlink = [](const char* path) { return ::unlink(path); },
      .mkdir = [](const char* path, mode_t mode) { return ::mkdir(path, mode); },
  };
  return table;
}

void ignore_file_size_signal() noexcept { ::signal(SIGXFSZ, SIG_IGN); }

}  // namespace restrip::files
