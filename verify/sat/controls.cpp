#include "sat/controls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "model/coloring.hpp"

namespace restrip::verify::sat {
namespace {

constexpr std::size_t lines_cut = 4;

Mask mask_of(const std::vector<Literal>& literals, const std::vector<bool>& model) {
  Mask mask = 0;
  for (unsigned i = 0; i < literals.size(); ++i)
    if (model[static_cast<std::size_t>(literals[i])]) mask |= single(i);
  return mask;
}

}  // namespace

Counterexample read_back(const Encoding& encoding, const std::vector<bool>& model) {
  return {{mask_of(encoding.before, model), mask_of(encoding.ports, model)},
          {mask_of(encoding.after, model), mask_of(encoding.ports_after, model)}};
}

std::string objection(const Operation& operation, const Counterexample& found, const Bound& bound) {
  const Survey before = survey(operation.before, found.before);
  if (!before.valid) return "the configuration is not valid";
  if (!has_key(bound, found.before.ports, before.joined)) return "the configuration has another key";
  const Survey after = survey(operation.after, found.after);
  if (!after.valid) return "the recolouring is not valid";
  if (!is_subset(found.after.ports, found.before.ports)) return "the recolouring makes a dashed port solid";
  if (operation.may_give_up == 0 && found.after.ports != found.before.ports) return "the recolouring changes a port";
  if (!after.joined.within(before.joined)) return "the recolouring joins ports that were not joined before";
  const auto kept = static_cast<int>(solid_count(found.after.ports));
  const int given_up = static_cast<int>(solid_count(found.before.ports)) - kept;
  const int solid = static_cast<int>(solid_count(found.after.inner)) + (operation.may_give_up != 0 ? kept : 0);
  const std::array own = {solid, -static_cast<int>(after.isolated) - given_up, kept};
  if (own <= std::array{bound.solid, -bound.isolated, bound.kept}) return "the recolouring is no better than the bound";
  return {};
}

std::vector<Alteration> alterations(const Position& position, const std::vector<Bound>& bounds, std::size_t row) {
  std::vector<Alteration> result;
  const auto alter = [&](const char* what, int solid, int isolated, int kept) {
    std::vector<Bound> altered = bounds;
    altered[row].solid -= solid;
    altered[row].isolated += isolated;
    altered[row].kept -= kept;
    const Bound beaten = altered[row];
    result.push_back({what, std::move(altered), beaten});
  };
  alter("one solid edge less claimed", 1, 0, 0);
  alter("one isolated triangle more claimed", 0, 1, 0);
  if (position.gives_ports_up) alter("one port less kept", 0, 0, 1);
  result.push_back({"row left out", bounds, bounds[row]});
  result.back().bounds.erase(result.back().bounds.begin() + static_cast<std::ptrdiff_t>(row));
  result.back().beaten.solid = -1;  // nothing is claimed, so whatever is sound will do
  return result;
}

Encoding with_key_as_facts(const Position& position, const Alteration& alteration) {
  Encoding encoding = encode(position, {alteration.beaten});
  const auto put_in = [&](const std::vector<Literal>& literals, Mask mask) {
    for (unsigned i = 0; i < literals.size(); ++i)
      encoding.cnf.clauses.push_back({is_solid(mask, i) ? literals[i] : -literals[i]});
  };
  put_in(encoding.ports, alteration.beaten.key.ports);
  const Bound& bound = alteration.beaten;
  for (unsigned j = 0; j < encoding.joined.size(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (bound.matter.has(i, j))
        encoding.cnf.clauses.push_back({bound.key.joined.has(i, j) ? encoding.joined[j][i] : -encoding.joined[j][i]});
  return encoding;
}

Proof without_step(const Proof& proof, std::size_t step) {
  Proof cut = proof;
  const Clause clause = cut[step].clause;
  cut.erase(cut.begin() + static_cast<std::ptrdiff_t>(step));
  const auto deletion =
      std::find_if(cut.begin() + static_cast<std::ptrdiff_t>(step), cut.end(), [&](const ProofStep& s) {
        return s.deletes && std::is_permutation(s.clause.begin(), s.clause.end(), clause.begin(), clause.end());
      });
  if (deletion != cut.end()) cut.erase(deletion);
  return cut;
}

void cut_proof(const Cnf& cnf, const Proof& proof, const ProofVerdict& verdict, ControlResult& result) {
  const std::vector<std::size_t>& core = verdict.core;
  const Proof endless(proof.begin(), proof.begin() + static_cast<std::ptrdiff_t>(core.back()));
  if (check_proof(cnf, endless).proved) result.fault = "a proof without the empty clause was accepted";
  if (core.size() == 1) return;  // the formula fails by unit propagation alone
  if (check_proof(cnf, {proof[core.back()]}).proved)
    result.fault = "a proof of nothing but the empty clause was accepted";
  const std::size_t lemmas = core.size() - 1;
  const std::size_t cuts = std::min(lines_cut, lemmas);
  for (std::size_t i = 0; i < cuts; ++i) {
    ++result.cut_proofs;
    if (!check_proof(cnf, without_step(proof, core[i * lemmas / cuts])).proved) ++result.refused;
  }
}

}  // namespace restrip::verify::sat
