// The stage `certify` of the generator's pipeline: certificates (docs/reference/certificate.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// All sections of one certificate.
struct Certificate {
  std::string name;
  std::vector<Section> sections;
  std::string text;  ///< the file: claims, rows and reasons; empty if only the rules are needed
  [[nodiscard]] std::size_t rows() const;
};

/// Groups the sections by certificate; the sections of each must be consecutive. The texts take time, which `threads`
/// share.
[[nodiscard]] std::vector<Certificate> certify(std::vector<Section> sections, unsigned threads, bool with_texts);

/// Appends the last line: the number of rows, and two sums of bytes by which a reader can locate a single altered byte.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

}  // namespace restrip::generator
