#pragma once
// tables/families.json: the families of docs/notation.md as data (docs/operation-file.md, "Families").

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formula.hpp"
#include "patch.hpp"

namespace restrip::verify {

/// One side of the patches of a family: triangles in the order of the ring or path that they form.
struct FamilySide {
  /// A triangle of its own, or t_from … t_(to - 1).
  struct Part {
    std::string name;
    std::optional<std::pair<Sum, Sum>> range;
  };

  bool ring = false;
  std::vector<Part> parts;
  std::optional<std::pair<std::string, std::string>> chord;
  std::vector<std::string> ports;  ///< the triangle of each; empty: t_i has port i

  Patch patch(const Numbers& numbers) const;
};

/// What is claimed of the rules of some positions.
struct FamilyBound {
  Conditions where;
  std::optional<int> strips;
  std::optional<int> isolated;
};

struct FamilyDescription {
  std::string name;
  std::string certificate;  ///< the family of the certificate that has its rules
  std::vector<std::string> numbers;
  Conditions where;
  Conditions listed;
  std::string position;  ///< "k {k} gaps {i} {j}"; empty: there is only one
  std::string section;   ///< the same of the section of the certificate: "k {k}"
  bool keyed_by_inner = false;
  bool gives_ports_up = false;
  bool linked = false;
  FamilySide before;
  FamilySide after;
  std::vector<FamilyBound> at_most;

  /// All its positions, those that are not listed included, in ascending order; fans up to max_k triangles.
  std::vector<Numbers> positions(unsigned max_k) const;
  /// The numbers put in place of their names in braces.
  std::string filled(std::string text, const Numbers& numbers) const;
  /// True when the section does not name some number of the position: one rule for all of these positions.
  bool serves_every_position() const;
};

/// InputError with the line and column, and with what was expected there.
std::vector<FamilyDescription> parse_families(const std::string& file, std::string_view text);

/// The families of the shipped file, in its order.
const std::vector<FamilyDescription>& family_descriptions();

}  // namespace restrip::verify
