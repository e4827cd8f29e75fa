#include "judge/table_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "certificate/stream_lines.hpp"
#include "judge/index_cost.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {
namespace {

/// Takes a mask in the notation of certificates off the beginning of a line.
std::optional<Mask> taken_mask(std::string_view& line, unsigned bits) {
  Mask mask = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), mask, 16);
  const std::string_view word = line.substr(0, static_cast<std::size_t>(end - line.data()));
  const bool is_canonical =
      word.find_first_of("ABCDEF") == std::string_view::npos && (word == "0" || !word.starts_with('0'));
  if (error != std::errc{} || !is_canonical || mask >= mask_count(bits)) return {};
  line.remove_prefix(word.size());
  return mask;
}

/// Takes a space and a decimal number off the beginning of a line, as a program prints an int.
std::optional<int> taken_change(std::string_view& line) {
  if (!line.starts_with(' ')) return {};
  int change = 0;
  const char* const begin = line.data() + 1;
  const auto [end, error] = std::from_chars(begin, line.data() + line.size(), change);
  const std::string_view word(begin, static_cast<std::size_t>(end - begin));
  if (error != std::errc{} || std::to_string(change) != word) return {};
  line.remove_prefix(1 + word.size());
  return change;
}

/// Judges the answers of one table: by the rows of a certificate, which are judged elsewhere, or by the definition and
/// the bounds of the description.
class TableJudge {
 public:
  TableJudge(const ExpectedTable& table, DumpComparison& result)
      : table_(table), result_(result), compared_(result.tables[static_cast<std::size_t>(table.against)]) {
    if (table.rows != nullptr)
      keys_.emplace(*table.operation);
    else
      judge_.emplace(*table.operation);
    if (judge_ && table.operation->most_indices) index_cost_.emplace(*table.operation);
  }

  bool is_bounded() const {
    const Operation& operation = *table_.operation;
    return judge_ && (operation.most_strips || operation.most_isolated || operation.most_indices);
  }

  void entry(std::uint64_t line, Colors configuration, const std::optional<Answer>& answer) {
    const Operation& operation = *table_.operation;
    const auto where = [&] {
      return fmt::format("line {}, table {}, inner {:x}, ports {:x}: ", line, operation.name(), configuration.inner,
                         configuration.ports);
    };
    const std::optional<Key> key = keys_ ? keys_->key_of(configuration) : judge_->key_of(configuration);
    if (key.has_value() != answer.has_value()) {
      compared_.wrong.add(
          fmt::format("{}\n    before  {}\n  {}\n", where(), drawn(operation.before, configuration),
                      key ? "no answer to a valid configuration"
                          : "an answer to a configuration that is not valid: " +
                                invalid_because(operation.before, configuration, most_solid(operation.constraint))));
      return;
    }
    if (!key) return;
    judge_changes(configuration, *answer, where);
    if (is_bounded()) judge_bounds(configuration, answer->colors, where);
    if (judge_) {
      const Judged judged = judge_->judged(configuration, answer->colors);
      if (judged.verdict == Verdict::right) return;
      compared_.wrong.add(
          compared_.wrong.count != 0
              ? std::string()
              : fmt::format("{}\n{}", where(), judge_->explained(configuration, answer->colors, judged)));
      return;
    }
    const Row* const row = table_.rows->row_of(*key);
    if (row == nullptr || row->after != answer->colors)
      compared_.differences.add(fmt::format(
          "{}the table answers \"{:x} {:x}\", the certificate has {}\n", where(), answer->colors.inner,
          answer->colors.ports, row == nullptr ? "no row" : fmt::format("\"{}\" in line {}", row->text(), row->line)));
  }

 private:
  /// The stated changes of an answer must equal the changes of its colours.
  template <class Where>
  void judge_changes(Colors configuration, const Answer& answer, const Where& where) {
    const auto compare = [&](const std::optional<int>& stated, const char* what, int before, int after) {
      if (stated && *stated != after - before)
        result_.misstated.add(fmt::format("{}the table states {:+d} {}, but there are {} before and {} after\n",
                                          where(), *stated, what, before, after));
    };
    const Operation& operation = *table_.operation;
    compare(answer.strips, "strips", strips_of(operation.before, configuration),
            strips_of(operation.after, answer.colors));
    if (answer.isolated.has_value())
      compare(answer.isolated, "isolated triangles", static_cast<int>(isolated_of(operation.before, configuration)),
              static_cast<int>(isolated_of(operation.after, answer.colors)));
  }

