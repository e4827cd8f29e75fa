// Whether two certificates, or two table dumps, have the same rules, or others that cost the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/rule_file.hpp"
#include "operations/description.hpp"

namespace restrip::generator {

/// What one of the files says in a place where they differ.
struct Answer {
  std::optional<RuleLine> rule;    ///< the rule; nothing where the file has none
  std::vector<std::int64_t> cost;  ///< by RulesCompared::criteria, where both have a rule of a valid configuration
  std::string list;                ///< of linked rules the line; where only one file has the place, how many rules
};

/// Where rules differ in cost, or one of the files has none.
struct Difference {
  std::string place;  ///< "split k 5 a 2"
  std::optional<Key>
      asked;  ///< the solid ports, and the joined ones, as far as they are known; nothing: all of the place
  std::optional<Mask> inner;  ///< the inner edges before, in dumps
  Answer a;
  Answer b;
};

struct RulesCompared {
  std::size_t rules = 0;              ///< compared; of linked rules the lines
  std::size_t other = 0;              ///< of them those that are not the same, and whose costs were compared
  std::size_t better_in_a = 0;        ///< those that cost less in the first file
  std::size_t better_in_b = 0;        ///< those that cost less in the second
  std::size_t unmatched = 0;          ///< rules that only one file has, and lines of linked rules that differ
  std::vector<std::string> criteria;  ///< what the costs of `first` count, compared in turn: "isolated + given_up"
  std::optional<Difference> first;    ///< in the order of the first file
};

/// `own` are descriptions beside the shipped families. Throws std::runtime_error where the files do not have the same
/// operation, where rules differ and none of the descriptions has their operation, and where such a rule is no sound
/// recolouring.
[[nodiscard]] RulesCompared compare(const RuleFile& a, const RuleFile& b, const std::vector<Description>& own);

}  // namespace restrip::generator
