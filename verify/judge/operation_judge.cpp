#include "judge/operation_judge.hpp"

#include <fmt/format.h>

namespace restrip::verify {

Keys::Keys(const Operation& operation) : operation_(operation), joinable_(mask_count(operation.ports())) {
  std::vector<PortPairs> joined(joinable_.size());  // by kept ports
  const unsigned most = most_solid(operation.constraint);
  for (Mask inner = 0; inner < mask_count(operation.after.inner_edges()); ++inner)
    if (const auto graph = valid_graph(operation.after, {inner, 0}, most))
      for (Mask kept = 0; kept < joined.size(); ++kept)
        if (valid_graph(operation.after, {inner, kept}, most))
          joined[kept].add(joined_ports(operation.after, *graph, kept));
  for (Mask ports = 0; ports < joinable_.size(); ++ports)
    for (Mask kept = 0; kept <= ports; ++kept)
      if (admissible(operation, ports, kept)) joinable_[ports].add(joined[kept]);
}

std::optional<Key> Keys::key_of(Colors configuration) const {
  const std::optional<SolidGraph> inner =
      valid_graph(operation_.before, configuration, most_solid(operation_.constraint));
  if (!inner) return {};
  const PortPairs joined = joined_ports(operation_.before, *inner, configuration.ports);
  return Key{configuration.ports, joined.both(joinable_[configuration.ports])};
}

bool Keys::sound(const Key& key, Colors recoloring) const {
  const std::optional<SolidGraph> inner = valid_graph(operation_.after, recoloring, most_solid(operation_.constraint));
  return inner && joined_ports(operation_.after, *inner, recoloring.ports).within(key.joined);
}

OperationJudge::OperationJudge(const Operation& operation) : operation_(operation), keys_(operation) {
  if (searched(operation)) definition_.emplace(operation);
}

std::optional<Key> OperationJudge::key_of(Colors configuration) const {
  if (definition_ && !definition_->valid(configuration)) return {};
  return keys_.key_of(configuration);
}

bool OperationJudge::is_sound(Colors configuration, Colors recoloring) const {
  if (!admissible(operation_, configuration.ports, recoloring.ports)) return false;
  if (definition_) return !definition_->refuting_world(configuration, recoloring);
  return keys_.sound(keys_.key_of(configuration).value(), recoloring);
}

Judged OperationJudge::judged(Colors configuration, Colors recoloring) const {
  if (definition_) return definition_->judged(configuration, recoloring);
  if (!admissible(operation_, configuration.ports, recoloring.ports)) return {Verdict::wrong_ports};
  return {is_sound(configuration, recoloring) ? Verdict::right : Verdict::unsound};
}

std::string OperationJudge::explained(Colors configuration, Colors recoloring, const Judged& judged) const {
  std::string text = fmt::format("    before  {}\n    after   {}\n", drawn(operation_.before, configuration),
                                 drawn(operation_.after, recoloring));
  const Mask taken = recoloring.ports & ~configuration.ports;
  const Mask refused = configuration.ports & ~recoloring.ports & ~operation_.may_give_up;
  switch (judged.verdict) {
    case Verdict::right:
      break;
    case Verdict::wrong_ports:
      for (unsigned port = 0; port < operation_.ports(); ++port) {
        if (is_solid(taken, port)) return text + fmt::format("  port {} was dashed and becomes solid\n", port);
        if (is_solid(refused, port)) return text + fmt::format("  port {} must stay but is given up\n", port);
      }
      break;
    case Verdict::unsound: {
      const std::string invalid = invalid_because(operation_.after, recoloring, most_solid(operation_.constraint));
      if (!invalid.empty())
        text += fmt::format("  unsound: {} after\n", invalid);
      else if (definition_)
        text +=
            fmt::format("  unsound: with {}, the solid edges have no cycle before, but one after\n",
                        text_of(definition_->world(definition_->refuting_world(configuration, recoloring).value())));
      else
        text += "  unsound: it joins ports that were not joined before\n";
      if (definition_ && !definition_->best(configuration))
        text += "  no recolouring is sound here; the operation must be allowed to give up more ports\n";
      break;
    }
    case Verdict::not_best: {
      const Candidate better = definition_->best(configuration).value();
      const Criterion& criterion = operation_.cost[judged.criterion];
      text +=
          fmt::format("    better  {}\n  not best: {} is {}, and may be {}\n", drawn(operation_.after, better.colors),
                      text_of(criterion), definition_->cost(configuration, recoloring)[judged.criterion],
                      better.cost[judged.criterion]);
      break;
    }
  }
  return text;
}

}  // namespace restrip::verify