  template <class Where>
  void judge_bounds(Colors configuration, Colors answer, const Where& where) {
    const Operation& operation = *table_.operation;
    const auto compare = [&](const char* what, std::optional<int> most, int added) {
      if (most && added > *most)
        result_.beyond.add(
            fmt::format("{}the answer adds {} {}, the family claims at most {}\n", where(), added, what, *most));
    };
    const Change change = change_of(operation, configuration, answer);
    compare("to the strips", operation.most_strips, change.strips);
    compare("to the isolated triangles", operation.most_isolated, change.isolated);
    if (index_cost_)
      compare("to 3 strips + swaps", operation.most_indices, index_cost_->added(configuration, answer).at_most);
  }

  const ExpectedTable& table_;
  DumpComparison& result_;
  Compared& compared_;
  std::optional<Keys> keys_;
  std::optional<OperationJudge> judge_;
  std::optional<IndexCost> index_cost_;
};

/// Judges the answers to every configuration in the order of a dump. For a matching, to every colouring of the ports,
/// because it serves all colourings of the inner edges. `next` returns the line of an answer, and the answer.
template <class Next>
void compare_table(const ExpectedTable& table, DumpComparison& result, const Next& next) {
  const Operation& operation = *table.operation;
  std::optional<TableJudge> judge;
  if (table.against != Against::nothing) judge.emplace(table, result);
  std::uint64_t entries = 0;
  const Mask inner_masks =
      operation.constraint == Constraint::matching ? 1 : mask_count(operation.before.inner_edges());
  for (Mask inner = 0; inner < inner_masks; ++inner)
    for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports) {
      const auto& [line, answer] = next({inner, ports});
      ++entries;
      if (judge) judge->entry(line, {inner, ports}, answer);
    }
  result.tables[static_cast<std::size_t>(table.against)].families[operation.family] += {1, entries};
  if (judge && judge->is_bounded()) result.bounded += {1, entries};
  result.lines += entries;
}

class DumpReader {
 public:
  DumpReader(StreamLines& lines, const ExpectedDump& expected, DumpComparison& result)
      : lines_(lines), expected_(expected), result_(result) {}

  void run() {
    lines_.expect("restrip-table-dump 4");
    std::map<std::string, const ExpectedTable*, std::less<>> missing;
    for (const ExpectedTable& table : expected_.tables) missing.emplace("table " + table.operation->name(), &table);
    while (!missing.empty()) {
      const std::string_view header = lines_.next(missing.begin()->first);
      const auto table = missing.find(header);
      if (table == missing.end())
        lines_.fail(
            fmt::format("\"{}\" is not a table that is still missing, such as \"{}\"", header, missing.begin()->first));
      table_of(*table->second);
      missing.erase(table);
    }
    lines_.expect_last(fmt::format("end {}", result_.lines));
  }

 private:
  void table_of(const ExpectedTable& table) {
    const Operation& operation = *table.operation;
    std::uint32_t* const digest =
        expected_.with_digests && table.has_digest ? &result_.digests[digest_words(operation)] : nullptr;
    compare_table(table, result_, [&](Colors configuration) {
      const std::optional<Answer> answer = answer_to(configuration, operation);
      if (digest != nullptr) *digest += digest_of(operation, configuration, answer);
      return std::pair(lines_.number(), answer);
    });
  }

