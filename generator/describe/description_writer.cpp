#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "describe/description_file.hpp"
#include "describe/tie_break.hpp"

namespace restrip::generator {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson places(Mask mask) {
  OrderedJson list = OrderedJson::array();
  for (unsigned i = 0; mask >> i != 0; ++i)
    if ((mask >> i & 1U) != 0) list.push_back(i);
  return list;
}

OrderedJson json_of(const Side& side) {
  OrderedJson edges = OrderedJson::array();
  for (const auto& [u, v] : side.edges) edges.push_back({u, v});
  return {{"triangles", side.nodes}, {"edges", edges}, {"ports", side.owner}};
}

OrderedJson json_of(const Preference& preference, const Side& after) {
  OrderedJson criteria = OrderedJson::array();
  for (const Criterion& criterion : preference) {
    OrderedJson terms = OrderedJson::array();
    for (const Term& term : criterion) {
      const std::string_view among = count_among.at(static_cast<std::size_t>(term.count));
      OrderedJson json{{"count", count_words.at(static_cast<std::size_t>(term.count))}};
      if (term.weight != 1) json["weight"] = term.weight;
      const Mask all = (Mask{1} << how_many(among, after)) - 1;
      if ((term.of & all) != all) json[fmt::format("{}s", among)] = places(term.of & all);
      terms.push_back(json);
    }
    criteria.push_back(terms);
  }
  return criteria;
}

}  // namespace

std::string operation_file_text(const Position& position, Constraint constraint) {
  Operation operation = operation_at(position);
  std::string name = position.family->name;
  for (std::size_t i = 0; i < position.family->numbers.size(); ++i)
    name += fmt::format("-{}{}", position.family->numbers[i], position.numbers().at(i));
  if (constraint.most_edges != operation.constraint.most_edges) {
    operation.constraint = constraint;
    operation.preference.clear();
    name += fmt::format("-{}", constraint_words.at(constraint.most_edges - 1));
  } else if (Criterion terms = tie_break(position, operation.patch.after); !terms.empty()) {
    operation.preference.push_back(std::move(terms));
  }
  if (name == position.family->name) name += "-own";  // restrip's tables use the name of the family itself
  OrderedJson json{{"restrip_operation", 1}, {"name", name}};
  json["constraint"] = constraint_words.at(operation.constraint.most_edges - 1);
  json["before"] = json_of(operation.patch.before);
  json["after"] = json_of(operation.patch.after);
  const Mask all = operation.patch.before.all_ports();
  if (operation.may_give_up != 0)
    json["give_up"] = operation.may_give_up == all ? OrderedJson("all") : places(operation.may_give_up);
  if (!operation.preference.empty()) json["cost"] = json_of(operation.preference, operation.patch.after);
  // One member a line.
  std::string text;
  for (const auto& [member, value] : json.items())
    text += fmt::format("{}  {}: {}", text.empty() ? "{\n" : ",\n", OrderedJson(member).dump(), value.dump());
  return text + "\n}\n";
}

}  // namespace restrip::generator
