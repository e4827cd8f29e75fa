#pragma once
// Judges the answers of compiled rules without a certificate: each answer is held against all recolourings of its own
// patch. That is how the positions are judged that no certificate lists, where the answers come by a mirror image or a
// half turn of a table.

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

/// `answers` has one for each configuration, packed, or not_valid. The first wrong one in ascending order of
/// (ports, inner); nullopt when every valid configuration has an answer that is sound and optimal, and no other has
/// one.
std::optional<WrongAnswer> wrong_answer(const Operation& operation, const std::vector<Answer>& answers);

}  // namespace restrip::verify
