// Reads whole files, up to a limit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/printable.hpp"

namespace restrip::files {

/// The most bytes that are read. The size of a regular file is known in advance; a pipe or a device may never end.
struct ReadLimits {
  std::uint64_t regular = std::uint64_t{16} << 30;
  std::uint64_t endless = std::uint64_t{256} << 20;
};

/// All bytes of a file, a pipe or a device; `-` is standard input. Throws FileError when it cannot be read, is an
/// output of this thread (output.hpp), or is larger than the limit, which the message states; then at most that many
/// bytes have been read.
[[nodiscard]] std::string read_whole(const std::filesystem::path& file, const ReadLimits& limits = {});

/// The extension in lower case, with its dot; empty when none exists.
[[nodiscard]] std::string extension_of(const std::filesystem::path& file);

}  // namespace restrip::files
