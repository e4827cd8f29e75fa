// The patches of docs/reference/notation.md, written by hand: triangles t_0 …, then A, then D. Rows, symmetries, claims
// and text of certificates; text of dumps.

#include "naive_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace restrip::verify::test {
namespace {

/// Triangles in their order around or along the fan.
using Order = std::vector<unsigned>;

Side fan_side(unsigned k, const Order& order, bool closed, bool chord) {
  Side side;
  side.triangles = static_cast<unsigned>(order.size());
  for (unsigned port = 0; port < k; ++port) {
    side.owner_of_port.push_back(port);
    side.names.push_back(fmt::format("t{}", port));
  }
  if (order.size() > k) side.names.emplace_back("A");
  if (order.size() > k + 1) side.names.emplace_back("D");
  for (std::size_t i = 0; i + 1 < order.size(); ++i) side.edges.push_back({order[i], order[i + 1]});
  if (closed) side.edges.push_back({order.back(), order.front()});
  if (chord) side.edges.push_back({k, k + 1});
  return side;
}

/// A precedes the triangle of its gap, and D, if it exists, the triangle of its gap.
Order order_with(unsigned k, std::optional<unsigned> gap_of_a, std::optional<unsigned> gap_of_d) {
  Order order;
  for (unsigned i = 0; i <= k; ++i) {
    if (gap_of_a == i) order.push_back(k);
    if (gap_of_d == i) order.push_back(k + 1);
    if (i < k) order.push_back(i);
  }
  return order;
}

/// Orbits of all configurations and of valid ones, by collecting the smallest member of each.
std::pair<long, long> orbits(const NaiveOperation& operation) {
  const std::vector<NaiveSymmetry> group = operation.symmetries(true);
  std::set<NaiveColors> all;
  std::set<NaiveColors> valid;
  for (const NaiveColors& configuration : operation.configurations()) {
    NaiveColors smallest = configuration;
    for (const NaiveSymmetry& symmetry : group)
      smallest = std::min(smallest, operation.moved(symmetry, false, configuration));
    all.insert(smallest);
    if (operation.valid(false, configuration)) valid.insert(smallest);
  }
  return {static_cast<long>(all.size()), static_cast<long>(valid.size())};
}

void add_claims(const NaiveSection& section, NaiveTable& table) {
  long configurations = 0;
  long all_orbits = 0;
  long valid_orbits = 0;
  for (const NaiveOperation& operation : section.operations) {
    configurations += static_cast<long>(operation.configurations().size());
    const auto [all, valid] = orbits(operation);
    all_orbits += all;
    valid_orbits += valid;
  }
  const bool matching = section.operations.front().operation().constraint == Constraint::matching;
  long costing = 0;
  std::vector<long> strips;
  std::vector<long> isolated;
  for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
    const NaiveColors after = table.rows.at(operation.key(before)).after;
    strips.push_back(operation.change(after, before, Count::strips));
    isolated.push_back(operation.change(after, before, Count::isolated));
    costing += (matching ? isolated : strips).back() > 0 ? 1 : 0;
  });
  table.claims = {{"configurations", configurations},
                  {"valid", static_cast<long>(strips.size())},
                  {"orbits", all_orbits},
                  {"valid-orbits", valid_orbits},
                  {"keys", static_cast<long>(table.rows.size())},
                  {"costing", costing},
                  {"worst-strips", *std::max_element(strips.begin(), strips.end())},
                  {"worst-isolated", *std::max_element(isolated.begin(), isolated.end())}};
}

/// The inverse permutation.
std::vector<int> inverse(const std::vector<int>& permutation) {
  std::vector<int> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i)
    result[static_cast<std::size_t>(permutation[i])] = static_cast<int>(i);
  return result;
}

}  // namespace

