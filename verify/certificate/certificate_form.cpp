#include "certificate/certificate_form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "certificate/sums.hpp"

namespace restrip::verify {

void parse_form(const std::string& file, std::string text, const std::array<std::string, 2>& head,
                const std::function<std::size_t(LineReader&)>& read_body) {
  const std::optional<BytePosition> altered = altered_byte(text);
  if (altered.has_value())
    throw InputError(
        file, altered->line,
        fmt::format("according to the sums in the last line, byte {} of this line was altered, or more than one byte",
                    altered->byte));
  LineReader reader(file, std::move(text));
  for (const std::string& line : head) {
    reader.next(fmt::format("\"{}\"", line));
    reader.expect_line(line);
  }
  reader.next("a section");
  const std::size_t rows = read_body(reader);
  if (!reader.starts_with("end"))
    reader.fail(
        fmt::format("expected \"end\", found \"{}\"{}", reader.rest(0),
                    reader.starts_with("section") ? "; if the certificate covers larger fans, raise --max-k" : ""));
  reader.expect_words(4, "\"end\" number sum sum");
  if (reader.number(1) != static_cast<std::int64_t>(rows))
    reader.fail(fmt::format("expected \"end {}\", the number of rows of this file", rows));
  if (!reader.at_end()) reader.fail("expected the end of the file after \"end\"");
  const ByteSums sums = sums_of(reader.text_above());
  const bool as_stated = reader.number(2) == static_cast<std::int64_t>(sums.plain) &&
                         reader.number(3) == static_cast<std::int64_t>(sums.weighted);
  if (!as_stated)
    reader.fail(fmt::format("expected {} and {}, the sums of the bytes above", sums.plain, sums.weighted));
}

void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words) {
  if (!reader.starts_with("section") || reader.rest(1) != position)
    reader.fail(fmt::format("expected \"section {}\", found \"{}\"", position, reader.rest(0)));
  reader.next("a claim");
  for (std::size_t i = 0; i < words.size(); ++i, reader.next("a claim or a row")) {
    if (!reader.starts_with("claim") || reader.words().size() != 3 || reader.words()[1] != words[i])
      reader.fail(
          fmt::format("claim {0} missing: expected \"claim {0}\" number, found \"{1}\"", words[i], reader.rest(0)));
    claims[i] = {reader.number(2), reader.line()};
  }
  if (std::find(row_words.begin(), row_words.end(), reader.words().front()) == row_words.end())
    reader.fail(fmt::format("expected \"{}\", found \"{}\"", fmt::join(row_words, "\" or \""), reader.rest(0)));
}

}  // namespace restrip::verify
