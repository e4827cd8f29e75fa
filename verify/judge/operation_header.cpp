#include "judge/operation_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "model/input.hpp"
#include "model/json.hpp"

namespace restrip::verify {
namespace {

/// Sides of triangles as `restrip/tables/operation_format.hpp` numbers them, beside inner edges.
constexpr std::uint64_t first_port_side = 64;
constexpr std::uint64_t boundary_side = 255;

class HeaderReader {
 public:
  HeaderReader(const std::string& file, std::string_view text, const Description& description, unsigned max_k,
               HeaderCheck& check)
      : file_(file), rest_(text), description_(description), check_(check) {
    for (const Numbers& numbers : description.positions(max_k)) operations_.push_back(description.at(numbers));
    if (operations_.empty())
      throw InputError(description.file(), 0, fmt::format("{} has no position up to {}", description.name, max_k));
  }

  /// Stops at the first line that is not right.
  void read() {
    const bool good = expect_all(lines_before()) &&
                      expect_all(is_family() ? lines_of_family() : lines_of_operation()) && take_entries() &&
                      (first().on_a_mesh() ? take_surface() : expect("    }};")) && expect("") &&
                      expect("}  // namespace restrip::tables");
    if (good && !rest_.empty()) fail("the end of the file", rest_.substr(0, rest_.find('\n')));
  }

 private:
  [[nodiscard]] bool is_family() const { return !description_.numbers.empty(); }
  [[nodiscard]] const Operation& first() const { return operations_.front(); }
  [[nodiscard]] bool is_matching() const { return first().constraint == Constraint::matching; }
  /// Bits of an entry.
  [[nodiscard]] unsigned width() const {
    unsigned bits = 0;
    for (const Operation& operation : operations_)
      bits = std::max(bits, operation.after.inner_edges() + operation.ports());
    return bits < 8 ? 8 : (bits < 16 ? 16 : 32);
  }
  [[nodiscard]] std::uint64_t entries_of(const Operation& operation) const {
    return std::uint64_t{1} << (operation.ports() + (is_matching() ? 0 : operation.before.inner_edges()));
  }
  [[nodiscard]] std::uint64_t entries() const {
    std::uint64_t all = 0;
    for (const Operation& operation : operations_) all += entries_of(operation);
    return all;
  }
  /// Of all positions.
  [[nodiscard]] std::string triangle_counts() const {
    unsigned before = 0;
    unsigned after = 0;
    for (const Operation& operation : operations_) {
      before += operation.before.triangles;
      after += operation.after.triangles;
    }
    return fmt::format(", {}, {}", before, after);
  }
  [[nodiscard]] std::string variable() const {
    std::string name = description_.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }

  [[nodiscard]] std::vector<std::string> lines_before() const {
    const std::string& name = description_.name;
    return {"// " + (description_.about.empty() ? name : description_.about),
            fmt::format("// Written by `restrip-generate rules` from the operation file of {}. Do not edit.", name),
            "// Explained in restrip/tables/operation_format.hpp.",
            "#pragma once",
            "",
            "#include \"restrip/tables/operation_format.hpp\"",
            "",
            "namespace restrip::tables {",
            ""};
  }

  /// From the name to the entries.
  [[nodiscard]] std::vector<std::string> lines_of_operation() const {
    const Side& before = first().before;
    const Side& after = first().after;
    const bool surface = first().on_a_mesh();
    return {
        fmt::format("inline constexpr {}<std::uint{}_t, {}{}> {}{{", surface ? "SurfaceOperation" : "OperationTable",
                    width(), entries(), surface ? triangle_counts() : std::string(), variable()),
        fmt::format("    {}{{{}, {}}},", surface ? "{" : "", before.triangles, before.inner_edges()),
        fmt::format("    {{{}, {}}},", after.triangles, after.inner_edges()),
        fmt::format("    {},", first().ports()),
        fmt::format("    {},", is_matching()),
        "    {"};
  }

  /// The same of a family.
  [[nodiscard]] std::vector<std::string> lines_of_family() const {
    const bool surface = first().on_a_mesh();
    std::vector<std::string> lines{
        fmt::format("inline constexpr {}<std::uint{}_t, {}, {}{}> {}{{", surface ? "SurfaceFamily" : "OperationFamily",
                    width(), entries(), operations_.size(), surface ? triangle_counts() : std::string(), variable()),
        fmt::format("    {}{},", surface ? "{" : "", is_matching()), fmt::format("    \"{}\",", position()), "    {{"};
    std::uint64_t begin = 0;
    for (const Operation& operation : operations_) {
      Numbers numbers = operation.numbers;
      numbers.resize(most_numbers);
      lines.push_back(fmt::format("    {{{{{}}}, {{{}, {}}}, {{{}, {}}}, {}, {}}},", fmt::join(numbers, ", "),
                                  operation.before.triangles, operation.before.inner_edges(), operation.after.triangles,
                                  operation.after.inner_edges(), operation.ports(), begin));
      begin += entries_of(operation);
    }
    lines.insert(lines.end(), {"    }},", "    {"});
    return lines;
  }

