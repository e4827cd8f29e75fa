// The stage `certify` of the generator's path: the text of certificates (docs/reference/certificate.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// A section as certificates write it, with claims, rows and reasons, which take time.
[[nodiscard]] std::string section_text(const Section& section, Watched watched = Watched::no);

/// All sections of one certificate, rules or linked ones.
struct Certificate {
  std::string name;
  std::vector<Section> sections;
  std::vector<std::string> texts;  ///< of the sections; none where the rules alone are wanted
  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] bool linked() const { return sections.at(0).linked; }
};

/// The sections by certificate, each of which has its sections in a row; `texts` is empty or has one for each.
[[nodiscard]] std::vector<Certificate> by_certificate(std::vector<Section> sections,
                                                      std::vector<std::string> texts = {});

/// The sections by certificate with their texts; `threads` share the work.
[[nodiscard]] std::vector<Certificate> certify(std::vector<Section> sections, unsigned threads);
/// The texts in the order of the sections.
[[nodiscard]] std::vector<std::string> section_texts(const std::vector<Section>& sections, unsigned threads);

/// The file, from the texts of its sections.
[[nodiscard]] std::string certificate_text(const Certificate& certificate);

/// The text with its last line: how many rows, and two sums of its bytes from which a reader can say which single byte
/// was altered.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

}  // namespace restrip::generator