Operation operation_by_hand(const std::string& name, const std::vector<unsigned>& position) {
  Operation operation;
  operation.family = name;
  operation.numbers = position;
  operation.cost = {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
  if (name == "flip") {
    operation.before = {2, {{0, 1}}, {0, 0, 1, 1}, {}, {}, {}};
    operation.after = {2, {{0, 1}}, {1, 0, 0, 1}, {}, {}, {}};
    operation.may_give_up = 15;
    return operation;
  }
  const unsigned k = position.at(0);
  const bool closed = name == "split" || name == "collapse";
  const bool one_triangle = name.starts_with("boundary");
  const unsigned a = closed ? 0 : position.at(1);
  const auto d = one_triangle ? std::nullopt : std::optional(position.at(closed ? 1 : 2));
  operation.before = fan_side(k, order_with(k, {}, {}), closed, false);
  operation.after = fan_side(k, order_with(k, a, d), closed, !one_triangle);
  if (!name.ends_with("split")) std::swap(operation.before, operation.after);
  operation.position = closed         ? fmt::format("k {} a {}", k, position[1])
                       : one_triangle ? fmt::format("k {} gap {}", k, a)
                                      : fmt::format("k {} gaps {} {}", k, a, *d);
  return operation;
}

std::vector<NaiveFamily> naive_families(int max_k) {
  const auto at = [](const std::string& name, const std::vector<unsigned>& position) {
    return NaiveOperation(operation_by_hand(name, position));
  };
  NaiveFamily split{"split", {}};
  NaiveFamily collapse{"collapse", {}};
  NaiveFamily open_split{"open-split", {}};
  NaiveFamily boundary_split{"boundary-split", {}};
  NaiveFamily fan_collapse{"fan-collapse", {}};
  for (unsigned k = 1; k <= static_cast<unsigned>(max_k); ++k) {
    const std::string all_of_k = fmt::format("k {}", k);
    if (k >= 3) collapse.sections.push_back({all_of_k, true, {}});
    for (unsigned a = 1; a <= k / 2 && k >= 3; ++a) {
      split.sections.push_back({fmt::format("k {} a {}", k, a), false, {at("split", {k, a})}});
      collapse.sections.back().operations.push_back(at("collapse", {k, a}));
    }
    fan_collapse.sections.push_back({all_of_k, true, {}});
    for (unsigned i = 0; i <= k; ++i)
      for (unsigned j = i + 1; i + j <= k; ++j) {
        open_split.sections.push_back({fmt::format("k {} gaps {} {}", k, i, j), false, {at("open-split", {k, i, j})}});
        fan_collapse.sections.back().operations.push_back(at("open-collapse", {k, i, j}));
      }
    for (unsigned i = 0; i <= k / 2; ++i) {
      boundary_split.sections.push_back({fmt::format("k {} gap {}", k, i), false, {at("boundary-split", {k, i})}});
      fan_collapse.sections.back().operations.push_back(at("boundary-collapse", {k, i}));
    }
  }
  return {split, collapse, open_split, boundary_split, fan_collapse, {"flip", {{"flip", false, {at("flip", {})}}}}};
}

NaiveSection naive_section(const Operation& operation) {
  return {operation.family, false, {NaiveOperation(operation)}};
}

void for_each_valid(const NaiveSection& section, const std::function<void(const NaiveOperation&, NaiveColors)>& visit) {
  for (const NaiveOperation& operation : section.operations)
    for (const NaiveColors& configuration : operation.configurations())
      if (operation.valid(false, configuration)) visit(operation, configuration);
}

std::optional<NaiveTable> naive_table(const std::string& family, const NaiveSection& section, bool with_reasons) {
  NaiveTable table{family, section.position, {}, {}};
  std::map<NaiveKey, std::pair<const NaiveOperation*, NaiveColors>> examples;
  for_each_valid(section, [&](const NaiveOperation& operation, NaiveColors before) {
    examples.try_emplace(operation.key(before), &operation, before);
  });
  const NaiveOperation& first = section.operations.front();
  const std::vector<NaiveSymmetry> group = first.symmetries(!section.serves_every_position);
  // Keys in ascending order: the first of an orbit is searched for, the others are its images.
  for (const auto& [key, example] : examples) {
    if (table.rows.contains(key)) continue;
    const auto& [operation, before] = example;
    const std::vector<NaiveCandidate> candidates = operation->sound(before);
    if (candidates.empty()) return {};
    const auto best = std::min_element(candidates.begin(), candidates.end(),
                                       [](const auto& one, const auto& other) { return one.cost < other.cost; });
    NaiveRow rule{best->after, {}, {}};
    if (with_reasons) rule.because = naive_reason(*operation, before, rule.after).value();
    table.rows[key] = rule;
    for (const NaiveSymmetry& symmetry : group)
      if (const NaiveKey image = first.moved(symmetry, key); examples.contains(image))
        table.rows.try_emplace(image, NaiveRow{first.moved(symmetry, true, rule.after), inverse(symmetry.ports), {}});
  }
  add_claims(section, table);
  return table;
}

std::string text_of(NaiveKey key, const NaiveRow& row) {
  const std::string masks = fmt::format("{:x} {:x} {:x} {:x}", key.first, key.second, row.after.inner, row.after.ports);
  if (!row.by.empty()) return fmt::format("copy {} by {}", masks, fmt::join(row.by, " "));
  return fmt::format("rule {}{}{}", masks, row.because.empty() ? "" : " because ", row.because);
}

std::string certificate_text(const std::string& family, const std::vector<NaiveTable>& tables) {
  std::string text = fmt::format("restrip-certificate 3\noperation {}\n", family);
  std::size_t rows = 0;
  for (const NaiveTable& table : tables) {
    text += fmt::format("section {}\n", table.position);
    for (const auto& [word, number] : table.claims) text += fmt::format("claim {} {}\n", word, number);
    for (const auto& [key, row] : table.rows) text += text_of(key, row) + '\n';
    rows += table.rows.size();
  }
  return with_end(text, rows);
}

NaiveAnswers answers_of(const NaiveOperation& operation, const NaiveTable& table) {
  return [&](NaiveColors configuration) -> std::optional<NaiveColors> {
    if (!operation.valid(false, configuration)) return {};
    return table.rows.at(operation.key(configuration)).after;
  };
}

std::string table_text(const NaiveOperation& operation, const NaiveAnswers& answers, bool with_isolated) {
  std::string text = fmt::format("table {}\n", operation.operation().name());
  for (const NaiveColors& configuration : operation.configurations()) {
    if (operation.operation().constraint == Constraint::matching && configuration.inner != 0) break;
    text += fmt::format("{:x} {:x} ", configuration.inner, configuration.ports);
    if (const std::optional<NaiveColors> after = answers(configuration)) {
      text += fmt::format("{:x} {:x} {}", after->inner, after->ports,
                          operation.change(*after, configuration, Count::strips));
      if (with_isolated)
        text += fmt::format(" {}", operation.isolated(true, *after) - operation.isolated(false, configuration));
    } else {
      text += '-';
    }
    text += '\n';
  }
  return text;
}

std::string dump_text(const std::vector<std::string>& tables) {
  std::string text = "restrip-table-dump 4\n";
  for (const std::string& table : tables) text += table;
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return text + fmt::format("end {}\n", lines - 1 - tables.size());
}

std::string dump_text(const NaiveOperation& operation, const NaiveTable& table) {
  return dump_text({table_text(operation, answers_of(operation, table), false)});
}

std::string with_end(const std::string& above, std::size_t rows) {
  unsigned long plain = 0;
  unsigned long weighted = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    plain += static_cast<unsigned char>(above[i]);
    weighted += (i + 1) * static_cast<unsigned char>(above[i]);
  }
  return fmt::format("{}end {} {} {}\n", above, rows, plain, weighted);
}

std::string with_sums(const std::string& text) {
  if (text.empty() || text.back() != '\n') return text;
  const std::size_t end = text.find_last_of('\n', text.size() - 2) + 1;
  std::istringstream words(text.substr(end));
  std::string word;
  std::size_t rows = 0;
  return words >> word >> rows && word == "end" ? with_end(text.substr(0, end), rows) : text;
}

}  // namespace restrip::verify::test
