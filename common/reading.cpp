#include "common/reading.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/system_calls.hpp"

namespace restrip::files {

std::string read_whole(const std::filesystem::path& file, const ReadLimits& limits) {
  const std::string name = file == "-" ? "/dev/stdin" : file.string();
  Descriptor in(system_calls().open(name.c_str(), O_RDONLY | O_CLOEXEC, 0));
  if (!in.is_open()) {
    if (errno == ENOENT) throw FileError(fmt::format("{}: no such file; check the path", name));
    throw FileError(
        fmt::format("{}: cannot be opened: {}; check the path and your permissions", name, std::strerror(errno)));
  }
  struct stat status {};
  if (fstat(in.get(), &status) != 0)
    throw FileError(fmt::format("{}: cannot be read: {}; check the path", name, std::strerror(errno)));
  if (const Claim* claim = Claim::on(status))
    throw FileError(
        fmt::format("{}: is the input {} itself, which would be lost; name another file", claim->shown(), name));
  if (S_ISDIR(status.st_mode)) throw FileError(fmt::format("{}: is a directory; name a file inside it", name));
  const bool regular = S_ISREG(status.st_mode);
  const std::uint64_t limit = regular ? limits.regular : limits.endless;
  const auto refuse_size = [&] {
    throw FileError(fmt::format("{}: is larger than {}, the limit for {}; {}", name, size_in_words(limit),
                                regular ? "a file" : "a pipe or device",
                                regular ? "cut it into pieces" : "unbounded input? Save it as a file first"));
  };
  const auto announced = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
  if (regular && announced > limit) refuse_size();
  std::string bytes;
  std::size_t filled = 0;
  if (regular) {
    bytes.reserve(announced + 1);
    bytes.resize(announced);
  }
  constexpr std::size_t block = std::size_t{1} << 20;
  while (true) {
    // One byte after the announced size detects the end; blocks are added if the file continues.
    if (filled == bytes.size()) bytes.resize(filled + (filled == announced && filled != 0 ? 1 : block));
    const ssize_t got = system_calls().read(in.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw FileError(fmt::format("{}: reading failed: {}; check the disk or the program that writes it", name,
                                  std::strerror(errno)));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > limit) refuse_size();
  }
  bytes.resize(filled);
  return bytes;
}

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace restrip::files
