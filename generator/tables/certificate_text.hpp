// The text of certificates (docs/certificate.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// A solved section as certificates write it, with claims, rows and reasons, which take time.
[[nodiscard]] std::string section_text(const Section& section, Watched watched = Watched::no);

/// The first two lines of a certificate of rules.
[[nodiscard]] std::string certificate_head(const std::string& name);

/// All sections of one certificate, rules or linked ones; with what solve() finds.
struct Certificate {
  std::string name;
  std::vector<Section> sections;
  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] bool linked() const { return sections.at(0).linked; }
};

/// The sections by certificate, each of which has its sections in a row.
[[nodiscard]] std::vector<Certificate> by_certificate(std::vector<Section> sections);

/// From the texts of its sections.
[[nodiscard]] std::string certificate_text(const Certificate& certificate);

/// The text with its last line: how many rows, and two sums of its bytes from which a reader can tell which single byte
/// was altered.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

}  // namespace restrip::generator
