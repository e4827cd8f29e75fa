#include "explain/explanation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/counted.hpp"
#include "model/description.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<std::string_view, 6> standing_names = {"not a configuration", "not valid", "unsound", "worse",
                                                            "equally good",        "best"};

/// Cycles have no cost if joined ports are counted.
bool has_cost(const Operation& operation, Mask inner) {
  const auto needs_forest = [](const Term& term) {
    return term.count == Count::joined || term.count == Count::squares;
  };
  return inner_graph(operation.after, inner).has_value() ||
         std::none_of(operation.cost.begin(), operation.cost.end(), [&](const Criterion& criterion) {
           return std::any_of(criterion.begin(), criterion.end(), needs_forest);
         });
}

/// The obstacle in a recolouring that is not valid in this world: edges are cleared while it stays so.
Obstacle obstacle_in(const Definition& definition, Colors recoloring, unsigned world) {
  const Operation& operation = definition.operation();
  Colors left = recoloring;
  const auto clear = [&](Mask& mask, Mask among) {
    for (unsigned i = 0; i < most_colors; ++i) {
      if (!is_solid(mask & among, i)) continue;
      mask ^= single(i);
      if (definition.valid_after(left, world)) mask ^= single(i);
    }
  };
  clear(left.inner, ~Mask{0});
  clear(left.ports, operation.may_give_up);
  Obstacle obstacle{{left.inner, left.ports & operation.may_give_up}, 0, world, {}, 0};
  clear(left.ports, ~operation.may_give_up);
  obstacle.ports = left.ports & ~operation.may_give_up;
  const Degrees degree = degrees(operation.after, left);
  const auto most = std::max_element(degree.begin(), degree.end()) - degree.begin();
  if (degree[static_cast<std::size_t>(most)] > most_solid(operation.constraint))
    obstacle.triangle = static_cast<unsigned>(most);
  return obstacle;
}

std::string listed_edges(const Side& side, const Obstacle& obstacle) {
  std::string text;
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (is_solid(obstacle.edges.inner, edge))
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", name_of(side, side.edges[edge][0]),
                          name_of(side, side.edges[edge][1]));
  const Mask ports = obstacle.edges.ports | obstacle.ports;
  if (ports != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", solid_count(ports) == 1 ? "port" : "ports");
  for (unsigned port = 0; port < side.ports(); ++port)
    if (is_solid(ports, port)) text += ' ' + port_name(side, port);
  return text;
}

/// What all edges of the obstacle do together.
std::string effect_of(const Definition& definition, const Obstacle& obstacle) {
  const Operation& operation = definition.operation();
  if (obstacle.triangle)
    return fmt::format("triangle {} has {} solid edges", name_of(operation.after, *obstacle.triangle),
                       most_solid(operation.constraint) + 1);
  if (obstacle.world == 0) return "a cycle";
  return fmt::format("a cycle with {}", text_of(definition.world(obstacle.world)));
}

std::string port_fault(const Operation& operation, Mask before, Mask after) {
  for (unsigned port = 0; port < operation.ports(); ++port) {
    if (is_solid(after & ~before, port)) return fmt::format("port {} was dashed and becomes solid", port);
    if (is_solid(before & ~after & ~operation.may_give_up, port))
      return fmt::format("port {} is given up and may not be", port);
  }
  throw std::logic_error("the ports are right");
}

/// Its edges and masks, and what it changes if it is valid.
std::string line_of(const Operation& operation, Colors configuration, Colors after, bool valid) {
  std::string text =
      fmt::format("{}\n          inner {}, ports {}", drawn(operation.after, after), after.inner, after.ports);
  if (!valid) return text + "\n";
  const Change change = change_of(operation, configuration, after);
  return text + fmt::format("; strips {:+}, isolated {:+}\n", change.strips, change.isolated);
}

nlohmann::ordered_json json_of(Colors colors) {
  return {{"inner", fmt::format("{:x}", colors.inner)}, {"ports", fmt::format("{:x}", colors.ports)}};
}

nlohmann::ordered_json json_of(const Operation& operation, Colors configuration, Colors after) {
  nlohmann::ordered_json json = json_of(after);
  const Change change = change_of(operation, configuration, after);
  json["strips"] = change.strips;
  json["isolated"] = change.isolated;
  return json;
}

