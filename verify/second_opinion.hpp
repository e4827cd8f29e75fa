#pragma once
// Compares the two formulations on every configuration, on every (configuration, recolouring) pair, on every optimum.

#include <map>

#include "forbidden_sets.hpp"
#include "judgment.hpp"

namespace restrip::verify {

struct Agreement {
  std::uint64_t configurations = 0;
  std::uint64_t pairs = 0;
  std::uint64_t optima = 0;
  std::uint64_t hitting_set_problems = 0;
  Failures disagreements;
};

class SecondOpinion {
 public:
  explicit SecondOpinion(const Operation& operation);
  void compare(const PortSlice& slice);
  const Agreement& agreement() const { return agreement_; }

 private:
  /// What the forbidden sets say of all configurations of a slice that join the same ports.
  struct Verdict {
    std::vector<bool> legal;  ///< by recolouring
    Merit best;
  };
  Verdict verdict(const PortSlice& slice, PortPairs joined_before) const;
  void compare_pairs(const PortSlice& slice, const SurveyedColoring& configuration, const Verdict& second);
  void disagree(const SurveyedColoring& configuration, const std::string& what);

  const Operation& operation_;
  ForbiddenSets before_;
  ForbiddenSets after_;
  Agreement agreement_;
};

}  // namespace restrip::verify
