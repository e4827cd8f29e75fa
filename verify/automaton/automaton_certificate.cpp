#include "automaton/automaton_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "certificate/certificate_form.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<const char*, 1> row_claim_words = {"rows"};

/// Reads the rows of each section and counts them.
class Parser {
 public:
  Parser(LineReader& reader, AutomatonCertificate& result) : reader_(reader), result_(result) {}

  std::size_t read() {
    read_section("cost", "weights", [&] {
      reader_.expect_words(4, "\"weights\" restart swap isolated");
      expect_number(1, strip_cost);
      expect_number(2, 0);
      expect_number(3, isolated_cost);
      next();
    });
    read_section("classes", "class", [&] {
      while (reader_.starts_with("class")) read_class();
      check_targets();
    });
    result_.closings.resize(result_.classes.size());
    read_section("closings", "close", [&] { read_closings(); });
    read_section("meetings", "meet", [&] { read_meetings(); });
    return result_.rows;
  }

 private:
  static constexpr std::int64_t most_cost = std::int64_t{100} * strip_cost;
  static constexpr std::int64_t most_classes = 65535;

  /// Reads a section, whose first row starts with `first_row`. The number of its rows must equal the claim in its head.
  template <class ReadRows>
  void read_section(const std::string& name, const char* first_row, const ReadRows& read_rows) {
    std::array<StatedClaim, 1> claims;
    const std::array<const char*, 1> rows = {first_row};
    parse_section_head(reader_, name, row_claim_words, claims, rows);
    const std::size_t before = result_.rows;
    read_rows();
    const std::int64_t claimed = claims[0].number;
    if (const auto found = static_cast<std::int64_t>(result_.rows - before); found != claimed)
      reader_.fail(fmt::format("section {} claims {} rows and has {} before this line", name, claimed, found));
  }
  /// Counts the row that was read and continues to the next line.
  void next() {
    ++result_.rows;
    reader_.next("a row, a section or \"end\"");
  }

  /// A number from `least` to `most`; `what` is its name in the error.
  std::int64_t number_at(std::size_t word, std::int64_t least, std::int64_t most, const char* what = "a number") const {
    const std::int64_t n = reader_.number(word);
    if (n < least || n > most) reader_.fail(fmt::format("expected {} from {} to {}, found {}", what, least, most, n));
    return n;
  }
  void expect_number(std::size_t word, std::size_t n) const {
    if (reader_.number(word) != static_cast<std::int64_t>(n))
      reader_.fail(fmt::format("expected {}, found {}", n, reader_.words()[word]));
  }
  void expect_letter(std::size_t word, char letter) const {
    if (reader_.words()[word] != std::string_view(&letter, 1))
      reader_.fail(fmt::format("expected the letter {}, found \"{}\"", letter, reader_.words()[word]));
  }
  /// The number of the case that two letters name.
  std::size_t case_at(std::size_t word) const {
    const std::string_view text = reader_.words()[word];
    const auto number = text.size() == 2 ? number_of({text[0], text[1]}) : std::nullopt;
    if (!number) reader_.fail(fmt::format("\"{}\" is not a case", text));
    return *number;
  }

  /// A row or column of meetings: the next new one, or an earlier one.
  std::optional<std::size_t> line_at(std::size_t word, bool wanted, std::size_t& lines) {
    if (!wanted) {
      if (reader_.words()[word] != "-") reader_.fail(fmt::format("expected -, found \"{}\"", reader_.words()[word]));
      return {};
    }
    const auto line = static_cast<std::size_t>(number_at(word, 0, static_cast<std::int64_t>(lines)));
    lines = std::max(lines, line + 1);
    return line;
  }