nlohmann::ordered_json json_of(const Definition& definition, const Obstacle& obstacle) {
  nlohmann::ordered_json json = json_of({obstacle.edges.inner, obstacle.edges.ports | obstacle.ports});
  json["why"] = text_of(definition, obstacle);
  json["world"] = definition.world(obstacle.world).connected;
  json["triangle"] = nullptr;
  if (obstacle.triangle) json["triangle"] = name_of(definition.operation().after, *obstacle.triangle);
  return json;
}

}  // namespace

std::string_view name_of(Standing standing) { return standing_names.at(static_cast<std::size_t>(standing)); }

Operation operation_at(const Description& description, const Numbers& numbers) {
  const std::vector<Numbers> all = description.positions(largest_judged_fan);
  if (numbers.size() != description.numbers.size())
    throw InputError(
        description.file(), 0,
        description.numbers.empty()
            ? fmt::format("{} has no numbers: leave out --k and --at", description.name)
            : fmt::format("{} needs the {} {}: --k gives the first, --at the others", description.name,
                          plural(description.numbers.size(), "number"), fmt::join(description.numbers, ", ")));
  if (std::find(all.begin(), all.end(), numbers) == all.end())
    throw InputError(description.file(), 0,
                     fmt::format("{} has no position ({}) up to {}", description.name, fmt::join(numbers, ", "),
                                 largest_judged_fan));
  Operation operation = description.at(numbers);
  if (!searched(operation))
    throw InputError(description.file(), 0,
                     fmt::format("{} has {} ports, at most {} are searched", operation.name(), operation.ports(),
                                 most_searched_ports));
  return operation;
}

Explanation explanation_of(const Definition& definition, Colors configuration) {
  const Operation& operation = definition.operation();
  Explanation found{configuration, definition.best(configuration), 0, 0, {}};
  std::vector<Colors> cheaper;
  for (Mask kept = 0; kept <= configuration.ports; ++kept) {
    if (!admissible(operation, configuration.ports, kept)) continue;
    for (Mask inner = 0; inner < mask_count(operation.after.inner_edges()); ++inner) {
      const Colors recoloring{inner, kept};
      const bool by_cost = found.best && has_cost(operation, inner);
      const CostValues cost = by_cost ? definition.cost(configuration, recoloring) : CostValues{};
      if (!by_cost || cost < found.best->cost)
        cheaper.push_back(recoloring);
      else if (cost == found.best->cost && !definition.refuting_world(configuration, recoloring))
        ++found.equally_good;
    }
  }
  // Few edges first: what they lack the others mostly lack as well.
  std::stable_sort(cheaper.begin(), cheaper.end(), [](Colors one, Colors other) {
    return solid_count(one.inner) + solid_count(one.ports) < solid_count(other.inner) + solid_count(other.ports);
  });
  found.cheaper = cheaper.size();
  for (const Colors recoloring : cheaper) {
    auto known = std::find_if(found.obstacles.begin(), found.obstacles.end(), [&](const Obstacle& obstacle) {
      return is_subset(obstacle.edges.inner, recoloring.inner) && is_subset(obstacle.edges.ports, recoloring.ports);
    });
    if (known == found.obstacles.end()) {
      const std::optional<unsigned> world = definition.refuting_world(configuration, recoloring);
      if (!world) throw std::logic_error(operation.name() + ": a sound recolouring is better than the best");
      known = found.obstacles.insert(known, obstacle_in(definition, recoloring, *world));
    }
    ++known->excluded;
  }
  return found;
}

Judgement judgement_of(const Definition& definition, Colors configuration, Colors recoloring) {
  const Operation& operation = definition.operation();
  const Judged judged = definition.judged(configuration, recoloring);
  Judgement result;
  result.colors = recoloring;
  if (judged.verdict == Verdict::wrong_ports) {
    result.standing = Standing::not_valid;
    result.because = port_fault(operation, configuration.ports, recoloring.ports);
    return result;
  }
  if (judged.verdict == Verdict::unsound) {
    const unsigned world = definition.refuting_world(configuration, recoloring).value();
    result.standing = world == 0 ? Standing::not_valid : Standing::unsound;
    result.obstacle = obstacle_in(definition, recoloring, world);
    result.because = text_of(definition, *result.obstacle);
    if (result.standing == Standing::unsound) result.because += ", and none before";
    if (!definition.best(configuration)) result.because += "; no recolouring is sound here";
    return result;
  }
  const Candidate& best = definition.best(configuration).value();
  const CostValues cost = definition.cost(configuration, recoloring);
  if (cost < best.cost) throw std::logic_error(operation.name() + ": a sound recolouring is better than the best");
  result.strips_lost = strips_of(operation.after, recoloring) - strips_of(operation.after, best.colors);
  if (judged.verdict == Verdict::not_best) {
    const unsigned i = judged.criterion;
    result.standing = Standing::worse;
    result.because = fmt::format("{} {} above the best", text_of(operation.cost[i]), cost[i] - best.cost[i]);
  } else if (recoloring != best.colors) {
    result.standing = Standing::equally_good;
    result.because = "costs the same as the best; only a tie-break decides between them";
  }
  return result;
}

