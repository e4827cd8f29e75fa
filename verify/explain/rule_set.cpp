#include "explain/rule_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "common/counted.hpp"
#include "common/share.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

struct RuleRow {
  unsigned line = 0;
  Colors configuration;
  Colors recoloring;
  std::optional<Change> stated;
};

/// The columns of colours: the same as in dumps (docs/reference/notation.md names the masks), and of any other
/// operation.
std::string color_columns(const std::string& family) {
  if (family == "split" || family == "open-split" || family == "boundary-split") return "loop,ports,inner";
  if (family == "collapse" || family == "open-collapse" || family == "boundary-collapse") return "inner,ports,loop";
  return "inner,ports,inner_after";
}

class RuleReader {
 public:
  /// Of the description `family`, or without a name of the only one with the columns of the header.
  RuleReader(const std::string& file, std::string text, const std::vector<Description>& descriptions,
             const std::string& family)
      : file_(file), lines_(file, in_words(file, std::move(text))) {
    lines_.next("a header");
    header_ = lines_.rest(0);
    std::string header = header_;
    std::replace(header.begin(), header.end(), ' ', ',');
    std::string expected;
    for (const Description& one : descriptions) {
      if (!family.empty() && one.name != family) continue;
      const std::string begin =
          fmt::format("{}{}{}", fmt::join(one.numbers, ","), one.numbers.empty() ? "" : ",", color_columns(one.name));
      expected += fmt::format("\n  {}", begin);
      if (!header.starts_with(begin)) continue;
      std::string_view rest = std::string_view(header).substr(begin.size());
      const auto take = [&](std::string_view what) {
        const bool found = rest.starts_with(what);
        rest.remove_prefix(found ? what.size() : 0);
        return found;
      };
      const bool has_kept = take(",ports_after");
      const bool has_change = take(",strips,isolated");
      if (!rest.empty()) continue;
      if (description_ != nullptr)
        lines_.fail(fmt::format("the columns of {} and of {}: expected --family with one of these names",
                                description_->name, one.name));
      description_ = &one;
      has_kept_ = has_kept;
      has_change_ = has_change;
    }
    if (description_ == nullptr)
      lines_.fail(fmt::format(
          "expected one of these headers, then perhaps ports_after, then perhaps strips,isolated:{}", expected));
  }
  const Description& description() const { return *description_; }

  /// The rows of each position, and the positions themselves.
  void read(std::map<Numbers, Operation>& operations, std::map<Numbers, std::vector<RuleRow>>& rows) {
    const std::size_t numbers = description_->numbers.size();
    const std::size_t words = numbers + 3U + (has_kept_ ? 1U : 0U) + (has_change_ ? 2U : 0U);
    while (!lines_.at_end()) {
      lines_.next("a row");
      if (lines_.rest(0) == header_) continue;
      lines_.expect_words(words, fmt::format("{} columns", words));
      Numbers position;
      for (std::size_t i = 0; i < numbers; ++i) position.push_back(mask(i, 8));
      auto known = operations.find(position);
      if (known == operations.end()) known = operations.emplace(position, operation_at(*description_, position)).first;
      const Operation& operation = known->second;
      RuleRow row;
      row.line = lines_.line();
      row.configuration = {mask(numbers, operation.before.inner_edges()), mask(numbers + 1, operation.ports())};
      row.recoloring = {mask(numbers + 2, operation.after.inner_edges()), row.configuration.ports};
      if (has_kept_) row.recoloring.ports = mask(numbers + 3, operation.ports());
      if (has_change_) row.stated = {change(words - 2), change(words - 1)};
      rows[position].push_back(row);
    }
  }

 private:
  static std::string in_words(const std::string& file, std::string text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // a byte order mark: spreadsheets write it
    if (text.find(' ') != std::string::npos) throw InputError(file, 0, "expected no spaces between columns");
    std::erase(text, '\r');
    std::replace(text.begin(), text.end(), ',', ' ');
    return text;
  }
  /// A decimal number below 2 to the number of bits.
  Mask mask(std::size_t column, unsigned bits) const {
    const std::int64_t value = lines_.number(column);
    if (value < 0 || value >= std::int64_t{mask_count(bits)})
      lines_.fail(fmt::format("expected 0 to {} in column {}, found {}", mask_count(bits) - 1, column + 1, value));
    return static_cast<Mask>(value);
  }

