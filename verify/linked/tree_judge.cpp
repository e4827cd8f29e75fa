#include "linked/tree_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/worlds.hpp"

namespace restrip::verify {

TreeJudge::TreeJudge(const Side& after, Mask ports)
    : after_(after), ports_(ports), recolorings_(recolorings_of(after, ports)) {
  const Worlds worlds(Constraint::strips, after.ports());
  for (const World& world : worlds.of(ports)) {
    const PortPairs pairs = pairs_of(world);
    Matching matching{pairs, {}};
    for (unsigned i = 0; i < most_partners; ++i) {
      matching.partner[i] = nobody;
      for (unsigned j = 0; j < most_partners; ++j)
        if (j != i && pairs.has(i, j)) matching.partner[i] = j;
    }
    matchings_.push_back(matching);
  }
  // Only the best of the recolourings with the same pairing can matter; and none that joins more than one as good.
  std::map<PortPairs, Merit> best;
  for (const Recoloring& recoloring : recolorings_) {
    if (!recoloring.survey.valid) continue;
    const auto [place, is_new] = best.try_emplace(recoloring.survey.joined, recoloring.merit);
    if (!is_new) place->second = std::max(place->second, recoloring.merit);
  }
  for (const auto& one : best) {
    const bool covered = std::any_of(best.begin(), best.end(), [&](const auto& other) {
      return other.first != one.first && other.first.within(one.first) && other.second >= one.second;
    });
    if (!covered) choices_.push_back({one.second, one.first, sound_beside(one.first)});
  }
  std::stable_sort(choices_.begin(), choices_.end(),
                   [](const Choice& one, const Choice& other) { return one.merit > other.merit; });
}

std::vector<bool> TreeJudge::sound_beside(PortPairs joined) const {
  std::vector<bool> sound;
  for (const Matching& outside : matchings_) sound.push_back(!close_a_cycle(joined, outside.pairs, after_.ports()));
  return sound;
}

TreeJudge::Verdict TreeJudge::judge(const std::vector<Question>& questions, Branch root, PortPairs joined_before) {
  Verdict verdict;
  Knowledge nothing;
  for (unsigned q = 0; q < matchings_.size(); ++q)
    if (!close_a_cycle(joined_before, matchings_[q].pairs, after_.ports())) nothing.possible.push_back(q);
  descend(questions, root, nothing, verdict);
  return verdict;
}

void TreeJudge::descend(const std::vector<Question>& questions, Branch branch, const Knowledge& known,
                        Verdict& verdict) {
  if (known.possible.empty() || !verdict.fault.empty()) return;  // no outside is like that
  if (branch.kind == Branch::Kind::none) {
    verdict.fault = "nothing is said for an outside that can be:" + known.text;
    return;
  }
  if (branch.kind == Branch::Kind::leaf) return judge_leaf(branch.number, known, verdict);
  const Question& question = questions.at(branch.number);
  const unsigned port = question.port;
  if (!is_solid(ports_, port) || is_solid(known.asked, port)) {
    verdict.fault = fmt::format("port {} is asked about, which is dashed or known:{}", port, known.text);
    return;
  }
  const auto answered = [&](unsigned partner, const std::string& text) {
    Knowledge more{known.asked | single(port), known.unknown, {}, known.text + text};
    if (partner != nobody) more.asked |= single(partner);
    for (const unsigned q : known.possible)
      if (matchings_[q].partner[port] == partner) more.possible.push_back(q);
    return more;
  };
  descend(questions, question.ends, answered(nobody, fmt::format(" {} ends", port)), verdict);
  descend(questions, question.unknown,
          {known.asked | single(port), known.unknown | single(port), known.possible,
           known.text + fmt::format(" {} unknown", port)},
          verdict);
  // What sees nothing is seen by nothing.
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
    verdict.fault = fmt::format("picked {:x}, which is no recolouring", inner);
    return;
  }
  const Recoloring& own = recolorings_[inner];
  if (!own.survey.valid) return fail("unsound: " + invalid_because(after_, own.colors, most_solid(Constraint::strips)));
  const auto [place, is_new] = sound_.try_emplace(own.survey.joined);
  if (is_new) place->second = sound_beside(own.survey.joined);
  for (const unsigned q : known.possible)
    if (!place->second[q])
      return fail("unsound where strips outside join " + listed(matchings_[q].pairs, after_.ports()));
  const Merit merit = own.merit;
  for (const Choice& choice : choices_) {
    if (choice.merit <= merit) return;
    if (!always_unsound(choice, known))
      return fail(fmt::format("not optimal: {} solid edges and {} isolated triangles where {} and {} are safe",
                              merit.solid, -merit.fewer_isolated, choice.merit.solid, -choice.merit.fewer_isolated));
  }
}

/// Whatever else might be found out about the ports that were not asked about: is the choice still unsound beside
/// something possible? The least is left possible when all of it is found out, so these cases are looked at: outsides
/// that are equal at the ports that were not asked about, and join none of them with a port that was.
bool TreeJudge::always_unsound(const Choice& choice, const Knowledge& known) const {
  std::map<std::array<unsigned, most_partners>, bool> unsound;
  const Mask open = ports_ & ~known.asked;
  for (const unsigned q : known.possible) {
    std::array<unsigned, most_partners> found_out = matchings_[q].partner;
    bool mixed = false;
    for (unsigned i = 0; i < most_partners; ++i) {
      if (is_solid(open, i))
        mixed = mixed || (found_out[i] != nobody && !is_solid(open, found_out[i]));
      else
        found_out[i] = nobody;
    }
    if (mixed) continue;
    bool& any = unsound[found_out];
    any = any || !choice.sound[q];
  }
  return std::all_of(unsound.begin(), unsound.end(), [](const auto& found) { return found.second; });
}

}  // namespace restrip::verify