std::string text_of(const Definition& definition, const Obstacle& obstacle) {
  return fmt::format("{}: {}", listed_edges(definition.operation().after, obstacle), effect_of(definition, obstacle));
}

std::string arguments_of(const Operation& operation, Colors configuration, const std::optional<Colors>& recoloring) {
  std::string text;
  const Numbers& numbers = operation.numbers;
  if (!numbers.empty()) text += fmt::format("--k {} ", numbers.front());
  if (numbers.size() > 1) text += fmt::format("--at {} ", fmt::join(numbers.begin() + 1, numbers.end(), ","));
  text += fmt::format("--before {} --ports {}", configuration.inner, configuration.ports);
  if (!recoloring) return text;
  text += fmt::format(" --after {}", recoloring->inner);
  return recoloring->ports == configuration.ports ? text : text + fmt::format(" --ports-after {}", recoloring->ports);
}

std::string text_of(const Definition& definition, const Explanation& explanation,
                    const std::optional<Judgement>& judged) {
  const Operation& operation = definition.operation();
  std::string text =
      fmt::format("{}\nbefore    {}\n", operation.name(), drawn(operation.before, explanation.configuration));
  if (explanation.best) {
    text += "best      " + line_of(operation, explanation.configuration, explanation.best->colors, true) + "          ";
    text += explanation.equally_good == 1
                ? "every other recolouring is unsound or costs more\n"
                : fmt::format("{} the same; a table may hold any of them\n",
                              counted(explanation.equally_good - 1, "other costs", "others cost"));
  } else {
    text += "best      none: no recolouring is sound; the operation would have to give up more ports\n";
  }
  text += explanation.cheaper == 0 ? "why       no recolouring costs less\n"
                                   : fmt::format("why       {} {}; each has all edges of {} solid:\n",
                                                 counted(explanation.cheaper, "recolouring"),
                                                 explanation.best ? "would cost less" : "in all",
                                                 explanation.obstacles.size() == 1 ? "this set" : "one of these sets");
  std::size_t width = 0;
  for (const Obstacle& obstacle : explanation.obstacles)
    width = std::max(width, listed_edges(operation.after, obstacle).size());
  for (const Obstacle& obstacle : explanation.obstacles)
    text += fmt::format("{:>9} {:<{}}  {}\n", obstacle.excluded, listed_edges(operation.after, obstacle), width,
                        effect_of(definition, obstacle));
  if (!judged) return text;
  text += "yours     " +
          line_of(operation, explanation.configuration, judged->colors, judged->standing > Standing::not_valid);
  return text + fmt::format("verdict   {}{}{}\n", name_of(judged->standing), judged->because.empty() ? "" : ": ",
                            judged->because);
}

nlohmann::ordered_json json_of(const Definition& definition, const Explanation& explanation,
                               const std::optional<Judgement>& judged) {
  const Operation& operation = definition.operation();
  nlohmann::ordered_json json = {{"operation", operation.family},
                                 {"position", operation.numbers},
                                 {"before", json_of(explanation.configuration)},
                                 {"best", nullptr},
                                 {"equally_good", explanation.equally_good},
                                 {"cheaper", explanation.cheaper},
                                 {"sets", nlohmann::ordered_json::array()}};
  if (explanation.best) {
    json["best"] = json_of(operation, explanation.configuration, explanation.best->colors);
    for (std::size_t i = 0; i < operation.cost.size(); ++i)
      json["best"]["cost"].push_back({{"criterion", text_of(operation.cost[i])}, {"value", explanation.best->cost[i]}});
  }
  for (const Obstacle& obstacle : explanation.obstacles) {
    json["sets"].push_back(json_of(definition, obstacle));
    json["sets"].back()["excluded"] = obstacle.excluded;
  }
  if (!judged) return json;
  json["recolouring"] = json_of(operation, explanation.configuration, judged->colors);
  json["verdict"] = name_of(judged->standing);
  json["because"] = judged->because;
  json["obstacle"] = nullptr;
  if (judged->obstacle) json["obstacle"] = json_of(definition, *judged->obstacle);
  return json;
}

}  // namespace restrip::verify
