#include "automaton/automaton_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "automaton/row_reader.hpp"
#include "certificate/certificate_form.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

/// Reads the rows of one section after the other.
class Parser {
 public:
  Parser(LineReader& reader, AutomatonCertificate& result) : rows_(reader), reader_(reader), result_(result) {}

  std::size_t read() {
    rows_.begin_section("cost", "weights");
    reader_.expect_words(4, "\"weights\" restart swap isolated");
    result_.weights = {number_at(1, 1, most_weight), number_at(2, 0, most_weight), number_at(3, 0, most_weight)};
    rows_.next();
    rows_.end_section();
    rows_.begin_section("classes", "class");
    while (reader_.starts_with("class")) read_class();
    check_targets();
    rows_.end_section();
    rows_.begin_section("closings", "close");
    read_closings();
    rows_.end_section();
    rows_.begin_section("meetings", "meet");
    read_meetings();
    rows_.end_section();
    return result_.rows = rows_.rows();
  }

 private:
  static constexpr std::int64_t most_weight = 1000;
  static constexpr std::int64_t most_cost = 100 * most_weight;
  static constexpr std::int64_t most_classes = 65535;

  int number_at(std::size_t word, std::int64_t least, std::int64_t most) const {
    return static_cast<int>(rows_.number_at(word, least, most));
  }

  /// A row or column of meetings: the next new one, or one that was there before.
  std::optional<std::size_t> line_at(std::size_t word, bool wanted, std::size_t& lines) {
    if (!wanted) {
      if (reader_.words()[word] != "-") reader_.fail(fmt::format("expected -, found \"{}\"", reader_.words()[word]));
      return {};
    }
    const auto line = static_cast<std::size_t>(rows_.number_at(word, 0, static_cast<std::int64_t>(lines)));
    lines = std::max(lines, line + 1);
    return line;
  }

  void read_class() {
    const std::size_t c = result_.classes.size();
    reader_.expect_words(5, "\"class\" number witness row column");
    rows_.expect_number(1, c);
    AutomatonClass& made = result_.classes.emplace_back();
    made.line = reader_.line();
    const std::string_view witness = reader_.words()[2];
    if (witness != "-") made.witness = witness;
    const std::string_view letters = letters_of(result_.weights);
    if (made.witness.find_first_not_of(letters) != std::string::npos ||
        std::count_if(made.witness.begin(), made.witness.end(), is_boundary) > 1 || made.witness.empty() != (c == 0))
      reader_.fail(fmt::format("\"{}\" is no witness of class {}", witness, c));
    made.as_first = line_at(3, c != 0 && !made.has_boundary(), meeting_rows_);
    made.as_second = line_at(4, c != 0, meeting_columns_);
    rows_.next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("value"); rows_.next()) {
      reader_.expect_words(4, "\"value\" class case cost");
      rows_.expect_number(1, c);
      const std::size_t number = rows_.case_at(2);
      if (last && number <= *last) reader_.fail("expected values in the order of cases");
      last = number;
      made.costs[number] = number_at(3, 0, most_cost);
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
    rows_.expect_number(1, c);
    rows_.expect_letter(2, letter);
    AutomatonStep& step = result_.classes[c].steps.back().emplace();
    step.line = reader_.line();
    step.to = static_cast<std::size_t>(rows_.number_at(3, 0, most_classes - 1, "a class"));
    step.cost = number_at(4, -most_cost, most_cost);
    rows_.next();
    for (; reader_.starts_with("from"); rows_.next()) {
      reader_.expect_words(5, "\"from\" class letter case case");
      rows_.expect_number(1, c);
      rows_.expect_letter(2, letter);
      const std::size_t after = rows_.case_at(3);
      if (high_part(given_.back(), static_cast<unsigned>(after)) != 0)
        reader_.fail("expected origins in the order of cases");
      step.from[after] = rows_.case_at(4);
      given_.back() |= single(static_cast<unsigned>(after));
    }
  }

  /// Every step leads to a class that is there, and says where each of its cases came from.
  void check_targets() const {
    for (std::size_t c = 0, n = 0; c < result_.classes.size(); ++c)
      for (const auto& step : result_.classes[c].steps) {
        const Mask given = given_[n++];
        if (!step) continue;
        if (step->to >= result_.classes.size())
          throw InputError(result_.file, step->line, fmt::format("there is no class {}", step->to));
        Mask wanted = 0;
        for (unsigned k = 0; k < case_count; ++k)
          if (result_.classes[step->to].costs[k]) wanted |= single(k);
        if (given != wanted)
          throw InputError(result_.file, step->line,
                           fmt::format("expected a row \"from\" for each case of class {} and for no other", step->to));
      }
  }

  void read_closings() {
    result_.closings.resize(result_.classes.size());
    for (std::size_t c = 0; c < result_.classes.size(); ++c) {
      if (!result_.classes[c].as_second || (result_.classes[c].has_boundary() && !result_.weights.tells_turns()))
        continue;
      if (!reader_.starts_with("close"))
        reader_.fail(fmt::format("expected the closing of class {}, found \"{}\"", c, reader_.rest(0)));
      reader_.expect_words(3, "\"close\" class case");
      rows_.expect_number(1, c);
      result_.closings[c] = {rows_.case_at(2), reader_.line()};
      rows_.next();
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
        rows_.expect_number(1, x);
        rows_.expect_number(2, y);
        const std::string_view chord = reader_.words()[5];
        if (chord != "chord" && chord != "-")
          reader_.fail(fmt::format("expected \"chord\" or \"-\", found \"{}\"", chord));
        result_.meetings[x].push_back({rows_.case_at(3), rows_.case_at(4), chord == "chord", reader_.line()});
        rows_.next();
      }
  }

  RowReader rows_;
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
  parse_form(file, std::move(text), family_head("automaton"),
             [&](LineReader& reader) { return Parser(reader, result).read(); });
  return result;
}

}  // namespace restrip::verify
