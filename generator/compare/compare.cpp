#include "compare/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/counted.hpp"
#include "compare/rule_file.hpp"
#include "files/report_output.hpp"
#include "operations/description_file.hpp"
#include "operations/operation_words.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

/// No family of tables has larger fans.
constexpr unsigned largest_fan = 13;

/// "strips", or "isolated + 2 given_up": what a criterion adds up.
std::string words_of(const Criterion& criterion) {
  std::vector<std::string> terms;
  for (const Term& term : criterion) {
    const std::string word(word_of(term.count).word);
    terms.push_back(term.weight == 1 ? word : fmt::format("{} {}", term.weight, word));
  }
  return fmt::format("{}", fmt::join(terms, " + "));
}

/// What is needed to tell what the rules of one place cost.
class Place {
 public:
  Place(Operation operation, bool of_keys)
      : operation_(std::move(operation)),
        of_keys_(of_keys),
        before_(legal_colorings(operation_.patch.before, operation_.constraint)),
        after_(legal_colorings(operation_.patch.after, operation_.constraint)) {}

  [[nodiscard]] const Preference& preference() const { return operation_.preference; }

  /// Of a configuration, as it joins them.
  [[nodiscard]] PortPairs joined(const RuleLine& rule, const std::string& file) const {
    if (of_keys_) return rule.key.joined;
    const Coloring* const before = coloring_of(before_, rule.inner);
    const auto outcome = before == nullptr ? std::nullopt : with_ports(*before, rule.key.ports);
    if (!outcome) refuse(rule, file, "the configuration is not valid");
    return outcome->joined;
  }

  /// Refuses a rule that is no sound recolouring.
  [[nodiscard]] std::vector<std::int64_t> cost(const RuleLine& rule, const std::string& file) const {
    const Mask ports = rule.key.ports;
    if ((rule.kept & ~ports) != 0 || (ports & ~rule.kept & ~operation_.may_give_up) != 0 ||
        ports > operation_.patch.after.all_ports())
      refuse(rule, file, "these ports cannot be kept of those");
    const Coloring* const after = coloring_of(after_, rule.recoloring);
    const auto outcome = after == nullptr ? std::nullopt : with_ports(*after, rule.kept);
    if (!outcome) refuse(rule, file, "the colours after are not valid");
    if (!outcome->joined.within(joined(rule, file))) refuse(rule, file, "the rule is not sound");
    const CriterionValues values = values_of(operation_, *after, *outcome, ports, rule.kept);
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(preference().size())};
  }

 private:
  [[noreturn]] static void refuse(const RuleLine& rule, const std::string& file, const char* what) {
    throw std::runtime_error(
        fmt::format("{}:{}: {} in the operation as it is described; restrip-verify says more", file, rule.line, what));
  }

  Operation operation_;
  bool of_keys_;
  std::vector<Coloring> before_;
  std::vector<Coloring> after_;
};

/// Finds operations by the names that certificates and dumps give their places.
class Places {
 public:
  Places(const std::vector<Description>& own, const RuleFile& like) : like_(like), all_(families()) {
    all_.insert(all_.end(), own.begin(), own.end());
    if (like.is_dump()) {
      for (Description& one : all_) one.listed.clear();  // dumps have all positions
      for (const Description& one : all_)
        for (const Position& position : positions_up_to(one, largest_fan)) found_[name_of(position)] = position;
      return;
    }
    std::erase_if(all_, [&](const Description& one) { return one.certificate != like.operation; });
    if (all_.empty()) return;
    for (const Section& section : sections_of(all_, largest_fan))
      if (!section.linked) found_[position_text(section.position)] = section.position;
  }

  [[nodiscard]] Place at(const std::string& place) const {
    const auto found = found_.find(place);
    if (found == found_.end())
      throw std::runtime_error(
          fmt::format("the rules of {} differ, and what they cost cannot be told: this is no place "
                      "of a shipped family; name the operation file by --operation",
                      name(place)));
    if (like_.is_dump()) return {operation_at(found->second), false};
    return {operation_at(found->second, patch_of_rows(found->second)), true};
  }

  /// As reports name it.
  [[nodiscard]] std::string name(const std::string& place) const {
    return like_.is_dump() || place == like_.operation ? place : like_.operation + " " + place;
  }

 private:
  const RuleFile& like_;
  std::vector<Description> all_;
  std::map<std::string, Position> found_;
};

/// What one of the files says in a place where they differ.
struct Answer {
  const RuleLine* rule = nullptr;       ///< null where the file has none
  std::vector<std::int64_t> cost = {};  ///< where both have a rule of a valid configuration
  std::string list = {};                ///< of linked rules the line; where only one file has the place, how many rules

