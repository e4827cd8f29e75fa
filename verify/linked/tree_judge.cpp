#include "linked/tree_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {

TreeJudge::TreeJudge(const Side& after, const PatchInWorlds& in_worlds, const std::vector<World>& worlds, Mask ports)
    : after_(after),
      in_worlds_(in_worlds),
      worlds_(worlds),
      ports_(ports),
      recolorings_(recolorings_of(after, ports)),
      partners_(worlds.size()) {
  for (std::size_t world = 0; world < worlds.size(); ++world) {
    partners_[world].fill(no_partner);
    for (const std::vector<unsigned>& pair : worlds[world].connected) {
      partners_[world][pair[0]] = pair[1];
      partners_[world][pair[1]] = pair[0];
    }
  }
  // Only the best of the recolourings that are sound in the same worlds can matter.
  std::map<std::vector<bool>, Merit> best;
  for (const Recoloring& recoloring : recolorings_) {
    if (!recoloring.survey.valid) continue;
    const auto [place, is_new] = best.try_emplace(sound_in(recoloring.colors.inner), recoloring.merit);
    if (!is_new) place->second = std::max(place->second, recoloring.merit);
  }
  for (const auto& [sound, merit] : best) choices_.push_back({merit, sound});
  std::stable_sort(choices_.begin(), choices_.end(),
                   [](const Choice& one, const Choice& other) { return one.merit > other.merit; });
}

const std::vector<bool>& TreeJudge::sound_in(Mask inner) {
  const auto [place, is_new] = sound_.try_emplace(inner);
  if (is_new)
    for (std::size_t world = 0; world < worlds_.size(); ++world)
      place->second.push_back(is_subset(worlds_[world].ports, ports_) && in_worlds_.valid({inner, ports_}, world));
  return place->second;
}

TreeJudge::Verdict TreeJudge::judge(const std::vector<Question>& questions, Branch root,
                                    const std::vector<unsigned>& worlds) {
  Verdict verdict;
  Knowledge nothing;
  nothing.possible = worlds;
  descend(questions, root, nothing, verdict);
  return verdict;
}

void TreeJudge::descend(const std::vector<Question>& questions, Branch branch, const Knowledge& known,
                        Verdict& verdict) {
  if (known.possible.empty() || !verdict.fault.empty()) return;  // no outside agrees with these answers
  if (branch.kind == Branch::Kind::none) {
    verdict.fault = "no answer for a possible outside:" + known.text;
    return;
  }
  if (branch.kind == Branch::Kind::leaf) return judge_leaf(branch.number, known, verdict);
  const Question& question = questions.at(branch.number);
  const unsigned port = question.port;
  if (!is_solid(ports_, port) || is_solid(known.asked, port)) {
    verdict.fault = fmt::format("the question is about port {}, which is dashed or known:{}", port, known.text);
    return;
  }
  const auto answered = [&](unsigned partner, const std::string& text) {
    Knowledge more{known.asked | single(port), known.unknown, {}, known.text + text};
    if (partner != no_partner) more.asked |= single(partner);
    for (const unsigned world : known.possible)
      if (partners_[world][port] == partner) more.possible.push_back(world);
    return more;
  };
  descend(questions, question.ends, answered(no_partner, fmt::format(" {} ends", port)), verdict);
  descend(questions, question.unknown,
          {known.asked | single(port), known.unknown | single(port), known.possible,
           known.text + fmt::format(" {} unknown", port)},
          verdict);
  // Unknown ports have no partner.
  for (unsigned other = 0; other < most_partners; ++other)
    if (is_solid(ports_ & ~known.asked, other) && other != port)
      descend(questions, question.back[other], answered(other, fmt::format(" {} comes back through {}", port, other)),
              verdict);
}

void TreeJudge::judge_leaf(Mask inner, const Knowledge& known, Verdict& verdict) {
  ++verdict.leaves;
  const auto fail = [&](const std::string& what) {
    verdict.fault =
        fmt::format("the outside:{}; picked {:x}\n    {}\n  {}", known.text.empty() ? " not asked" : known.text, inner,
                    drawn(after_, {inner, ports_}), what);
  };
  if (inner >= recolorings_.size()) {
    verdict.fault = fmt::format("picked {:x}, which is not a recolouring", inner);
    return;
  }
  const Recoloring& own = recolorings_[inner];
  if (!own.survey.valid) return fail("unsound: " + invalid_because(after_, own.colors, most_solid(Constraint::strips)));
  const std::vector<bool>& sound = sound_in(inner);
  for (const unsigned world : known.possible)
    if (!sound[world]) return fail("unsound with " + text_of(worlds_[world]));
  const Merit merit = own.merit;
  for (const Choice& choice : choices_) {
    if (choice.merit <= merit) return;
    if (!always_unsound(choice, known))
      return fail(fmt::format("not optimal: {} solid edges and {} isolated triangles where {} and {} are safe",
                              merit.solid, -merit.fewer_isolated, choice.merit.solid, -choice.merit.fewer_isolated));
  }
}

/// Whether the choice stays unsound for some possible outside, even if more were known about the ports that were not
/// asked about. Full knowledge leaves the fewest possibilities, so these cases are checked: outsides that agree at the
/// ports that were not asked about, and join none of them with a port that was.
bool TreeJudge::always_unsound(const Choice& choice, const Knowledge& known) const {
  std::map<Partners, bool> unsound;
  const Mask open = ports_ & ~known.asked;
  for (const unsigned world : known.possible) {
    Partners found_out = partners_[world];
    bool mixed = false;
    for (unsigned i = 0; i < most_partners; ++i) {
      if (is_solid(open, i))
        mixed = mixed || (found_out[i] != no_partner && !is_solid(open, found_out[i]));
      else
        found_out[i] = no_partner;
    }
    if (mixed) continue;
    bool& any = unsound[found_out];
    any = any || !choice.sound[world];
  }
  return std::all_of(unsound.begin(), unsound.end(), [](const auto& found) { return found.second; });
}

}  // namespace restrip::verify