  /// The answer in the next line; nullopt if it states that no answer exists.
  std::optional<Answer> answer_to(Colors configuration, const Operation& operation) {
    prefix_ = fmt::format("{:x} {:x} ", configuration.inner, configuration.ports);
    const std::string_view line = lines_.next(prefix_);
    if (line.starts_with(prefix_)) {
      std::string_view rest = line.substr(prefix_.size());
      if (rest == "-") return {};
      const std::optional<Mask> inner = taken_mask(rest, operation.after.inner_edges());
      if (inner && rest.starts_with(' ')) {
        rest.remove_prefix(1);
        const std::optional<Mask> kept = taken_mask(rest, operation.ports());
        const std::optional<int> strips = taken_change(rest);
        const std::optional<int> isolated = taken_change(rest);
        if (kept && strips && (isolated || !expected_.states_isolated) && rest.empty())
          return Answer{{*inner, *kept}, strips, isolated};
      }
    }
    lines_.fail(fmt::format(
        "table {}: expected \"{}\" and \"-\" or two masks, {} and {} bits at most, and the change in strips{}, found "
        "\"{}\"",
        operation.name(), prefix_, operation.after.inner_edges(), operation.ports(),
        expected_.states_isolated ? " and in isolated triangles" : "", line));
  }

  StreamLines& lines_;
  const ExpectedDump& expected_;
  DumpComparison& result_;
  std::string prefix_;
};

}  // namespace

bool DumpComparison::agrees() const {
  const auto none = [](const Compared& compared) { return compared.differences.count + compared.wrong.count == 0; };
  return fault.empty() && misstated.count + beyond.count == 0 && std::all_of(tables.begin(), tables.end(), none);
}

DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected) {
  return found_in<DumpComparison>(
      stream, [&](StreamLines& lines, DumpComparison& result) { DumpReader(lines, expected, result).run(); });
}

DumpComparison compare_answers(const ExpectedDump& expected, const AnswerOf& answer) {
  DumpComparison result;
  result.states_changes = false;
  for (const ExpectedTable& table : expected.tables) {
    std::uint64_t entry = 0;
    compare_table(table, result,
                  [&](Colors configuration) { return std::pair(++entry, answer(*table.operation, configuration)); });
  }
  return result;
}

DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected) {
  return checked_output_of(program, [&](std::FILE* stream) { return compare_dump(stream, expected); });
}

std::string digest_words(const Operation& operation) {
  // Operations are identified by their index here.
  constexpr std::array<std::string_view, 7> names = {
      "split", "collapse", "open-split", "open-collapse", "boundary-split", "boundary-collapse", "flip"};
  const auto name = std::find(names.begin(), names.end(), operation.family);
  if (name == names.end()) throw std::logic_error(operation.family + " has no digests");
  Numbers numbers = operation.numbers;
  numbers.resize(3);
  return fmt::format("{} {} {} {}", name - names.begin(), numbers[0], numbers[1], numbers[2]);
}

std::uint32_t digest_of(const Operation& operation, Colors configuration, const std::optional<Answer>& answer) {
  if (!answer) return mixed_number(configuration.inner, configuration.ports, 0);
  // The flip's answer has its kept ports below its inner edge; the others keep all ports.
  const Mask colors = operation.may_give_up != 0
                          ? concatenated(answer->colors.inner, answer->colors.ports, operation.ports())
                          : answer->colors.inner;
  return mixed(configuration.inner, configuration.ports, colors, answer->strips.value());
}

DigestComparison compare_digests_of(const std::string& program, const Digests& expected) {
  const auto compare = [&](StreamLines& lines, DigestComparison& result) {
    Digests missing = expected;
    while (!missing.empty()) {
      const std::string& first = missing.begin()->first;
      const std::string_view line = lines.next(first);
      const std::size_t space = std::min(line.rfind(' '), line.size());
      const auto position = missing.find(std::string(line.substr(0, space)));
      if (position == missing.end())
        lines.fail(fmt::format("\"{}\" is not a position that is missing, such as \"{}\"", line, first));
      ++result.positions;
      if (const std::string right = fmt::format("{} {:08x}", position->first, position->second); line != right)
        result.differences.add(
            fmt::format("line {}: \"{}\", the judged answers give \"{}\"\n", lines.number(), line, right));
      missing.erase(position);
    }
    lines.expect_last("rules outside the tables: 0");
  };
  return checked_output_of(program, [&](std::FILE* stream) { return found_in<DigestComparison>(stream, compare); });
}

}  // namespace restrip::verify
