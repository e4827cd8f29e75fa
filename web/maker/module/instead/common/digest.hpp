// In place of common/digest.hpp: the page makes rules of custom operations, which no MANIFEST lists.
#pragma once
#include <stdexcept>
#include <string>

namespace restrip {

inline std::string sha256(const std::string& /*bytes*/) { throw std::logic_error("the page makes no MANIFEST"); }

}  // namespace restrip
