#pragma once
// Judges the answers of compiled rules in a position that no certificate lists, where they come by a mirror image or a
// half turn of a table. Nothing is taken from the listed position: each answer is held against all recolourings of its
// own patch.

#include <optional>
#include <string>
#include <vector>

#include "judgment.hpp"

namespace restrip::verify {

/// An answer that is wrong.
struct WrongAnswer {
  std::size_t configuration = 0;  ///< concatenated(inner before, ports)
  std::string what;
};

/// `answers` has one for each configuration of a fan, packed, or not_valid. The first wrong one in ascending order of
/// (ports, inner); nullopt when every valid configuration has an answer that is sound and optimal, and no other has
/// one.
std::optional<WrongAnswer> wrong_answer(const Operation& operation, const std::vector<Answer>& answers);

}  // namespace restrip::verify
