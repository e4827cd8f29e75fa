#include "operation_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "json.hpp"

namespace restrip::verify::operations {
namespace {

/// What the page fixes: the lines before the numbers and those behind them, how many numbers, the largest.
struct Frame {
  std::vector<std::string> before;
  std::vector<std::string> behind;
  std::uint64_t numbers = 0;
  std::uint64_t largest = 0;
};

Frame frame_of(const OperationFile& operation) {
  const bool matching = operation.constraint == Constraint::matching;
  const unsigned bits = operation.after.inner_edges() + operation.ports();
  const unsigned width = bits < 8 ? 8 : (bits < 16 ? 16 : 32);
  Frame frame;
  frame.numbers = std::uint64_t{1} << (operation.ports() + (matching ? 0 : operation.before.inner_edges()));
  frame.largest = (std::uint64_t{1} << width) - 1;
  std::string variable = operation.name;
  std::replace(variable.begin(), variable.end(), '-', '_');
  frame.before = {
      "// " + (operation.about.empty() ? operation.name : operation.about),
      fmt::format("// Written by `restrip-generate rules` from the operation file of {}. Do not edit.", operation.name),
      "// Explained in restrip/tables/operation_format.hpp.",
      "#pragma once",
      "",
      "#include \"restrip/tables/operation_format.hpp\"",
      "",
      "namespace restrip::tables {",
      "",
      fmt::format("inline constexpr OperationTable<std::uint{}_t, {}> {}{{", width, frame.numbers, variable),
      fmt::format("    {{{}, {}}},", operation.before.triangles, operation.before.inner_edges()),
      fmt::format("    {{{}, {}}},", operation.after.triangles, operation.after.inner_edges()),
      fmt::format("    {},", operation.ports()),
      fmt::format("    {},", matching),
      "    {"};
  frame.behind = {"    }};", "", "}  // namespace restrip::tables"};
  return frame;
}

class HeaderReader {
 public:
  HeaderReader(const std::string& file, std::string_view text, HeaderCheck& check)
      : file_(file), text_(text), check_(check) {}

  void read(const Frame& frame) {
    for (const std::string& line : frame.before)
      if (!expect(line)) return;
    for (std::uint64_t numbers = 0; numbers < frame.numbers;)
      if (!take_numbers(frame, numbers)) return;
    for (const std::string& line : frame.behind)
      if (!expect(line)) return;
    if (!text_.empty()) fail("the end of the file", text_.substr(0, text_.find('\n')));
  }

 private:
  /// The next line with its end, or what is left.
  std::string_view next() {
    ++check_.lines;
    const std::size_t end = text_.find('\n');
    const std::string_view line = text_.substr(0, end == std::string_view::npos ? end : end + 1);
    text_.remove_prefix(line.size());
    return line;
  }

  bool expect(const std::string& whole) {
    const std::string_view line = next();
    if (line != whole + '\n') fail(fmt::format("\"{}\" and the end of the line", whole), line);
    return line == whole + '\n';
  }

  bool take_numbers(const Frame& frame, std::uint64_t& numbers) {
    const std::string_view line = next();
    std::string_view rest = line;
    const auto taken = [&](std::string_view words) {
      const bool found = rest.starts_with(words);
      rest.remove_prefix(found ? words.size() : 0);
      return found;
    };
    bool good = taken("   ");
    while (good && !taken("\n")) {
      std::uint64_t number = 0;
      good = taken(" ") && numbers < frame.numbers;
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
      const std::string_view word = rest.substr(0, static_cast<std::size_t>(end - rest.data()));
      good = good && error == std::errc{} && number <= frame.largest && std::to_string(number) == word;
      rest.remove_prefix(word.size());
      good = good && taken(",");
      ++numbers;
    }
    if (!good) fail(fmt::format("numbers up to {}, each with a comma, {} in all", frame.largest, frame.numbers), line);
    return good;
  }

  void fail(const std::string& expected, std::string_view found) {
    check_.wrong.add(fmt::format("{}:{}: expected {}, found \"{}\"; make the header anew from the operation file",
                                 file_, check_.lines, expected, shown(found.substr(0, 200))));
  }

  const std::string& file_;
  std::string_view text_;
  HeaderCheck& check_;
};

}  // namespace

HeaderCheck check_operation_header(const std::string& file, std::string_view text, const OperationFile& operation) {
  HeaderCheck check;
  HeaderReader(file, text, check).read(frame_of(operation));
  return check;
}

}  // namespace restrip::verify::operations
