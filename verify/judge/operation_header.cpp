#include "judge/operation_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

#include "common/printable.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// All ones.
constexpr std::uint64_t largest_of(unsigned width) { return wide_mask_count(width) - 1; }

/// The number of configurations that the table of an operation answers.
std::uint64_t entries_of(const Operation& operation) {
  return wide_mask_count(operation.ports() +
                         (operation.constraint == Constraint::matching ? 0 : operation.before.inner_edges()));
}

/// A triangle of a header, and the side of an earlier triangle across which it is reached.
struct MetTriangle {
  unsigned from = 0;
  unsigned from_side = 0;
  PlacedTriangle placed;
};

/// The triangle with another corner first.
PlacedTriangle turned(const PlacedTriangle& triangle, unsigned by) {
  PlacedTriangle result;
  for (unsigned s = 0; s < 3; ++s) {
    result.vertex[s] = triangle.vertex[(s + by) % 3];
    result.side[s] = triangle.side[(s + by) % 3];
  }
  return result;
}

/// The triangles of a side in traversal order: across the sides of each in turn, starting from the first.
std::vector<MetTriangle> met_triangles(const std::vector<PlacedTriangle>& placed) {
  std::vector<MetTriangle> met{{0, 0, placed.front()}};
  const auto is_known = [&](const PlacedTriangle& one) {
    return std::any_of(met.begin(), met.end(), [&](const MetTriangle& other) {
      for (unsigned by = 0; by < 3; ++by)
        if (turned(one, by) == other.placed) return true;
      return false;
    });
  };
  for (unsigned i = 0; i < met.size(); ++i)
    for (unsigned s = 0; s < 3; ++s) {
      const unsigned edge = met[i].placed.side[s];
      if (edge >= first_port_side) continue;
      for (const PlacedTriangle& other : placed)
        for (unsigned by = 0; by < 3; ++by)
          if (other.side[by] == edge && !is_known(other)) met.push_back({i, s, turned(other, by)});
    }
  return met;
}

class HeaderReader {
 public:
  HeaderReader(const std::string& file, std::string_view text, const Description& description, unsigned max_k,
               HeaderCheck& check)
      : file_(file), rest_(text), description_(description), check_(check) {
    unsigned bits = 0;
    for (const Numbers& numbers : description.positions(max_k)) {
      const Operation& operation = operations_.emplace_back(description.at(numbers));
      bits = std::max(bits, operation.after.inner_edges() + operation.ports());
      entries_ += entries_of(operation);
    }
    if (operations_.empty())
      throw InputError(description.file(), 0, fmt::format("{} has no position up to {}", description.name, max_k));
    check_.width = bits < 8 ? 8 : (bits < 16 ? 16 : 32);
  }

  /// Stops at the first wrong line.
  void read() {
    const bool good = expect_all(lines_before_entries()) && take_entries() && take_surface() && expect("") &&
                      expect("}  // namespace restrip::tables");
    if (good && !rest_.empty()) fail("the end of the file", rest_.substr(0, rest_.find('\n')));
  }

 private:
  [[nodiscard]] bool is_family() const { return !description_.numbers.empty(); }

  [[nodiscard]] std::vector<std::string> lines_before_entries() const {
    const std::string& name = description_.name;
    std::string variable = name;
    std::replace(variable.begin(), variable.end(), '-', '_');
    variable += "_rules";  // no word of a language, macro or library name
    const Operation& first = operations_.front();
    const bool matching = first.constraint == Constraint::matching;
    unsigned before = 0;  // triangles of all positions
    unsigned after = 0;
    for (const Operation& operation : operations_) {
      before += operation.before.triangles;
      after += operation.after.triangles;
    }
    std::vector<std::string> lines{
        "// " + (description_.about.empty() ? name : description_.about),
        fmt::format("// Written by `restrip-generate rules` from the operation file of {}. Do not edit.", name),
        "// Explained in restrip/tables/operation_format.hpp.",
        "#pragma once",
        "",
        "#include \"restrip/tables/operation_format.hpp\"",
        "",
        "namespace restrip::tables {",
        ""};
    if (!is_family()) {
      lines.insert(lines.end(), {fmt::format("inline constexpr SurfaceOperation<std::uint{}_t, {}, {}, {}> {}{{",
                                             check_.width, entries_, before, after, variable),
                                 fmt::format("    {{{{{}, {}}},", first.before.triangles, first.before.inner_edges()),
                                 fmt::format("    {{{}, {}}},", first.after.triangles, first.after.inner_edges()),
                                 fmt::format("    {},", first.ports()), fmt::format("    {},", matching), "    {"});
      return lines;
    }
    lines.insert(lines.end(), {fmt::format("inline constexpr SurfaceFamily<std::uint{}_t, {}, {}, {}, {}> {}{{",
                                           check_.width, entries_, operations_.size(), before, after, variable),
                               fmt::format("    {{{},", matching), fmt::format("    \"{}\",", position()), "    {{"});
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

  /// As in a string literal: numbers replaced by their places, with backslashes as needed.
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

  /// The next line with its end, or the rest.
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

  /// Reads lines of `count` elements, each after a space and followed by a comma; `take_one` takes the element.
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
    const std::uint64_t none = largest_of(check_.width);
    auto operation = operations_.begin();
    std::uint64_t left = entries_of(*operation);
    return take_elements(entries_, fmt::format("rules of the operation, or {}", none), [&](std::string_view& line) {
      for (; left == 0; left = entries_of(*operation)) ++operation;
      --left;
      return take_number(line, [&](std::uint64_t number) {
        check_.entries.push_back(static_cast<std::uint32_t>(number));
        return number == none || number < wide_mask_count(operation->after.inner_edges() + operation->ports());
      });
    });
  }