  /// A change of strips or of isolated triangles: no more than a side has triangles and ports.
  int change(std::size_t column) const {
    constexpr std::int64_t most = most_triangles + most_ports;
    const std::int64_t value = lines_.number(column);
    if (value < -most || value > most)
      lines_.fail(fmt::format("expected {} to {} in column {}, found {}", -most, most, column + 1, value));
    return static_cast<int>(value);
  }

  std::string file_;
  LineReader lines_;
  std::string header_;
  const Description* description_ = nullptr;
  bool has_kept_ = false;
  bool has_change_ = false;
};

/// Worse rows first: by standing, then by strips lost.
void keep_worst(RuleSetReport& report, std::size_t worst) {
  const auto rank = [](const BadRow& row) { return std::tuple(row.standing, -row.strips_lost, row.line); };
  std::sort(report.worst.begin(), report.worst.end(),
            [&](const BadRow& one, const BadRow& other) { return rank(one) < rank(other); });
  if (report.worst.size() > worst) report.worst.resize(worst);
}

/// The rows of one position.
RuleSetReport judge_position(const std::string& file, const Operation& operation, const std::vector<RuleRow>& rows,
                             std::size_t worst) {
  const Definition definition(operation);
  RuleSetReport report;
  report.rows = rows.size();
  std::map<Colors, unsigned> line_of;
  for (const RuleRow& row : rows) {
    const auto [first, is_new] = line_of.try_emplace(row.configuration, row.line);
    if (!is_new) throw InputError(file, row.line, fmt::format("the configuration of line {} again", first->second));
    if (!definition.valid(row.configuration)) {
      ++report.standings[static_cast<std::size_t>(Standing::not_a_configuration)];
      report.worst.push_back({row.line, Standing::not_a_configuration, 0,
                              invalid_because(operation.before, row.configuration, most_solid(operation.constraint)),
                              arguments_of(operation, row.configuration, {})});
      continue;
    }
    const Judgement judgement = judgement_of(definition, row.configuration, row.recoloring);
    ++report.standings[static_cast<std::size_t>(judgement.standing)];
    report.strips_lost += judgement.strips_lost.value_or(0);
    const Change change = change_of(operation, row.configuration, row.recoloring);
    const bool misstated = row.stated && judgement.standing >= Standing::worse && *row.stated != change;
    report.misstated += misstated ? 1U : 0U;
    if (!misstated && judgement.standing > Standing::worse) continue;
    report.worst.push_back({row.line, judgement.standing, judgement.strips_lost.value_or(0),
                            judgement.standing > Standing::worse ? "" : judgement.because,
                            arguments_of(operation, row.configuration, row.recoloring)});
    std::string& because = report.worst.back().because;
    if (misstated)
      because +=
          fmt::format("{}states strips {}, isolated {}, but changes them by {} and {}", because.empty() ? "" : "; ",
                      row.stated->strips, row.stated->isolated, change.strips, change.isolated);
  }
  for (Mask both = 0; both < mask_count(operation.before.colors()); ++both) {
    const Colors configuration{high_part(both, operation.ports()), low_part(both, operation.ports())};
    if (!definition.valid(configuration)) continue;
    ++report.configurations;
    if (!line_of.contains(configuration) && report.without_row.size() < worst)
      report.without_row.push_back(arguments_of(operation, configuration, {}));
  }
  keep_worst(report, worst);
  return report;
}

}  // namespace

std::uint64_t RuleSetReport::at_least(Standing standing) const {
  std::uint64_t sum = 0;
  for (std::size_t i = static_cast<std::size_t>(standing); i < standings.size(); ++i) sum += standings[i];
  return sum;
}

