#include "table_dump.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace restrip::verify {
namespace {

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
    if (end_ == buffer_.size()) return false;  // no line is that long
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

class Difference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string_view line_or_fail(StreamLines& lines, const std::string& expected) {
  const std::optional<std::string_view> line = lines.next();
  if (!line) throw Difference(fmt::format("line {}: expected \"{}\", found the end", lines.number() + 1, expected));
  return *line;
}

void compare_table(StreamLines& lines, const ExpectedTable& table, std::uint64_t& configurations) {
  const Operation& operation = *table.operation;
  std::string expected;
  for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner)
    for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) {
      const Answer answer =
          table.answers == nullptr ? no_row : (*table.answers)[concatenated(inner, ports, operation.before.ports())];
      write_expected(expected, operation, inner, ports, answer);
      const std::string_view found = line_or_fail(lines, expected);
      ++configurations;
      if (table.answers == nullptr ? found.starts_with(expected.substr(0, expected.size() - 1)) : found == expected)
        continue;
      throw Difference(fmt::format("line {}, table {}: the certificate says \"{}\", the table \"{}\"", lines.number(),
                                   operation.name(), expected, found));
    }
}

void compare_lists(StreamLines& lines, const ExpectedLists& lists, std::uint64_t& entries) {
  for (Mask ports = 0; ports < mask_count(lists.ports); ++ports) {
    const std::string expected = lists.lines == nullptr ? fmt::format("{:x} ", ports) : lists.lines->at(ports);
    const std::string_view found = line_or_fail(lines, expected);
    ++entries;
    if (lists.lines == nullptr ? !found.starts_with(expected) : found != expected)
      throw Difference(fmt::format("line {}, table {}: the certificate says \"{}\", the table \"{}\"", lines.number(),
                                   lists.name, expected, found));
  }
}

void compare_all(StreamLines& lines, const ExpectedDump& expected, std::uint64_t& entries) {
  std::map<std::string, std::function<void()>, std::less<>> missing;
  for (const ExpectedTable& table : expected.tables)
    missing.emplace("table " + table.operation->name(), [&] { compare_table(lines, table, entries); });
  for (const ExpectedLists& lists : expected.lists)
    missing.emplace("table " + lists.name, [&] { compare_lists(lines, lists, entries); });
  const std::string_view first = line_or_fail(lines, "restrip-table-dump 1");
  if (first != "restrip-table-dump 1")
    throw Difference(fmt::format("line 1: expected \"restrip-table-dump 1\", found \"{}\"", first));
  while (!missing.empty()) {
    const std::string_view header = line_or_fail(lines, missing.begin()->first);
    const auto table = missing.find(header);
    if (table == missing.end())
      throw Difference(fmt::format("line {}: \"{}\" is no table that is still missing, such as \"{}\"", lines.number(),
                                   header, missing.begin()->first));
    table->second();
    missing.erase(table);
  }
  const std::string last = fmt::format("end {}", entries);
  if (const std::string_view found = line_or_fail(lines, last); found != last)
    throw Difference(fmt::format("line {}: expected \"{}\", found \"{}\"", lines.number(), last, found));
  if (lines.next() || lines.left_over()) throw Difference(fmt::format("line {}: text after the end", lines.number()));
}

}  // namespace

DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected) {
  DumpComparison result;
  StreamLines lines(stream);
  try {
    compare_all(lines, expected, result.lines);
  } catch (const Difference& difference) {
    result.difference = difference.what();
  }
  return result;
}

DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected) {
  std::FILE* stream = popen(program.c_str(), "r");
  if (stream == nullptr) return {0, "cannot run " + program};
  DumpComparison result = compare_dump(stream, expected);
  const int status = pclose(stream);
  if (result.difference.empty() && status != 0) result.difference = fmt::format("{} failed", program);
  return result;
}

}  // namespace restrip::verify