  /// As a string literal holds it: with the places of the numbers for their names, and a backslash where one must be.
  [[nodiscard]] std::string position() const {
    std::string literal;
    for (const char c : description_.position) {
      if (c == '"' || c == '\\') literal += '\\';
      literal += c;
    }
    for (std::size_t i = 0; i < description_.numbers.size(); ++i) {
      const std::string name = fmt::format("{{{}}}", description_.numbers[i]);
      literal.replace(literal.find(name), name.size(), fmt::format("{{{}}}", i));
    }
    return literal;
  }

  /// The next line with its end, or what is left.
  std::string_view next() {
    ++check_.lines;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end == std::string_view::npos ? end : end + 1);
    rest_.remove_prefix(line.size());
    return line;
  }

  bool expect(const std::string& whole) {
    const std::string_view line = next();
    const bool right = line == whole + '\n';
    if (!right) fail(fmt::format("\"{}\" and the end of the line", whole), line);
    return right;
  }
  bool expect_all(const std::vector<std::string>& lines) {
    return std::all_of(lines.begin(), lines.end(), [&](const std::string& line) { return expect(line); });
  }

  static bool take(std::string_view& line, std::string_view words) {
    const bool found = line.starts_with(words);
    line.remove_prefix(found ? words.size() : 0);
    return found;
  }
  template <class Fits>
  static bool take_number(std::string_view& line, const Fits& fits) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    const std::string_view word = line.substr(0, static_cast<std::size_t>(end - line.data()));
    line.remove_prefix(word.size());
    return error == std::errc{} && std::to_string(number) == word && fits(number);
  }

  /// Lines of so many elements, a space before each and a comma behind it; `take_one` takes what is between.
  template <class TakeOne>
  bool take_elements(std::uint64_t count, const std::string& expected, const TakeOne& take_one) {
    for (std::uint64_t taken = 0; taken < count;) {
      const std::string_view line = next();
      std::string_view rest = line;
      bool good = take(rest, "   ");
      while (good && !take(rest, "\n")) good = taken++ < count && take(rest, " ") && take_one(rest) && take(rest, ",");
      if (!good) {
        fail(fmt::format("{}, each with a comma, {} in all", expected, count), line);
        return false;
      }
    }
    return true;
  }

  bool take_entries() {
    const std::uint64_t largest = (std::uint64_t{1} << width()) - 1;
    return take_elements(entries(), fmt::format("numbers up to {}", largest), [&](std::string_view& line) {
      return take_number(line, [&](std::uint64_t number) { return number <= largest; });
    });
  }

  bool take_surface() {
    return expect("    }},") && (is_family() ? expect_all(triangles_of_positions()) : expect(vertices_of(first()))) &&
           take_triangles(&Operation::before) && take_triangles(&Operation::after) && expect("};");
  }

  static std::string vertices_of(const Operation& operation) { return fmt::format("    {},", operation.vertices); }
  /// For each position how many vertices there are, and where its triangles begin.
  [[nodiscard]] std::vector<std::string> triangles_of_positions() const {
    std::vector<std::string> lines{"    {{"};
    unsigned before = 0;
    unsigned after = 0;
    for (const Operation& operation : operations_) {
      lines.push_back(fmt::format("    {{{}, {}, {}}},", operation.vertices, before, after));
      before += operation.before.triangles;
      after += operation.after.triangles;
    }
    lines.emplace_back("    }},");
    return lines;
  }

  bool take_triangles(Side Operation::*of) {
    // Which operation each of the triangles belongs to.
    std::vector<const Operation*> owners;
    for (const Operation& operation : operations_) owners.insert(owners.end(), (operation.*of).triangles, &operation);
    std::size_t taken = 0;
    return expect("    {{") &&
           take_elements(owners.size(), "triangles",
                         [&](std::string_view& line) {
                           const Operation& operation = *owners[taken++];
                           return take_triangle(line, operation.*of, operation.vertices);
                         }) &&
           expect("    }},");
  }

  static bool take_triangle(std::string_view& line, const Side& side, unsigned vertices) {
    const auto below = [](std::uint64_t count) { return [=](std::uint64_t number) { return number < count; }; };
    const auto is_side = [&](std::uint64_t number) {
      return number < side.inner_edges() || number == boundary_side ||
             (number >= first_port_side && number < first_port_side + side.ports());
    };
    const auto take_three = [](std::string_view& rest, const auto& fits) {
      return take(rest, "{") && take_number(rest, fits) && take(rest, ", ") && take_number(rest, fits) &&
             take(rest, ", ") && take_number(rest, fits) && take(rest, "}");
    };
    return take(line, "{") && take_number(line, below(side.triangles)) && take(line, ", ") &&
           take_number(line, below(3)) && take(line, ", ") && take_three(line, below(vertices)) && take(line, ", ") &&
           take_three(line, is_side) && take(line, "}");
  }

  void fail(const std::string& expected, std::string_view found) {
    check_.wrong.add(fmt::format("{}:{}: expected {}, found \"{}\"; make the header anew from the operation file",
                                 file_, check_.lines, shown(expected), shown(found.substr(0, 200))));
  }

  const std::string& file_;
  std::string_view rest_;
  const Description& description_;
  std::vector<Operation> operations_;  ///< at all positions
  HeaderCheck& check_;
};

}  // namespace

HeaderCheck check_operation_header(const std::string& file, std::string_view text, const Description& description,
                                   unsigned max_k) {
  HeaderCheck check;
  HeaderReader(file, text, description, max_k, check).read();
  return check;
}

}  // namespace restrip::verify
