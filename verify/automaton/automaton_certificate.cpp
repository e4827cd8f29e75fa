#include "automaton_certificate.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "certificate_form.hpp"
#include "input.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<const char*, 1> automaton_claim_words = {"rows"};

/// Reads the rows of one section after the other.
class Parser {
 public:
  Parser(LineReader& reader, AutomatonCertificate& result) : reader_(reader), result_(result) {}

  std::size_t read() {
    const std::size_t classes = section("classes", "class");
    while (reader_.starts_with("class")) read_class();
    check_targets();
    check_rows("classes", classes);
    const std::size_t closings = section("closings", "close");
    read_closings();
    check_rows("closings", closings);
    const std::size_t meetings = section("meetings", "meet");
    read_meetings();
    check_rows("meetings", meetings);
    return result_.rows;
  }

 private:
  /// The head of a section; returns how many rows it claims.
  std::size_t section(const std::string& name, const char* first_row) {
    std::array<StatedClaim, 1> claims;
    const std::array<const char*, 1> rows = {first_row};
    parse_section_head(reader_, name, automaton_claim_words, claims, rows);
    section_start_ = result_.rows;
    return static_cast<std::size_t>(claims[0].number);
  }

  void check_rows(const std::string& name, std::size_t claimed) {
    const std::size_t found = result_.rows - section_start_;
    if (found != claimed)
      reader_.fail(fmt::format("section {} claims {} rows and has {} before this line", name, claimed, found));
  }

  void next() {
    ++result_.rows;
    reader_.next("a row, a section or \"end\"");
  }

  std::size_t natural(std::size_t word, std::size_t end, const char* what) const {
    const std::int64_t n = reader_.number(word);
    if (n < 0 || static_cast<std::size_t>(n) >= end)
      reader_.fail(fmt::format("expected {} from 0 to {}, found {}", what, end - 1, n));
    return static_cast<std::size_t>(n);
  }

  /// The number that must stand here.
  void expect_number(std::size_t word, std::size_t n) const {
    if (reader_.number(word) != static_cast<std::int64_t>(n))
      reader_.fail(fmt::format("expected {}, found {}", n, reader_.words()[word]));
  }

  std::size_t case_at(std::size_t word) const {
    const std::string_view text = reader_.words()[word];
    const auto number = text.size() == 2 ? number_of({text[0], text[1]}) : std::nullopt;
    if (!number) reader_.fail(fmt::format("\"{}\" is no case", text));
    return *number;
  }

  Worth worth_at(std::size_t word) const {
    return {static_cast<int>(reader_.number(word)), -static_cast<int>(reader_.number(word + 1))};
  }

  void read_class() {
    const std::size_t c = result_.classes.size();
    reader_.expect_words(3, "\"class\" number witness");
    expect_number(1, c);
    AutomatonClass& made = result_.classes.emplace_back();
    made.line = reader_.line();
    const std::string_view witness = reader_.words()[2];
    if (witness != "-") made.witness = witness;
    if (made.witness.find_first_not_of(letters) != std::string::npos || made.witness.size() > longest_witness ||
        made.witness.find('b') != made.witness.rfind('b') || made.witness.empty() != (c == 0))
      reader_.fail(fmt::format("\"{}\" is no witness of class {}", witness, c));
    next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("value"); next()) {
      reader_.expect_words(5, "\"value\" class case solid isolated");
      expect_number(1, c);
      const std::size_t number = case_at(2);
      if (last && number <= *last) reader_.fail("expected values in the order of cases");
      last = number;
      made.values[number] = worth_at(3);
    }
    if (!last) reader_.fail(fmt::format("expected a value of class {}", c));
    for (std::size_t letter = 0; letter < letters.size(); ++letter)
      if (letters[letter] != 'b' || !made.has_boundary()) read_step(c, letter);
  }

  void expect_letter(std::size_t letter) const {
    if (reader_.words()[2] != letters.substr(letter, 1))
      reader_.fail(fmt::format("expected the letter {}, found \"{}\"", letters[letter], reader_.words()[2]));
  }

  void read_step(std::size_t c, std::size_t letter) {
    if (!reader_.starts_with("step"))
      reader_.fail(
          fmt::format("expected the step of class {} by {}, found \"{}\"", c, letters[letter], reader_.rest(0)));
    reader_.expect_words(6, "\"step\" class letter class solid isolated");
    expect_number(1, c);
    expect_letter(letter);
    AutomatonStep& step = result_.classes[c].steps[letter].emplace();
    step.line = reader_.line();
    step.to = natural(3, most_classes, "a class");
    step.gain = worth_at(4);
    next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("from"); next()) {
      reader_.expect_words(5, "\"from\" class letter case case");
      expect_number(1, c);
      expect_letter(letter);
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
      expect_number(1, c);
      result_.closings[c] = {case_at(2), worth_at(3), reader_.line()};
      next();
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
        expect_number(1, x);
        expect_number(2, y);
        const std::string_view chord = reader_.words()[5];
        if (chord != "chord" && chord != "-")
          reader_.fail(fmt::format("expected \"chord\" or \"-\", found \"{}\"", chord));
        result_.meetings[x][y] = {case_at(3), case_at(4), chord == "chord", worth_at(6), reader_.line()};
        next();
      }
  }

  static constexpr std::size_t most_classes = 255;
  static constexpr std::size_t longest_witness = 16;

  LineReader& reader_;
  AutomatonCertificate& result_;
  std::size_t section_start_ = 0;
  std::map<std::pair<std::size_t, std::size_t>, Mask> given_;  ///< cases with an origin, by class and letter
};

}  // namespace

AutomatonCertificate parse_automaton(const std::string& file, std::string text) {
  AutomatonCertificate result;
  result.file = file;
  parse_form(file, std::move(text), "automaton", [&](LineReader& reader) { return Parser(reader, result).read(); });
  return result;
}

}  // namespace restrip::verify
