#include "turn_certificate.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "certificate_form.hpp"
#include "input.hpp"
#include "row_reader.hpp"

namespace restrip::verify {
namespace {

/// Reads the rows of both sections.
class TurnParser {
 public:
  TurnParser(LineReader& reader, TurnCertificate& result) : rows_(reader), reader_(reader), result_(result) {}

  std::size_t read() {
    rows_.begin_section("cost", "weights");
    read_weights();
    rows_.end_section();
    rows_.begin_section("classes", "class");
    while (reader_.starts_with("class")) read_class();
    check_targets();
    rows_.end_section();
    return result_.rows = rows_.rows();
  }

 private:
  static constexpr std::int64_t most_weight = 1000;
  static constexpr std::size_t most_classes = 65536;

  int number_at(std::size_t word, std::int64_t least, std::int64_t most) const {
    return static_cast<int>(rows_.number_at(word, least, most));
  }

  std::size_t case_at(std::size_t word) const { return rows_.case_at(word, turn_number); }

  void read_weights() {
    reader_.expect_words(4, "\"weights\" restart swap isolated");
    result_.weights = {number_at(1, 1, most_weight), number_at(2, 0, most_weight), number_at(3, 0, most_weight)};
    rows_.next();
  }

  void read_class() {
    const std::size_t c = result_.classes.size();
    reader_.expect_words(3, "\"class\" number witness");
    rows_.expect_number(1, c);
    TurnClass& made = result_.classes.emplace_back();
    made.line = reader_.line();
    const std::string_view witness = reader_.words()[2];
    if (witness != "-") made.witness = witness;
    if (made.witness.find_first_not_of(turn_letters) != std::string::npos || made.witness.empty() != (c == 0))
      reader_.fail(fmt::format("\"{}\" is no witness of class {}", witness, c));
    rows_.next();
    std::optional<std::size_t> last;
    for (; reader_.starts_with("value"); rows_.next()) {
      reader_.expect_words(4, "\"value\" class case cost");
      rows_.expect_number(1, c);
      const std::size_t number = case_at(2);
      if (last && number <= *last) reader_.fail("expected values in the order of cases");
      last = number;
      made.costs[number] = number_at(3, 0, 100 * most_weight);
    }
    if (!made.costs[both_dashed]) reader_.fail(fmt::format("expected the value of case -- of class {}", c));
    for (const char letter : turn_letters) read_step(c, letter);
  }

  void read_step(std::size_t c, char letter) {
    if (!reader_.starts_with("step"))
      reader_.fail(fmt::format("expected the step of class {} by {}, found \"{}\"", c, letter, reader_.rest(0)));
    reader_.expect_words(5, "\"step\" class letter class cost");
    rows_.expect_number(1, c);
    rows_.expect_letter(2, letter);
    TurnStep& step = result_.classes[c].steps[turn_letters.find(letter)];
    step.line = reader_.line();
    step.to = static_cast<std::size_t>(number_at(3, 0, most_classes - 1));
    step.cost = number_at(4, -100 * most_weight, 100 * most_weight);
    rows_.next();
    Mask given = 0;
    for (; reader_.starts_with("from"); rows_.next()) {
      reader_.expect_words(5, "\"from\" class letter case case");
      rows_.expect_number(1, c);
      rows_.expect_letter(2, letter);
      const std::size_t after = case_at(3);
      if (high_part(given, static_cast<unsigned>(after)) != 0) reader_.fail("expected origins in the order of cases");
      step.from[after] = case_at(4);
      given |= single(static_cast<unsigned>(after));
    }
    given_.push_back(given);
  }

  /// Every step leads to a class that is there, and says where each of its cases came from.
  void check_targets() const {
    for (std::size_t c = 0; c < result_.classes.size(); ++c)
      for (std::size_t letter = 0; letter < turn_letters.size(); ++letter) {
        const TurnStep& step = result_.classes[c].steps[letter];
        if (step.to >= result_.classes.size())
          throw InputError(result_.file, step.line, fmt::format("there is no class {}", step.to));
        Mask wanted = 0;
        for (unsigned k = 0; k < turn_cases; ++k)
          if (result_.classes[step.to].costs[k]) wanted |= single(k);
        if (given_[turn_letters.size() * c + letter] != wanted)
          throw InputError(result_.file, step.line,
                           fmt::format("expected a row \"from\" for each case of class {} and for no other", step.to));
      }
  }

  RowReader rows_;
  LineReader& reader_;
  TurnCertificate& result_;
  std::vector<Mask> given_;  ///< cases with an origin, by class and letter
};

}  // namespace

TurnCertificate parse_turn_automaton(const std::string& file, std::string text) {
  TurnCertificate result;
  result.file = file;
  parse_form(file, std::move(text), family_head("index-automaton"),
             [&](LineReader& reader) { return TurnParser(reader, result).read(); });
  return result;
}

}  // namespace restrip::verify
