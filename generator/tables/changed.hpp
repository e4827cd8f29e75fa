// Files that already have their bytes are not written again, so that nothing is compiled again because of them.
#pragma once

#include <filesystem>
#include <vector>

#include "common/output.hpp"

namespace restrip::generator {

/// Those of the files that the folder does not have with these bytes, in the same order. O(bytes of the files).
[[nodiscard]] std::vector<files::NamedBytes> changed(const std::filesystem::path& folder,
                                                     std::vector<files::NamedBytes> files);

}  // namespace restrip::generator
