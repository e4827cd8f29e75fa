// Sums of the numbers of a position, and conditions on them, in the notation of operation files
// (docs/reference/operation-file.md, "Families").
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::verify {

/// Values of the numbers of a family, in the order in which it names them.
using Numbers = std::vector<unsigned>;

/// "2 a + 1", "k - 3".
class Sum {
 public:
  /// Throws std::invalid_argument with a sentence if the text is not a sum of these numbers.
  Sum(std::string_view text, const std::vector<std::string>& names);
  std::int64_t of(const Numbers& numbers) const;

 private:
  std::int64_t constant_ = 0;
  std::vector<std::int64_t> factors_;  ///< one for each number
};

/// "k >= 3, 1 <= a < k". Without conditions, every position qualifies.
class Conditions {
 public:
  Conditions() = default;
  /// Throws std::invalid_argument, as above.
  Conditions(std::string_view text, const std::vector<std::string>& names);
  bool hold(const Numbers& numbers) const;

 private:
  struct Comparison {
    Sum left;
    std::string_view sign;
    Sum right;
  };
  std::vector<Comparison> all_;
};

}  // namespace restrip::verify
