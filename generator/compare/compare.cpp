#include "compare/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "common/counted.hpp"
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
    const std::string word = word_of(term.count).word;
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
    const auto outcome = outcome_of(before_, rule.inner, rule.key.ports);
    if (!outcome) refuse(rule, file, "the configuration is not valid");
    return outcome->second.joined;
  }

  /// Refuses a rule that is no sound recolouring.
  [[nodiscard]] std::vector<std::int64_t> cost(const RuleLine& rule, const std::string& file) const {
    const Mask ports = rule.key.ports;
    if ((rule.kept & ~ports) != 0 || (ports & ~rule.kept & ~operation_.may_give_up) != 0 ||
        ports > operation_.patch.after.all_ports())
      refuse(rule, file, "these ports cannot be kept of those");
    const auto outcome = outcome_of(after_, rule.recoloring, rule.kept);
    if (!outcome) refuse(rule, file, "the colours after are not valid");
    if (!outcome->second.joined.within(joined(rule, file))) refuse(rule, file, "the rule is not sound");
    const CriterionValues values = values_of(operation_, *outcome->first, outcome->second, ports, rule.kept);
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(preference().size())};
  }

 private:
  using Colored = std::pair<const Coloring*, Outcome>;

  [[nodiscard]] static std::optional<Colored> outcome_of(const std::vector<Coloring>& legal, Mask inner, Mask ports) {
    const auto found = std::lower_bound(legal.begin(), legal.end(), inner,
                                        [](const Coloring& one, Mask wanted) { return one.inner < wanted; });
    if (found == legal.end() || found->inner != inner) return std::nullopt;
    const auto outcome = with_ports(*found, ports);
    if (!outcome) return std::nullopt;
    return Colored{&*found, *outcome};
  }

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

class Comparer {
 public:
  Comparer(const RuleFile& a, const RuleFile& b, const std::vector<Description>& own) : a_(a), b_(b), places_(own, a) {}

  RulesCompared run() {
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
    return std::move(found_);
  }

 private:
  void tell(Difference difference) {
    if (!found_.first) found_.first = std::move(difference);
  }

  void tell_only(const std::string& where, const PartRules& rules, bool in_a) {
    Difference difference{places_.name(where), {}, {}, {}, {}};
    const std::size_t lines = rules.rules.size() + rules.lists.size();
    (in_a ? difference.a : difference.b).list = counted(lines, "rule");
    found_.unmatched += lines;
    tell(std::move(difference));
  }

  void compare_lists(const std::string& where, const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      const std::string of_a = i < a.size() ? a[i] : std::string();
      const std::string of_b = i < b.size() ? b[i] : std::string();
      if (of_a == of_b) {
        ++found_.rules;
        continue;
      }
      found_.unmatched += (of_a.empty() ? 0U : 1U) + (of_b.empty() ? 0U : 1U);
      tell({places_.name(where), {}, {}, {{}, {}, of_a}, {{}, {}, of_b}});
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
        ++found_.unmatched;
        const RuleLine& one = a_first ? *in_a : *in_b;
        Difference difference = difference_at(where, one, one.key.joined);
        (a_first ? difference.a : difference.b).rule = one;
        tell(std::move(difference));
      } else {
        compare_pair(where, *in_a, *in_b, place);
      }
      in_a += b_first ? 0 : 1;
      in_b += a_first ? 0 : 1;
    }
  }

  void compare_pair(const std::string& where, const RuleLine& a, const RuleLine& b, std::optional<Place>& place) {
    ++found_.rules;
    if (a.none == b.none && a.recoloring == b.recoloring && a.kept == b.kept) return;
    Difference difference = difference_at(where, a, a.key.joined);
    difference.a = {a, {}, {}};
    difference.b = {b, {}, {}};
    if (a.none != b.none) {
      ++found_.unmatched;
    } else {
      ++found_.other;
      if (!place) place.emplace(places_.at(where));
      difference.asked->joined = place->joined(a, a_.file);
      difference.a.cost = place->cost(a, a_.file);
      difference.b.cost = place->cost(b, b_.file);
      if (difference.a.cost == difference.b.cost) return;
      ++(difference.a.cost < difference.b.cost ? found_.better_in_a : found_.better_in_b);
      if (!found_.first)
        for (const Criterion& criterion : place->preference()) found_.criteria.push_back(words_of(criterion));
    }
    tell(std::move(difference));
  }

  [[nodiscard]] Difference difference_at(const std::string& where, const RuleLine& at, const PortPairs& joined) const {
    Difference difference{places_.name(where), Key{at.key.ports, joined}, {}, {}, {}};
    if (a_.is_dump()) difference.inner = at.inner;
    return difference;
  }

  const RuleFile& a_;
  const RuleFile& b_;
  Places places_;
  RulesCompared found_;
};

}  // namespace

RulesCompared compare(const RuleFile& a, const RuleFile& b, const std::vector<Description>& own) {
  if (a.is_dump() != b.is_dump())
    throw std::runtime_error(fmt::format("{} is a certificate and {} a table dump: compare two of one kind",
                                         (a.is_dump() ? b : a).file, (a.is_dump() ? a : b).file));
  if (a.operation != b.operation)
    throw std::runtime_error(fmt::format("{} has rules of {}, and {} rules of {}: compare rules of one operation",
                                         a.file, a.operation, b.file, b.operation));
  return Comparer(a, b, own).run();
}

}  // namespace restrip::generator
