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

namespace restrip::verify {
namespace {

/// A line that has no place in a dump.
class BadDump : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lines of a stream. Millions of them: no allocation for each line.
class StreamLines {
 public:
  explicit StreamLines(std::FILE* stream) : stream_(stream), buffer_(1U << 18U) {}

  /// The next line without its newline; nullopt at the end. A last line without a newline is not a line.
  std::optional<std::string_view> next() {
    while (true) {
      const std::string_view waiting(buffer_.data() + start_, end_ - start_);
      if (const std::size_t newline = waiting.find('\n'); newline != std::string_view::npos) {
        start_ += newline + 1;
        ++number_;
        return waiting.substr(0, newline);
      }
      if (!refill()) return {};
    }
  }
  std::uint64_t number() const { return number_; }
  bool left_over() const { return start_ != end_; }

 private:
  bool refill() {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(start_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= start_;
    start_ = 0;
    if (end_ == buffer_.size())
      throw BadDump(fmt::format("line {}: longer than {} bytes, the limit", number_ + 1, buffer_.size()));
    const std::size_t count = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, stream_);
    end_ += count;
    return count != 0;
  }

  std::FILE* stream_;
  std::vector<char> buffer_;
  std::size_t start_ = 0;
  std::size_t end_ = 0;
  std::uint64_t number_ = 0;
};

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

/// The answer on a line of a fan's table, the first two masks of which are in `prefix`.
Answer answer_on(std::string_view line, std::string_view prefix, const Operation& operation, std::uint64_t number) {
  const auto fail = [&] {
    throw BadDump(fmt::format("line {}, table {}: expected \"{}\" and \"-\" or a mask, found \"{}\"", number,
                              operation.name(), prefix, line));
  };
  if (!line.starts_with(prefix)) fail();
  const std::string_view word = line.substr(prefix.size());
  if (word == "-") return not_valid;
  unsigned mask = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), mask, 16);
  const bool canonical = !word.empty() && (word.front() != '0' || word.size() == 1) &&
                         std::none_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'F'; });
  if (error != std::errc{} || end != word.data() + word.size() || !canonical ||
      mask >= mask_count(operation.after.inner_edges()))
    fail();
  return static_cast<Answer>(mask);
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
        if (!operation.gives_ports_up)
          answers.push_back(answer_on(line, prefix, operation, lines_.number()));
        else if (!line.starts_with(prefix))
          throw BadDump(fmt::format("line {}, table {}: expected \"{}\", found \"{}\"", lines_.number(),
                                    operation.name(), prefix, line));
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
