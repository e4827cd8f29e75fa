#include "automaton/row_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "automaton/arc.hpp"
#include "certificate/certificate_form.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<const char*, 1> row_claim_words = {"rows"};

}  // namespace

void RowReader::begin_section(const std::string& name, const char* first_row) {
  std::array<StatedClaim, 1> claims;
  const std::array<const char*, 1> rows = {first_row};
  parse_section_head(lines_, name, row_claim_words, claims, rows);
  section_ = name;
  section_start_ = rows_;
  claimed_ = static_cast<std::size_t>(claims[0].number);
}

void RowReader::end_section() const {
  if (const std::size_t found = rows_ - section_start_; found != claimed_)
    lines_.fail(fmt::format("section {} claims {} rows and has {} before this line", section_, claimed_, found));
}

void RowReader::next() {
  ++rows_;
  lines_.next("a row, a section or \"end\"");
}

std::int64_t RowReader::number_at(std::size_t word, std::int64_t least, std::int64_t most, const char* what) const {
  const std::int64_t n = lines_.number(word);
  if (n < least || n > most) lines_.fail(fmt::format("expected {} from {} to {}, found {}", what, least, most, n));
  return n;
}

void RowReader::expect_number(std::size_t word, std::size_t n) const {
  if (lines_.number(word) != static_cast<std::int64_t>(n))
    lines_.fail(fmt::format("expected {}, found {}", n, lines_.words()[word]));
}

void RowReader::expect_letter(std::size_t word, char letter) const {
  if (lines_.words()[word] != std::string_view(&letter, 1))
    lines_.fail(fmt::format("expected the letter {}, found \"{}\"", letter, lines_.words()[word]));
}

std::size_t RowReader::case_at(std::size_t word) const {
  const std::string_view text = lines_.words()[word];
  const auto number = text.size() == 2 ? number_of({text[0], text[1]}) : std::nullopt;
  if (!number) lines_.fail(fmt::format("\"{}\" is no case", text));
  return *number;
}

}  // namespace restrip::verify