  /// The number of vertices and, of a family, the start of the triangles, for each position; then the triangles.
  bool take_surface() {
    std::vector<std::string> lines{"    }},", fmt::format("    {},", operations_.front().vertices)};
    if (is_family()) {
      lines = {"    }},", "    {{"};
      unsigned before = 0;
      unsigned after = 0;
      for (const Operation& operation : operations_) {
        lines.push_back(fmt::format("    {{{}, {}, {}}},", operation.vertices, before, after));
        before += operation.before.triangles;
        after += operation.after.triangles;
      }
      lines.emplace_back("    }},");
    }
    return expect_all(lines) && take_triangles(&Operation::placed_before) && take_triangles(&Operation::placed_after) &&
           expect("};");
  }

  bool take_triangles(std::vector<PlacedTriangle> Operation::*of) {
    std::vector<std::string> texts;
    for (const Operation& operation : operations_)
      for (const MetTriangle& met : met_triangles(operation.*of))
        texts.push_back(fmt::format("{{{}, {}, {{{}}}, {{{}}}}}", met.from, met.from_side,
                                    fmt::join(met.placed.vertex, ", "), fmt::join(met.placed.side, ", ")));
    std::size_t taken = 0;
    const auto take_one = [&](std::string_view& line) { return take(line, texts[taken++]); };
    return expect("    {{") &&
           take_elements(texts.size(), fmt::format("the triangles {}", fmt::join(texts, ", ")), take_one) &&
           expect("    }},");
  }

  void fail(const std::string& expected, std::string_view found) {
    check_.wrong.add(fmt::format("{}:{}: expected {}, found \"{}\"; make the header again from the operation file",
                                 file_, check_.lines, files::printable_ascii(expected),
                                 files::printable_ascii(found.substr(0, 200))));
  }

  const std::string& file_;
  std::string_view rest_;
  const Description& description_;
  std::vector<Operation> operations_;  ///< at all positions
  std::uint64_t entries_ = 0;          ///< of all of them
  HeaderCheck& check_;
};

}  // namespace

HeaderCheck check_operation_header(const std::string& file, std::string_view text, const Description& description,
                                   unsigned max_k) {
  HeaderCheck check;
  HeaderReader(file, text, description, max_k, check).read();
  return check;
}

DumpComparison compare_header(const HeaderCheck& header, const ExpectedDump& expected) {
  std::map<const Operation*, std::uint64_t> first;
  std::map<Numbers, const Operation*> in_order;
  for (const ExpectedTable& table : expected.tables) in_order[table.operation->numbers] = table.operation;
  std::uint64_t entries = 0;
  for (const auto& [numbers, operation] : in_order) {
    first[operation] = entries;
    entries += entries_of(*operation);
  }
  return compare_answers(expected, [&](const Operation& operation, Colors configuration) -> std::optional<Answer> {
    const Mask place = operation.constraint == Constraint::matching
                           ? configuration.ports
                           : concatenated(configuration.inner, configuration.ports, operation.ports());
    const std::uint32_t entry = header.entries.at(first.at(&operation) + place);
    if (entry == largest_of(header.width)) return {};
    return Answer{{high_part(entry, operation.ports()), low_part(entry, operation.ports())}, {}, {}};
  });
}

}  // namespace restrip::verify
