// tables/families.json as it was when this was built (cmake/EmbedFamilies.cmake).
#pragma once

#include <string_view>

namespace restrip::generator {

extern const std::string_view families_text;

}  // namespace restrip::generator
