// Files as wholes: read at once, written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace restrip::replay {

/// All bytes of a file. Throws BadInput when it cannot be read.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& file);

/// Writes beside the target and renames, so that nobody ever sees half a file. Throws BadInput when that fails; then
/// the target is as it was. A target that is there and no regular file (a device, a pipe, a link) is written to as it
/// is: to replace it would take it away from everybody else.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace restrip::replay