  [[nodiscard]] std::string text(const std::vector<std::string>& criteria) const {
    if (!list.empty()) return list;
    if (rule == nullptr) return "no rule";
    if (rule->none) return "not valid";
    std::string text = fmt::format("inner edges {:x}, ports kept {:x}", rule->recoloring, rule->kept);
    for (std::size_t i = 0; i < cost.size(); ++i)
      text += fmt::format("{} {} {}", i == 0 ? ":" : ",", criteria.at(i), cost[i]);
    return text;
  }
  [[nodiscard]] nlohmann::ordered_json json() const {
    if (!list.empty()) return list;
    if (rule == nullptr || rule->none) return nullptr;
    nlohmann::ordered_json json{{"inner", fmt::format("{:x}", rule->recoloring)},
                                {"ports", fmt::format("{:x}", rule->kept)}};
    if (!cost.empty()) json["cost"] = cost;
    return json;
  }
};

class Comparer {
 public:
  /// `own` are descriptions beside the shipped families.
  Comparer(const RuleFile& a, const RuleFile& b, const std::vector<Description>& own) : a_(a), b_(b), places_(own, a) {
    if (a.is_dump() != b.is_dump())
      throw std::runtime_error(fmt::format("{} is a certificate and {} a table dump: compare two of one kind",
                                           (a.is_dump() ? b : a).file, (a.is_dump() ? a : b).file));
    if (a.operation != b.operation)
      throw std::runtime_error(fmt::format("{} has rules of {}, and {} rules of {}: compare rules of one operation",
                                           a.file, a.operation, b.file, b.operation));
    std::map<std::string, const RulePart*> in_b;
    for (const RulePart& part : b_.parts) in_b[part.place] = &part;
    if (std::none_of(a_.parts.begin(), a_.parts.end(), [&](const RulePart& part) { return in_b.contains(part.place); }))
      throw std::runtime_error(fmt::format("{} and {} have rules of different operations or positions: {} and {}",
                                           a_.file, b_.file, a_.parts[0].place, b_.parts[0].place));
    for (const RulePart& part : a_.parts) {
      const PartRules of_a = rules_of(a_, part);
      const auto other = in_b.find(part.place);
      if (other == in_b.end()) {
        tell_only(part.place, of_a, true);
        continue;
      }
      const PartRules of_b = rules_of(b_, *other->second);
      compare_rules(part.place, of_a.rules, of_b.rules);
      compare_lists(part.place, of_a.lists, of_b.lists);
      in_b.erase(other);
    }
    for (const RulePart& part : b_.parts)
      if (in_b.contains(part.place)) tell_only(part.place, rules_of(b_, part), false);
  }

  [[nodiscard]] bool differ() const { return !first_.empty(); }

  [[nodiscard]] std::string text() const {
    if (differ())
      return fmt::format(
          "different: {} in both files, {} of them not the same, {} cost less in A, {} in B; {} more in one file "
          "alone\nthe first: {}",
          counted(rules_, "rule"), other_, better_in_a_, better_in_b_, unmatched_, first_);
    return other_ == 0 ? fmt::format("the same {}\n", counted(rules_, "rule"))
                       : fmt::format("other rules that cost the same: {} of {}\n", other_, rules_);
  }
  [[nodiscard]] std::string json() const {
    nlohmann::ordered_json json{{"verdict", differ()     ? "different"
                                            : other_ > 0 ? "same costs"
                                                         : "same rules"},
                                {"rules", rules_},
                                {"other", other_},
                                {"better_in_a", better_in_a_},
                                {"better_in_b", better_in_b_},
                                {"in_one_file", unmatched_}};
    if (differ()) json["first"] = first_json_;
    return json.dump(2) + "\n";
  }

 private:
  /// Where rules differ in cost, or one of the files has none; of such places the first is reported. `asked` and the
  /// joined ports, as far as they are known, say which rule of the place; null: all of them.
  void tell(const std::string& where, const RuleLine* asked, const PortPairs& joined, const Answer& a, const Answer& b,
            const std::vector<std::string>& criteria = {}) {
    if (differ()) return;
    first_ = places_.name(where);
    first_json_ = {{"place", first_}};
    if (asked != nullptr) {
      if (a_.is_dump()) {
        first_ += fmt::format(", inner edges {:x}", asked->inner);
        first_json_["inner"] = fmt::format("{:x}", asked->inner);
      }
      first_ += fmt::format(", ports {:x}", asked->key.ports);
      first_json_["ports"] = fmt::format("{:x}", asked->key.ports);
      first_json_["joined"] = nlohmann::json::array();
      std::vector<std::string> pairs;
      for (const Mask pair : joined.masks()) {
        const std::array<int, 2> ports{std::countr_zero(pair), static_cast<int>(std::bit_width(pair)) - 1};
        pairs.push_back(fmt::format("{}-{}", ports[0], ports[1]));
        first_json_["joined"].push_back(ports);
      }
      first_ += pairs.empty() ? ", none joined" : fmt::format(", joined {}", fmt::join(pairs, " "));
    }
    first_ += fmt::format("\n  A: {}\n  B: {}\n", a.text(criteria), b.text(criteria));
    if (!criteria.empty()) first_json_["criteria"] = criteria;
    first_json_["a"] = a.json();
    first_json_["b"] = b.json();
  }

