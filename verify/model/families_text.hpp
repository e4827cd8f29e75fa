#pragma once
// tables/families.json as it was when this was built (cmake/EmbedFamilies.cmake).

#include <string_view>

namespace restrip::verify {

extern const std::string_view families_text;

}  // namespace restrip::verify
