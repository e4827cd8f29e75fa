#include "compare/compare_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/counted.hpp"
#include "common/json_option.hpp"
#include "compare/compare.hpp"
#include "files/report_output.hpp"
#include "operations/description_file.hpp"

namespace restrip::generator {
namespace {

struct CompareCommand {
  std::string a;
  std::string b;
  std::vector<std::string> operations;
  std::string json;
};

std::vector<std::vector<int>> pairs_of(const PortPairs& joined) {
  std::vector<std::vector<int>> pairs;
  for (const Mask pair : joined.masks())
    pairs.push_back({std::countr_zero(pair), static_cast<int>(std::bit_width(pair)) - 1});
  return pairs;
}

std::string place_text(const Difference& difference) {
  std::string text = difference.place;
  if (difference.inner) text += fmt::format(", inner edges {:x}", *difference.inner);
  if (!difference.asked) return text;
  text += fmt::format(", ports {:x}", difference.asked->ports);
  std::vector<std::string> pairs;
  for (const std::vector<int>& pair : pairs_of(difference.asked->joined))
    pairs.push_back(fmt::format("{}-{}", pair[0], pair[1]));
  return text + (pairs.empty() ? ", none joined" : fmt::format(", joined {}", fmt::join(pairs, " ")));
}

std::string answer_text(const Answer& answer, const std::vector<std::string>& criteria) {
  if (!answer.list.empty()) return answer.list;
  if (!answer.rule) return "no rule";
  if (answer.rule->none) return "not valid";
  std::string text = fmt::format("inner edges {:x}, ports kept {:x}", answer.rule->recoloring, answer.rule->kept);
  for (std::size_t i = 0; i < answer.cost.size(); ++i)
    text += fmt::format("{} {} {}", i == 0 ? ":" : ",", criteria.at(i), answer.cost[i]);
  return text;
}

std::string as_text(const RulesCompared& found) {
  if (!found.first)
    return found.other == 0 ? fmt::format("the same {}\n", counted(found.rules, "rule"))
                            : fmt::format("other rules that cost the same: {} of {}\n", found.other, found.rules);
  return fmt::format(
      "different: {} in both files, {} of them not the same, {} cost less in A, {} in B; {} more in one file alone\n"
      "the first: {}\n  A: {}\n  B: {}\n",
      counted(found.rules, "rule"), found.other, found.better_in_a, found.better_in_b, found.unmatched,
      place_text(*found.first), answer_text(found.first->a, found.criteria),
      answer_text(found.first->b, found.criteria));
}

nlohmann::ordered_json answer_json(const Answer& answer) {
  if (!answer.list.empty()) return answer.list;
  if (!answer.rule || answer.rule->none) return nullptr;
  nlohmann::ordered_json json{{"inner", fmt::format("{:x}", answer.rule->recoloring)},
                              {"ports", fmt::format("{:x}", answer.rule->kept)}};
  if (!answer.cost.empty()) json["cost"] = answer.cost;
  return json;
}

std::string as_json(const RulesCompared& found) {
  nlohmann::ordered_json json{{"verdict", found.first       ? "different"
                                          : found.other > 0 ? "same costs"
                                                            : "same rules"},
                              {"rules", found.rules},
                              {"other", found.other},
                              {"better_in_a", found.better_in_a},
                              {"better_in_b", found.better_in_b},
                              {"in_one_file", found.unmatched}};
  if (found.first) {
    const Difference& first = *found.first;
    nlohmann::ordered_json difference{{"place", first.place}};
    if (first.inner) difference["inner"] = fmt::format("{:x}", *first.inner);
    if (first.asked) {
      difference["ports"] = fmt::format("{:x}", first.asked->ports);
      difference["joined"] = pairs_of(first.asked->joined);
    }
    if (!found.criteria.empty()) difference["criteria"] = found.criteria;
    difference["a"] = answer_json(first.a);
    difference["b"] = answer_json(first.b);
    json["first"] = difference;
  }
  return json.dump(2) + "\n";
}

int run(const CompareCommand& command) {
  const files::ReportOutput out(command.json, {command.a, command.b});
  std::vector<Description> own;
  for (const std::string& file : command.operations)
    for (Description& description : read_descriptions(file)) own.push_back(std::move(description));
  const RulesCompared found = compare(read_rule_file(command.a), read_rule_file(command.b), own);
  out.print(as_text(found), as_json(found));
  return found.first ? 1 : 0;
}

}  // namespace

Subcommand add_compare(CLI::App& app) {
  const auto kept = std::make_shared<CompareCommand>();
  CompareCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("compare", "Compare the rules of two certificates, or of two table dumps");
  sub->add_option("A", command.a, "A certificate, or what a program prints that dumps its tables")->required();
  sub->add_option("B", command.b, "Another one of the same kind and operation")->required();
  sub->add_option("--operation", command.operations,
                  "Operation file, unless it is a shipped family; of use where rules differ");
  add_json_option(*sub, command.json);
  sub->footer(
      "\nTells whether the rules are the same, or others that cost the same, or which is the first that costs more or\n"
      "less. Lists of linked rules are compared line by line. That rules are the best ones is for restrip-verify to\n"
      "prove. docs/certificate.md describes the files.\n"
      "Exit code: 0 the rules cost the same, 1 they do not, 2 bad input.\n"
      "\nExample:\n"
      "  restrip-generate tables --max-k 5 --out /tmp/strips\n"
      "  restrip-generate tables --max-k 5 --tie-break indices --out /tmp/indices\n"
      "  restrip-generate compare /tmp/strips/certificates/split.cert /tmp/indices/certificates/split.cert\n");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::generator
