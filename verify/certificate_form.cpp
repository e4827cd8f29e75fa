#include "certificate_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "mutants.hpp"
#include "sums.hpp"

namespace restrip::verify {
namespace {

void parse_claim(const LineReader& reader, std::span<const char* const> words, std::span<StatedClaim> claims) {
  reader.expect_words(3, "\"claim\" word number");
  const auto word = std::find(words.begin(), words.end(), reader.words()[1]);
  if (word == words.end()) reader.fail(fmt::format("unknown claim \"{}\"", reader.words()[1]));
  StatedClaim& claim = claims[static_cast<std::size_t>(word - words.begin())];
  if (claim.line != 0) reader.fail(fmt::format("claim {} made twice, first in line {}", *word, claim.line));
  claim = {reader.number(2), reader.line()};
}

void parse_end(const LineReader& reader, std::size_t rows) {
  if (!reader.starts_with("end")) reader.fail(fmt::format("expected \"end\", found \"{}\"", reader.rest(0)));
  reader.expect_words(4, "\"end\" number sum sum");
  if (reader.number(1) != static_cast<std::int64_t>(rows) && !mutated(Mutant::skip_row_count))
    reader.fail(fmt::format("expected \"end {}\", the number of rows of this file", rows));
  if (!reader.at_end()) reader.fail("expected the end of the file after \"end\"");
  const ByteSums sums = sums_of(reader.text_above());
  const bool as_stated = reader.number(2) == static_cast<std::int64_t>(sums.plain) &&
                         reader.number(3) == static_cast<std::int64_t>(sums.weighted);
  if (!as_stated && !mutated(Mutant::skip_sums))
    reader.fail(fmt::format("expected {} and {}, the sums of the bytes above", sums.plain, sums.weighted));
}

}  // namespace

FormHead family_head(const std::string& family) { return {"restrip-certificate 2", "family " + family, "a section"}; }

void parse_form(const std::string& file, std::string text, const FormHead& head,
                const std::function<std::size_t(LineReader&)>& read_body) {
  const std::optional<BytePosition> altered = altered_byte(text);
  if (altered && !mutated(Mutant::skip_sums))
    throw InputError(
        file, altered->line,
        fmt::format("byte {} of this line was altered, or more than one byte: the sums in the last line tell",
                    altered->byte));
  LineReader reader(file, std::move(text));
  for (const std::string& line : {head.title, head.subject}) {
    reader.next(fmt::format("\"{}\"", line));
    reader.expect_line(line);
  }
  reader.next(head.first);
  const std::size_t rows = read_body(reader);
  parse_end(reader, rows);
}

void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words) {
  if (!reader.starts_with("section") || reader.rest(1) != position)
    reader.fail(fmt::format("expected \"section {}\", found \"{}\"", position, reader.rest(0)));
  reader.next("a claim");
  for (; reader.starts_with("claim"); reader.next("a claim or a row")) parse_claim(reader, words, claims);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (claims[i].line == 0) reader.fail(fmt::format("claim {} missing before this line", words[i]));
  if (std::find(row_words.begin(), row_words.end(), reader.words().front()) == row_words.end())
    reader.fail(fmt::format("expected \"{}\", found \"{}\"", fmt::join(row_words, "\" or \""), reader.rest(0)));
}

}  // namespace restrip::verify
