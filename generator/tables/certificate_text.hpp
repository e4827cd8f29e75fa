// The stage `certify` of the generator's pipeline: the text of certificates (docs/reference/certificate.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// A section as certificates write it, with claims, rows and reasons, which take time.
[[nodiscard]] std::string section_text(const Section& section, Watched watched = Watched::no);

/// All sections of one certificate.
struct Certificate {
  std::string name;
  std::vector<Section> sections;
  std::vector<std::string> texts;  ///< of the sections; empty if only the rules are needed
  [[nodiscard]] std::size_t rows() const;
};

/// Groups the sections by certificate; the sections of each must be consecutive. `texts` is empty or has one for each
/// section.
[[nodiscard]] std::vector<Certificate> by_certificate(std::vector<Section> sections,
                                                      std::vector<std::string> texts = {});

/// The texts in the order of the sections; `threads` share the work.
[[nodiscard]] std::vector<std::string> section_texts(const std::vector<Section>& sections, unsigned threads);

/// The file, from the texts of its sections.
[[nodiscard]] std::string certificate_text(const Certificate& certificate);

/// Appends the last line: the number of rows, and two sums of bytes by which a reader can locate a single altered byte.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

}  // namespace restrip::generator
