#include "automaton/automaton_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "automaton/fan_check.hpp"
#include "certificate/certificate.hpp"
#include "certificate/stream_lines.hpp"
#include "model/coloring.hpp"
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

namespace {

using NumbersOf = std::vector<std::uint64_t>;

/// A case in the four-bit code of restrip/tables/automaton_format.hpp.
std::uint64_t coded(std::size_t number) {
  constexpr std::string_view reach = "-ept";
  const Case wanted = case_at(number);
  return 4 * reach.find(wanted.left) + reach.find(wanted.right);
}

class AutomatonDumpReader {
 public:
  AutomatonDumpReader(StreamLines& lines, const AutomatonCertificate& certificate, unsigned max_k,
                      AutomatonDumpCheck& check)
      : lines_(lines), certificate_(certificate), max_k_(max_k), check_(check) {}

  void run() {
    lines_.expect("restrip-automaton-dump 2");
    const std::size_t classes = certificate_.classes.size();
    const NumbersOf next = array("next", letters.size() * classes);
    const NumbersOf before = array("before", letters.size() * classes);
    const NumbersOf closed = array("closed", classes);
    first_ = array("first", classes);
    second_ = array("second", classes);
    meet_ = array("meet", {});
    meetings_ = array("meetings", {});
    seconds_ = array("seconds", 1).front();
    for (std::size_t c = 0; c < classes; ++c) compare_class(c, next, before, closed);
    read_answers();
    lines_.expect_last(fmt::format("end {}", entries_));
  }

 private:
  NumbersOf array(const std::string& name, std::optional<std::size_t> size) {
    const std::string head = fmt::format("array {} ", name);
    const std::string_view line = lines_.next(head);
    if (!line.starts_with(head)) lines_.fail(fmt::format("expected \"{}\" and a size, found \"{}\"", head, line));
    const std::uint64_t found = lines_.number_in(line.substr(head.size()), 10);
    if (size && found != *size) lines_.fail(fmt::format("expected {} numbers of {}, found {}", *size, name, found));
    NumbersOf numbers;
    for (std::uint64_t i = 0; i < found; ++i, ++entries_)
      numbers.push_back(lines_.number_in(lines_.next("a number"), 16));
    return numbers;
  }

  template <class Where>
  void compare(std::uint64_t found, std::uint64_t stated, unsigned line, const Where& where) {
    ++check_.numbers;
    if (found != stated)
      check_.wrong_numbers.add(fmt::format("{}: the table holds {}, but line {} of {} gives {}\n", where(), found, line,
                                           certificate_.file, stated));
  }

  void compare_class(std::size_t c, const NumbersOf& next, const NumbersOf& before, const NumbersOf& closed) {
    const AutomatonClass& stated = certificate_.classes[c];
    for (std::size_t letter = 0; letter < stated.steps.size(); ++letter) {
      const std::size_t place = stated.steps.size() * c + letter;
      const auto where = [&](const char* array) { return [=] { return fmt::format("{}[{}]", array, place); }; };
      const auto& step = stated.steps[letter];
      if (!step) continue;
      compare(next[place], step->to, step->line, where("next"));
      const AutomatonClass& to = certificate_.classes[step->to];
      for (std::size_t i = 0; i < case_count; ++i)
        if (to.costs[i]) compare(four_bits(before[place], coded(i)), coded(step->from[i]), step->line, where("before"));
    }
    if (const auto& closing = certificate_.closings[c])
      compare(closed[c], coded(closing->arc), closing->line, [&] { return fmt::format("closed[{}]", c); });
    if (!stated.as_first) return;
    for (std::size_t other = 0; other < certificate_.classes.size(); ++other) {
      if (!certificate_.classes[other].as_second) continue;
      const AutomatonMeeting& met = certificate_.meeting(c, other);
      const std::uint64_t place = seconds_ * first_[c] + second_[other];
      const std::uint64_t found = place < meet_.size() && meet_[place] < meetings_.size() ? meetings_[meet_[place]] : 0;
      compare(found, coded(met.first) + 16 * coded(met.second) + (met.chord ? 256U : 0U), met.line,
              [&] { return fmt::format("the meeting of classes {} and {}", c, other); });
    }
  }