  void tell_only(const std::string& where, const PartRules& rules, bool in_a) {
    const std::size_t lines = rules.rules.size() + rules.lists.size();
    unmatched_ += lines;
    const Answer answer{nullptr, {}, counted(lines, "rule")};
    tell(where, nullptr, {}, in_a ? answer : Answer{}, in_a ? Answer{} : answer);
  }

  void compare_lists(const std::string& where, const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      const std::string of_a = i < a.size() ? a[i] : std::string();
      const std::string of_b = i < b.size() ? b[i] : std::string();
      if (of_a == of_b) {
        ++rules_;
        continue;
      }
      unmatched_ += (of_a.empty() ? 0U : 1U) + (of_b.empty() ? 0U : 1U);
      tell(where, nullptr, {}, {nullptr, {}, of_a}, {nullptr, {}, of_b});
    }
  }

  void compare_rules(const std::string& where, const std::vector<RuleLine>& a, const std::vector<RuleLine>& b) {
    std::optional<Place> place;
    auto in_a = a.begin();
    auto in_b = b.begin();
    while (in_a != a.end() || in_b != b.end()) {
      const bool a_first = in_b == b.end() || (in_a != a.end() && is_before(*in_a, *in_b));
      const bool b_first = in_a == a.end() || (in_b != b.end() && is_before(*in_b, *in_a));
      if (a_first || b_first) {
        ++unmatched_;
        const RuleLine& one = a_first ? *in_a : *in_b;
        tell(where, &one, one.key.joined, {a_first ? &one : nullptr}, {a_first ? nullptr : &one});
      } else {
        compare_pair(where, *in_a, *in_b, place);
      }
      in_a += b_first ? 0 : 1;
      in_b += a_first ? 0 : 1;
    }
  }

  void compare_pair(const std::string& where, const RuleLine& a, const RuleLine& b, std::optional<Place>& place) {
    ++rules_;
    if (a.none == b.none && a.recoloring == b.recoloring && a.kept == b.kept) return;
    if (a.none != b.none) {
      ++unmatched_;
      tell(where, &a, a.key.joined, {&a}, {&b});
      return;
    }
    ++other_;
    if (!place) place.emplace(places_.at(where));
    const PortPairs joined = place->joined(a, a_.file);
    const Answer in_a{&a, place->cost(a, a_.file)};
    const Answer in_b{&b, place->cost(b, b_.file)};
    if (in_a.cost == in_b.cost) return;
    ++(in_a.cost < in_b.cost ? better_in_a_ : better_in_b_);
    std::vector<std::string> criteria;
    for (const Criterion& criterion : place->preference()) criteria.push_back(words_of(criterion));
    tell(where, &a, joined, in_a, in_b, criteria);
  }

  const RuleFile& a_;
  const RuleFile& b_;
  Places places_;
  std::size_t rules_ = 0;        ///< compared; of linked rules the lines
  std::size_t other_ = 0;        ///< of them those that are not the same, and whose costs were compared
  std::size_t better_in_a_ = 0;  ///< those that cost less in the first file
  std::size_t better_in_b_ = 0;  ///< those that cost less in the second
  std::size_t unmatched_ = 0;    ///< rules that only one file has, and lines of linked rules that differ
  std::string first_;            ///< difference, in the order of the first file
  nlohmann::ordered_json first_json_;
};

}  // namespace

int compare(const CompareOptions& options) {
  const files::ReportOutput out(options.json, {options.a, options.b});
  std::vector<Description> own;
  for (const std::string& file : options.operations)
    for (Description& description : read_descriptions(file)) own.push_back(std::move(description));
  const RuleFile a = read_rule_file(options.a);
  const RuleFile b = read_rule_file(options.b);
  const Comparer compared(a, b, own);
  out.print(compared.text(), compared.json());
  return compared.differ() ? 1 : 0;
}

}  // namespace restrip::generator
