// Certificates and table dumps, read for what rules they have (docs/certificate.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solve/port_pairs.hpp"

namespace restrip::generator {

/// A rule, and what it answers: a key in a certificate, a configuration in a dump.
struct RuleLine {
  Mask inner = 0;     ///< inner edges before; of dumps
  Key key;            ///< in dumps without the joined pairs
  bool none = false;  ///< "-": the configuration is not valid
  Mask recoloring = 0;
  Mask kept = 0;
  std::size_t line = 0;
};

/// By what they answer.
[[nodiscard]] bool is_before(const RuleLine& x, const RuleLine& y);

/// The rules of a section or a table, in ascending order of what they answer.
struct PartRules {
  std::vector<RuleLine> rules;
  std::vector<std::string> lists;  ///< of linked rules the lines, as they stand; then there are no `rules`
};

/// Where a section or a table stands. A dump has millions of entries, so they are read when they are asked for.
struct RulePart {
  std::string place;  ///< as the file names it: "k 5 a 2" in a certificate, "split k 5 a 2" in a dump
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t line = 0;  ///< of its first rule or claim
};

struct RuleFile {
  std::string file;
  std::string text;
  std::string operation;  ///< that a certificate names; empty for a dump
  std::vector<RulePart> parts;
  [[nodiscard]] bool is_dump() const { return operation.empty(); }
};

/// Both throw std::runtime_error with file, line and what was expected; the first also files::FileError.
[[nodiscard]] RuleFile read_rule_file(const std::string& file);
[[nodiscard]] PartRules rules_of(const RuleFile& file, const RulePart& part);

}  // namespace restrip::generator