  void read_answers() {
    const AutomatonReader certified(certificate_);
    for (const char* family : {"split", "collapse", "open-split", "boundary-split", "fan-collapse"})
      for (unsigned k = 1; k <= max_k_; ++k)
        for (const FanPlace& place : all_places(k))
          if (place.family == family) read_place(certified, place);
  }

  void read_place(const AutomatonReader& certified, const FanPlace& place) {
    std::string head = fmt::format("answers {} {}", place.family, place.k);
    if (place.family.ends_with("split")) head += fmt::format(" {}", place.a);
    if (place.family == "open-split") head += fmt::format(" {}", place.b);
    const Side patch = patch_after(place.family, {place.k, place.a, place.b});
    std::uint64_t keys = 1;
    for (unsigned i = 0; i < place.k; ++i) keys *= 3;
    head += fmt::format(" keys {} digest ", keys);
    const std::string_view line = lines_.next(head);
    if (!line.starts_with(head)) lines_.fail(fmt::format("expected \"{}\" and a digest, found \"{}\"", head, line));
    ++entries_;
    std::uint64_t digest = 0;
    std::uint64_t changes = 0;
    for (std::uint64_t n = 0; n < keys; ++n) {
      const FanKey key = seen_key(written_key(place.k, n), place);
      const Mask inner = certified.answer(place, key).inner;
      digest = digest * 1000003 + inner;
      changes = changes * 1000003 + std::uint64_t{64} * solid_count(inner) + isolated_of(patch, {inner, key.ports});
    }
    check_.keys += keys;
    if (const std::string right = fmt::format("{}{:x} told {:x}", head, digest, changes); line != right)
      check_.wrong_answers.add(
          fmt::format("line {}: the certificate's answers give\n  {}\nfound\n  {}\n", lines_.number(), right, line));
  }

  StreamLines& lines_;
  const AutomatonCertificate& certificate_;
  unsigned max_k_;
  AutomatonDumpCheck& check_;
  std::uint64_t entries_ = 0;
  NumbersOf first_, second_, meet_, meetings_;
  std::uint64_t seconds_ = 0;
};

}  // namespace

AutomatonDumpCheck check_automaton_dump(std::FILE* stream, const AutomatonCertificate& certificate, unsigned max_k) {
  return found_in<AutomatonDumpCheck>(stream, [&](StreamLines& lines, AutomatonDumpCheck& check) {
    AutomatonDumpReader(lines, certificate, max_k, check).run();
  });
}

AutomatonDumpCheck check_automaton_dump_of(const std::string& program, const AutomatonCertificate& certificate,
                                           unsigned max_k) {
  return checked_output_of(program,
                           [&](std::FILE* stream) { return check_automaton_dump(stream, certificate, max_k); });
}

Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k) {
  constexpr std::array<std::string_view, 5> operations = {"split", "collapse", "open-split", "fan-collapse",
                                                          "boundary-split"};
  constexpr std::uint32_t most_keys = 7000;
  constexpr std::uint32_t drawn_keys = 64;
  const AutomatonReader reader(certificate);
  Digests digests;
  std::uint32_t keys = 1;
  for (unsigned k = 1; k <= max_k; ++k) {
    if (keys <= most_keys) keys *= 3;
    for (const FanPlace& place : all_places(k)) {
      const auto operation = std::find(operations.begin(), operations.end(), place.family) - operations.begin();
      std::uint32_t& digest = digests[fmt::format("{} {} {} {}", operation, k, place.a, place.b)];
      for (std::uint32_t n = 0; n < (keys <= most_keys ? keys : drawn_keys); ++n) {
        const auto drawn = [&](Mask number) { return low_part(mixed_number(n, number, 0), k); };
        const FanKey key = keys <= most_keys ? written_key(k, n) : FanKey{drawn(0), drawn(1)};
        digest += mixed_number(n, key.ports, 0x80000000U | reader.answer(place, seen_key(key, place)).inner);
      }
    }
  }
  return digests;
}

}  // namespace restrip::verify
