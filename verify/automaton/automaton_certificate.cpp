#include "automaton_certificate.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "certificate_form.hpp"
#include "input.hpp"
#include "row_reader.hpp"

namespace restrip::verify {
namespace {

/// Reads the rows of one section after the other.
class Parser {
 public:
  Parser(LineReader& reader, AutomatonCertificate& result) : rows_(reader), reader_(reader), result_(result) {}

  std::size_t read() {
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
  std::size_t case_at(std::size_t word) const { return rows_.case_at(word, number_of); }

  Worth worth_at(std::size_t word) const {
    return {static_cast<int>(reader_.number(word)), -static_cast<int>(reader_.number(word + 1))};
  }

  void read_class() {
    const std::size_t c = result_.classes.size();
    reader_.expect_words(3, "\"class\" number witness");
    rows_.expect_number(1, c);
    AutomatonClass& made = result_.classes.emplace_back();
    made.line = reader_.line();
    const std::string_view witness = reader_.words()[2];
    if (witness != "-") made.witness = witness;
    if (made.witness.find_first_not_of(letters) != std::string::npos || made.witness.size() > longest_witness ||
        made.witness.find('b') != made.witness.rfind('b') || made.witness.empty() != (c == 0))
      reader_.fail(fmt::format("\"{}\" is no witness of class {}", witness, c));
    rows_.next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("value"); rows_.next()) {
      reader_.expect_words(5, "\"value\" class case solid isolated");
      rows_.expect_number(1, c);
      const std::size_t number = case_at(2);
      if (last && number <= *last) reader_.fail("expected values in the order of cases");
      last = number;
      made.values[number] = worth_at(3);
    }
    if (!last) reader_.fail(fmt::format("expected a value of class {}", c));
    for (std::size_t letter = 0; letter < letters.size(); ++letter)
      if (letters[letter] != 'b' || !made.has_boundary()) read_step(c, letter);
  }

  void read_step(std::size_t c, std::size_t letter) {
    if (!reader_.starts_with("step"))
      reader_.fail(
          fmt::format("expected the step of class {} by {}, found \"{}\"", c, letters[letter], reader_.rest(0)));
    reader_.expect_words(6, "\"step\" class letter class solid isolated");
    rows_.expect_number(1, c);
    rows_.expect_letter(2, letters[letter]);
    AutomatonStep& step = result_.classes[c].steps[letter].emplace();
    step.line = reader_.line();
    step.to = static_cast<std::size_t>(rows_.number_at(3, 0, most_classes - 1, "a class"));
    step.gain = worth_at(4);
    rows_.next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("from"); rows_.next()) {
      reader_.expect_words(5, "\"from\" class letter case case");
      rows_.expect_number(1, c);
      rows_.expect_letter(2, letters[letter]);
      const std::size_t after = case_at(3);
      if (last && after <= *last) reader_.fail("expected origins in the order of cases");
      last = after;
      step.from[after] = case_at(4);
      given_[{c, letter}] |= single(static_cast<unsigned>(after));
    }
  }

  /// Every step leads to a class that is there, and says where each of its cases came from.
  void check_targets() const {
    for (std::size_t c = 0; c < result_.classes.size(); ++c)
      for (std::size_t letter = 0; letter < letters.size(); ++letter) {
        const auto& step = result_.classes[c].steps[letter];
        if (!step) continue;
        if (step->to >= result_.classes.size())
          throw InputError(result_.file, step->line, fmt::format("there is no class {}", step->to));
        Mask wanted = 0;
        for (unsigned k = 0; k < all_cases.size(); ++k)
          if (result_.classes[step->to].values[k]) wanted |= single(k);
        const auto given = given_.find({c, letter});
        if (given == given_.end() || given->second != wanted)
          throw InputError(result_.file, step->line,
                           fmt::format("expected a row \"from\" for each case of class {} and for no other", step->to));
      }
  }

  void read_closings() {
    result_.closings.resize(result_.classes.size());
    for (std::size_t c = 0; c < result_.classes.size(); ++c) {
      if (!result_.can_be_first(c)) continue;
      if (!reader_.starts_with("close"))
        reader_.fail(fmt::format("expected the closing of class {}, found \"{}\"", c, reader_.rest(0)));
      reader_.expect_words(5, "\"close\" class case solid isolated");
      rows_.expect_number(1, c);
      result_.closings[c] = {case_at(2), worth_at(3), reader_.line()};
      rows_.next();
    }
  }

  void read_meetings() {
    const std::size_t n = result_.classes.size();
    result_.meetings.assign(n, std::vector<std::optional<AutomatonMeeting>>(n));
    for (std::size_t x = 0; x < n; ++x)
      for (std::size_t y = 1; result_.can_be_first(x) && y < n; ++y) {
        if (!reader_.starts_with("meet"))
          reader_.fail(fmt::format("expected the meeting of classes {} and {}, found \"{}\"", x, y, reader_.rest(0)));
        reader_.expect_words(8, "\"meet\" class class case case chord solid isolated");
        rows_.expect_number(1, x);
        rows_.expect_number(2, y);
        const std::string_view chord = reader_.words()[5];
        if (chord != "chord" && chord != "-")
          reader_.fail(fmt::format("expected \"chord\" or \"-\", found \"{}\"", chord));
        result_.meetings[x][y] = {case_at(3), case_at(4), chord == "chord", worth_at(6), reader_.line()};
        rows_.next();
      }
  }

  static constexpr std::int64_t most_classes = 255;
  static constexpr std::size_t longest_witness = 16;

  RowReader rows_;
  LineReader& reader_;
  AutomatonCertificate& result_;
  std::map<std::pair<std::size_t, std::size_t>, Mask> given_;  ///< cases with an origin, by class and letter
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
