#pragma once
// How the cases of an arc and of a following letter combine, observed in all short arcs.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automaton/arc.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// An arc followed by a letter.
struct ArcJoint {
  bool sound = false;
  std::size_t arc_case = 0;
  friend bool operator==(const ArcJoint&, const ArcJoint&) = default;
};

/// The combination of the cases of an arc and a following letter, observed in all colourings of all words of up to
/// `longest` letters. It is a failure if two colourings with the same cases disagree in the case of the whole, its cost
/// or its soundness, or if the longest words show a new combination.
class ArcJoints {
 public:
  explicit ArcJoints(std::size_t longest);

  /// Empty if links of different colours meet.
  const std::optional<ArcJoint>& at(std::size_t arc_case, std::size_t own_case, char letter) const {
    return joints_[place(arc_case, own_case, letter)];
  }
  std::uint64_t colorings() const { return colorings_; }
  const Failures& failures() const { return failures_; }

 private:
  static std::size_t place(std::size_t arc_case, std::size_t own_case, char letter) {
    return 2 * (case_count * arc_case + own_case) + (is_joined(letter) ? 1U : 0U);
  }
  void observe(const std::string& word, Mask links, bool may_be_new);

  std::vector<std::optional<ArcJoint>> joints_;
  std::uint64_t colorings_ = 0;
  Failures failures_;
};

}  // namespace restrip::verify