  void read_class() {
    const std::size_t c = result_.classes.size();
    reader_.expect_words(5, "\"class\" number witness row column");
    expect_number(1, c);
    AutomatonClass& made = result_.classes.emplace_back();
    made.line = reader_.line();
    const std::string_view witness = reader_.words()[2];
    if (witness != "-") made.witness = witness;
    if (made.witness.find_first_not_of(letters) != std::string::npos ||
        std::count_if(made.witness.begin(), made.witness.end(), is_boundary) > 1 || made.witness.empty() != (c == 0))
      reader_.fail(fmt::format("\"{}\" is not a witness of class {}", witness, c));
    made.as_first = line_at(3, c != 0 && !made.has_boundary(), meeting_rows_);
    made.as_second = line_at(4, c != 0, meeting_columns_);
    next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("value"); next()) {
      reader_.expect_words(4, "\"value\" class case cost");
      expect_number(1, c);
      const std::size_t number = case_at(2);
      if (last && number <= *last) reader_.fail("expected values in the order of cases");
      last = number;
      made.costs[number] = static_cast<int>(number_at(3, 0, most_cost));
    }
    if (!last) reader_.fail(fmt::format("expected a value of class {}", c));
    for (const char letter : letters) {
      made.steps.emplace_back();
      given_.emplace_back();
      if (!is_boundary(letter) || !made.has_boundary()) read_step(c, letter);
    }
  }

  void read_step(std::size_t c, char letter) {
    if (!reader_.starts_with("step"))
      reader_.fail(fmt::format("expected the step of class {} by {}, found \"{}\"", c, letter, reader_.rest(0)));
    reader_.expect_words(5, "\"step\" class letter class cost");
    expect_number(1, c);
    expect_letter(2, letter);
    AutomatonStep& step = result_.classes[c].steps.back().emplace();
    step.line = reader_.line();
    step.to = static_cast<std::size_t>(number_at(3, 0, most_classes - 1, "a class"));
    step.cost = static_cast<int>(number_at(4, -most_cost, most_cost));
    next();
    for (; reader_.starts_with("from"); next()) {
      reader_.expect_words(5, "\"from\" class letter case case");
      expect_number(1, c);
      expect_letter(2, letter);
      const std::size_t after = case_at(3);
      if (high_part(given_.back(), static_cast<unsigned>(after)) != 0)
        reader_.fail("expected origins in the order of cases");
      step.from[after] = case_at(4);
      given_.back() |= single(static_cast<unsigned>(after));
    }
  }

  /// Every step must lead to an existing class and give the origin of each of its cases.
  void check_targets() const {
    for (std::size_t c = 0, n = 0; c < result_.classes.size(); ++c)
      for (const auto& step : result_.classes[c].steps) {
        const Mask given = given_[n++];
        if (!step) continue;
        if (step->to >= result_.classes.size())
          throw InputError(result_.file, step->line, fmt::format("class {} does not exist", step->to));
        Mask wanted = 0;
        for (unsigned k = 0; k < case_count; ++k)
          if (result_.classes[step->to].costs[k]) wanted |= single(k);
        if (given != wanted)
          throw InputError(result_.file, step->line,
                           fmt::format("expected a row \"from\" for each case of class {} and for no other", step->to));
      }
  }

  void read_closings() {
    for (std::size_t c = 0; c < result_.classes.size(); ++c) {
      if (!result_.classes[c].as_second || result_.classes[c].has_boundary()) continue;
      if (!reader_.starts_with("close"))
        reader_.fail(fmt::format("expected the closing of class {}, found \"{}\"", c, reader_.rest(0)));
      reader_.expect_words(3, "\"close\" class case");
      expect_number(1, c);
      result_.closings[c] = {case_at(2), reader_.line()};
      next();
    }
  }

  void read_meetings() {
    result_.meetings.resize(meeting_rows_);
    for (std::size_t x = 0; x < meeting_rows_; ++x)
      for (std::size_t y = 0; y < meeting_columns_; ++y) {
        if (!reader_.starts_with("meet"))
          reader_.fail(
              fmt::format("expected the meeting of row {} and column {}, found \"{}\"", x, y, reader_.rest(0)));
        reader_.expect_words(6, "\"meet\" row column case case chord");
        expect_number(1, x);
        expect_number(2, y);
        const std::string_view chord = reader_.words()[5];
        if (chord != "chord" && chord != "-")
          reader_.fail(fmt::format("expected \"chord\" or \"-\", found \"{}\"", chord));
        result_.meetings[x].push_back({case_at(3), case_at(4), chord == "chord", reader_.line()});
        next();
      }
  }

  LineReader& reader_;
  AutomatonCertificate& result_;
  std::vector<Mask> given_;  ///< cases with an origin, by class and letter
  std::size_t meeting_rows_ = 0;
  std::size_t meeting_columns_ = 0;
};

}  // namespace

AutomatonCertificate parse_automaton(const std::string& file, std::string text) {
  AutomatonCertificate result;
  result.file = file;
  parse_form(file, std::move(text), {"restrip-certificate 2", "family automaton"},
             [&](LineReader& reader) { return Parser(reader, result).read(); });
  return result;
}

}  // namespace restrip::verify
