#include "dump_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw.hpp"

namespace restrip::verify {
namespace {

/// The recolourings of one slice, and the best merit for each pairing before.
class SliceJudge {
 public:
  SliceJudge(const Operation& operation, Mask ports) : operation_(operation), slice_(slice_of(operation, ports)) {}

  const PortSlice& slice() const { return slice_; }

  /// What is wrong with the answer to a configuration of the slice; empty when nothing is.
  std::string fault(const SurveyedColoring& before, Answer answer) {
    if (answer == not_valid) return before.survey.valid ? "no answer to a valid configuration" : "";
    if (!before.survey.valid)
      return "an answer to a configuration that is not valid: " + fault_of(operation_.before, before.colors);
    const SurveyedColoring* const found = recoloring(answer);
    if (found == nullptr) return "unsound: it makes a dashed port solid";
    const SurveyedColoring& after = *found;
    if (!after.survey.valid) return "unsound: " + fault_of(operation_.after, after.colors);
    const PortPairs joined = before.survey.joined;
    if (!after.survey.joined.within(joined))
      return "unsound: it joins ports that were not joined before: " +
             listed({after.survey.joined.bits & ~joined.bits}, operation_.after.ports());
    const Merit own = merit_of(after.survey, after.colors, slice_.ports);
    const Merit best = best_for(joined);
    if (own == best) return {};
    return fmt::format(
        "not optimal: solid edges {}, isolated triangles {}, ports kept {}, where {}, {} and {} are possible",
        own.solid, -own.fewer_isolated, own.ports_kept, best.solid, -best.fewer_isolated, best.ports_kept);
  }

 private:
  const SurveyedColoring* recoloring(Answer answer) const {
    if (!operation_.gives_ports_up) return &slice_.after[answer];
    const auto found = std::find_if(slice_.after.begin(), slice_.after.end(), [&](const SurveyedColoring& one) {
      return packed(one.colors, operation_) == answer;
    });
    return found == slice_.after.end() ? nullptr : &*found;
  }
  Merit best_for(PortPairs joined) {
    const auto [place, is_new] = best_.try_emplace(joined, Merit{-1, 0, 0});
    if (is_new)
      for (const SurveyedColoring& after : slice_.after)
        if (after.survey.valid && after.survey.joined.within(joined))
          place->second = std::max(place->second, merit_of(after.survey, after.colors, slice_.ports));
    return place->second;
  }

  const Operation& operation_;
  PortSlice slice_;
  std::map<PortPairs, Merit> best_;
};

}  // namespace

std::optional<WrongAnswer> wrong_answer(const Operation& operation, const std::vector<Answer>& answers) {
  for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) {
    SliceJudge judge(operation, ports);
    for (const SurveyedColoring& before : judge.slice().before) {
      const std::size_t place = concatenated(before.colors.inner, ports, operation.before.ports());
      if (const std::string fault = judge.fault(before, answers[place]); !fault.empty())
        return WrongAnswer{place, fmt::format("\n{}  {}", drawn(operation.before, before.colors, "    "), fault)};
    }
  }
  return {};
}

}  // namespace restrip::verify
