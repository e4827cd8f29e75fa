#pragma once
// Certificates of the versions before 3, brought into the form of today: rows of families whose keys have `joined`
// masks of fans, rows of flips that are told by their inner edge, rows of operations whose keys have all pairs.

#include "certificate/certificate.hpp"

namespace restrip::verify {

bool is_older_certificate(std::string_view text);
Certificate parse_older_certificate(const std::string& file, std::string text, const Family& family);

}  // namespace restrip::verify
