#include "table_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "dump_judge.hpp"
#include "stream_lines.hpp"

namespace restrip::verify {
namespace {

void append_mask(std::string& text, Mask mask) {
  constexpr std::string_view digits = "0123456789abcdef";
  if (mask >= 16) append_mask(text, mask / 16);
  text += digits[mask % 16];
}

/// The line that a table must have for one configuration.
void write_expected(std::string& line, const Operation& operation, Mask inner, Mask ports, Answer answer) {
  line.clear();
  append_mask(line, inner);
  line += ' ';
  append_mask(line, ports);
  if (answer == not_valid) {
    line += " -";
  } else if (answer == no_row) {
    line += " ?";
  } else {
    line += ' ';
    append_mask(line, operation.gives_ports_up ? low_part(answer, operation.after.inner_edges()) : answer);
    if (!operation.gives_ports_up) return;
    line += ' ';
    append_mask(line, high_part(answer, operation.after.inner_edges()));
  }
}

std::string_view line_or_fail(StreamLines& lines, const std::string& expected) {
  const std::optional<std::string_view> line = lines.next();
  if (!line) throw BadDump(fmt::format("line {}: expected \"{}\", found the end", lines.number() + 1, expected));
  return *line;
}

/// A mask as certificates write it.
std::optional<Mask> mask_of(std::string_view word, unsigned bits) {
  Mask mask = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), mask, 16);
  const bool canonical = !word.empty() && (word.front() != '0' || word.size() == 1) &&
                         std::none_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'F'; });
  if (error != std::errc{} || end != word.data() + word.size() || !canonical || mask >= mask_count(bits)) return {};
  return mask;
}

/// The answer on a line, the first two masks of which are in `prefix`; nullopt when there is none.
std::optional<Answer> answer_on(std::string_view line, std::string_view prefix, const Operation& operation) {
  if (!line.starts_with(prefix)) return {};
  std::string_view word = line.substr(prefix.size());
  if (word == "-") return not_valid;
  Coloring after;
  if (operation.gives_ports_up) {
    const std::size_t space = std::min(word.find(' '), word.size() - 1);
    const std::optional<Mask> kept = mask_of(word.substr(space + 1), operation.after.ports());
    if (!kept) return {};
    after.ports = *kept;
    word = word.substr(0, space);
  }
  const std::optional<Mask> inner = mask_of(word, operation.after.inner_edges());
  if (!inner) return {};
  after.inner = *inner;
  return packed(after, operation);
}

class Comparison {
 public:
  Comparison(std::FILE* stream, const ExpectedDump& expected, DumpComparison& result)
      : lines_(stream), expected_(expected), result_(result) {}

  void run() {
    std::map<std::string, std::function<void()>, std::less<>> missing;
    for (const ExpectedTable& table : expected_.tables)
      missing.emplace("table " + table.operation->name(), [&] { table_of(table); });
    for (const ExpectedLists& lists : expected_.lists)
      missing.emplace(fmt::format("table {} {}", lists.family, lists.position), [&] { lists_of(lists); });
    const std::string title = "restrip-table-dump 2";
    if (const std::string_view first = line_or_fail(lines_, title); first != title)
      throw BadDump(fmt::format("line 1: expected \"{}\", found \"{}\"", title, first));
    while (!missing.empty()) {
      const std::string_view header = line_or_fail(lines_, missing.begin()->first);
      const auto table = missing.find(header);
      if (table == missing.end())
        throw BadDump(fmt::format("line {}: \"{}\" is no table that is still missing, such as \"{}\"", lines_.number(),
                                  header, missing.begin()->first));
      table->second();
      missing.erase(table);
    }
    const std::string last = fmt::format("end {}", result_.lines);
    if (const std::string_view found = line_or_fail(lines_, last); found != last)
      throw BadDump(fmt::format("line {}: expected \"{}\", found \"{}\"", lines_.number(), last, found));
    if (lines_.next() || lines_.left_over()) throw BadDump(fmt::format("line {}: text after the end", lines_.number()));
  }

 private:
  /// Where the entries of a table are counted.
  static void count(Compared& compared, const std::string& family, std::uint64_t entries) {
    Compared::Count& count = compared.families[family];
    ++count.positions;
    count.entries += entries;
  }

