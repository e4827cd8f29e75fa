// tables/families.json and a list of the files of tables/operations, embedded at build time (cmake/Embed.cmake).
#pragma once

#include <string_view>

namespace restrip::verify {

extern const std::string_view families_text;
extern const std::string_view operations_text;

}  // namespace restrip::verify