RuleSetReport judge_rules(const std::string& file, const std::string& text,
                          const std::vector<Description>& descriptions, const std::string& family, std::size_t worst,
                          unsigned threads) {
  RuleReader reader(file, text, descriptions, family);
  std::map<Numbers, Operation> operations;
  std::map<Numbers, std::vector<RuleRow>> rows;
  reader.read(operations, rows);
  if (rows.empty()) throw InputError(file, 0, "has no rows");

  std::vector<const Numbers*> order;
  order.reserve(rows.size());
  for (const auto& position : rows) order.push_back(&position.first);
  std::vector<RuleSetReport> parts(order.size());
  share(order.size(), threads,
        [&](std::size_t i) { parts[i] = judge_position(file, operations.at(*order[i]), rows.at(*order[i]), worst); });

  RuleSetReport sum;
  sum.operation = reader.description().name;
  sum.positions = parts.size();
  for (const RuleSetReport& part : parts) {
    sum.rows += part.rows;
    for (std::size_t i = 0; i < sum.standings.size(); ++i) sum.standings[i] += part.standings[i];
    sum.misstated += part.misstated;
    sum.configurations += part.configurations;
    sum.strips_lost += part.strips_lost;
    sum.worst.insert(sum.worst.end(), part.worst.begin(), part.worst.end());
    const std::size_t more = std::min(worst - sum.without_row.size(), part.without_row.size());
    sum.without_row.insert(sum.without_row.end(), part.without_row.begin(),
                           part.without_row.begin() + static_cast<std::ptrdiff_t>(more));
  }
  keep_worst(sum, worst);
  const Description& description = reader.description();
  if (!description.numbers.empty())
    for (const Numbers& position : description.positions(rows.rbegin()->first.front()))
      if (description.listed.hold(position) && !rows.contains(position) &&
          std::any_of(order.begin(), order.end(), [&](const Numbers* one) { return one->front() == position.front(); }))
        sum.absent.push_back(description.filled(description.position, position));
  return sum;
}

std::string text_of(const RuleSetReport& report, const std::string& source) {
  std::string text = fmt::format("{}: {} at {}\n", report.operation, counted_grouped(report.rows, "row"),
                                 counted(report.positions, "position"));
  const auto line = [&](const char* name, std::uint64_t count) {
    text += fmt::format("{:<22}{:>9}\n", name, grouped(count));
  };
  line("not a configuration", report.not_configurations());
  line("valid", report.at_least(Standing::unsound));
  line("sound", report.at_least(Standing::worse));
  line("best", report.at_least(Standing::equally_good));
  line("change misstated", report.misstated);
  line("without a row", report.configurations - report.at_least(Standing::not_valid));
  text += fmt::format("{:<22}{:>9}\n", "strips lost", report.strips_lost);
  if (!report.absent.empty()) text += fmt::format("positions without any row: {}\n", fmt::join(report.absent, ", "));
  for (const BadRow& row : report.worst)
    text += fmt::format("line {}: {}: {}\n  restrip-verify explain {} {}\n", row.line, name_of(row.standing),
                        row.because, source, row.arguments);
  if (!report.without_row.empty()) text += "configurations without a row, the first:\n";
  for (const std::string& arguments : report.without_row)
    text += fmt::format("  restrip-verify explain {} {}\n", source, arguments);
  return text;
}

nlohmann::ordered_json json_of(const RuleSetReport& report) {
  nlohmann::ordered_json json = {
      {"operation", report.operation},
      {"positions", report.positions},
      {"positions_without_rows", report.absent},
      {"rows", report.rows},
      {"not_configurations", report.not_configurations()},
      {"valid", report.at_least(Standing::unsound)},
      {"sound", report.at_least(Standing::worse)},
      {"best", report.at_least(Standing::equally_good)},
      {"misstated", report.misstated},
      {"configurations_without_row", report.configurations - report.at_least(Standing::not_valid)},
      {"first_without_row", report.without_row},
      {"strips_lost", report.strips_lost},
      {"worst", nlohmann::ordered_json::array()}};
  for (const BadRow& row : report.worst)
    json["worst"].push_back({{"line", row.line},
                             {"verdict", name_of(row.standing)},
                             {"because", row.because},
                             {"strips_lost", row.strips_lost},
                             {"arguments", row.arguments}});
  return json;
}

}  // namespace restrip::verify