  void table_of(const ExpectedTable& table) {
    Compared& compared = result_.tables[static_cast<std::size_t>(table.against)];
    const std::uint64_t before = result_.lines;
    if (table.against == Against::certificate)
      compare_with_certificate(table, compared);
    else
      judge(*table.operation, table.against, compared);
    count(compared, table.operation->family, result_.lines - before);
  }

  void compare_with_certificate(const ExpectedTable& table, Compared& compared) {
    const Operation& operation = *table.operation;
    std::string expected;
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner)
      for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) {
        write_expected(expected, operation, inner, ports,
                       (*table.answers)[concatenated(inner, ports, operation.before.ports())]);
        const std::string_view found = line_or_fail(lines_, expected);
        ++result_.lines;
        if (found != expected)
          compared.differences.add(fmt::format("line {}, table {}: the certificate says \"{}\", the table \"{}\"",
                                               lines_.number(), operation.name(), expected, found));
      }
  }

  /// A table without a certificate: read whole, then judged, unless it is compared with nothing.
  void judge(const Operation& operation, Against against, Compared& compared) {
    const std::uint64_t first = lines_.number() + 1;
    std::vector<Answer> answers;
    std::string prefix;
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner)
      for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) {
        prefix.clear();
        append_mask(prefix, inner);
        prefix += ' ';
        append_mask(prefix, ports);
        prefix += ' ';
        const std::string_view line = line_or_fail(lines_, prefix);
        const std::optional<Answer> answer = answer_on(line, prefix, operation);
        if (!answer)
          throw BadDump(fmt::format("line {}, table {}: expected \"{}\" and an answer, found \"{}\"", lines_.number(),
                                    operation.name(), prefix, line));
        answers.push_back(*answer);
        ++result_.lines;
      }
    if (against == Against::nothing) return;
    if (const std::optional<WrongAnswer> wrong = wrong_answer(operation, answers))
      compared.differences.add(fmt::format(
          "line {}, table {}, inner {:x}, ports {:x}, answer {}{}", first + wrong->configuration, operation.name(),
          high_part(static_cast<Mask>(wrong->configuration), operation.before.ports()),
          low_part(static_cast<Mask>(wrong->configuration), operation.before.ports()),
          answers[wrong->configuration] == not_valid ? "-" : fmt::format("{:x}", answers[wrong->configuration]),
          wrong->what));
  }

  void lists_of(const ExpectedLists& lists) {
    const Against against = lists.lines == nullptr ? Against::nothing : Against::certificate;
    Compared& compared = result_.lists[static_cast<std::size_t>(against)];
    for (Mask ports = 0; ports < mask_count(lists.ports); ++ports) {
      const std::string expected = lists.lines == nullptr ? fmt::format("{:x} ", ports) : lists.lines->at(ports);
      const std::string_view found = line_or_fail(lines_, expected);
      ++result_.lines;
      if (lists.lines == nullptr && !found.starts_with(expected))
        throw BadDump(fmt::format("line {}, table {} {}: expected \"{}\", found \"{}\"", lines_.number(), lists.family,
                                  lists.position, expected, found));
      if (lists.lines != nullptr && found != expected)
        compared.differences.add(fmt::format("line {}, table {} {}: the certificate says \"{}\", the table \"{}\"",
                                             lines_.number(), lists.family, lists.position, expected, found));
    }
    count(compared, lists.family, mask_count(lists.ports));
  }

  StreamLines lines_;
  const ExpectedDump& expected_;
  DumpComparison& result_;
};

}  // namespace

Compared::Count Compared::sum() const {
  Count sum;
  for (const auto& [family, count] : families) {
    sum.positions += count.positions;
    sum.entries += count.entries;
  }
  return sum;
}

bool DumpComparison::agrees() const {
  const auto same = [](const Compared& compared) { return compared.differences.count == 0; };
  return fault.empty() && std::all_of(tables.begin(), tables.end(), same) &&
         std::all_of(lists.begin(), lists.end(), same);
}

DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected) {
  DumpComparison result;
  try {
    Comparison(stream, expected, result).run();
  } catch (const BadDump& bad) {
    result.fault = bad.what();
  }
  return result;
}

DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected) {
  std::FILE* stream = popen(program.c_str(), "r");
  if (stream == nullptr) {
    DumpComparison result;
    result.fault = "cannot run " + program;
    return result;
  }
  DumpComparison result = compare_dump(stream, expected);
  const int status = pclose(stream);
  if (result.fault.empty() && status != 0) result.fault = fmt::format("{} failed", program);
  return result;
}

}  // namespace restrip::verify
