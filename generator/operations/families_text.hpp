// tables/families.json and docs/taken-names.json as they were when this was built (cmake/Embed.cmake).
#pragma once

#include <string_view>

namespace restrip::generator {

extern const std::string_view families_text;
extern const std::string_view taken_names_text;

}  // namespace restrip::generator
