#include "certificate/certificate_form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

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

ByteSums sums_of(std::string_view bytes) {
  ByteSums sums;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    sums.plain += byte;
    sums.weighted += (i + 1) * byte;
  }
  return sums;
}

std::optional<BytePosition> altered_byte(std::string_view certificate) {
  if (certificate.size() < 2) return {};
  const std::size_t end = certificate.rfind('\n', certificate.size() - 2) + 1;
  const std::string_view body = certificate.substr(0, end);
  std::istringstream words{std::string(certificate.substr(end))};
  std::string word;
  std::uint64_t rows = 0;
  ByteSums stated;
  if (!(words >> word >> rows >> stated.plain >> stated.weighted) || word != "end") return {};

  // One byte that grew by d at number n adds d to one sum and n d to the other.
  const ByteSums found = sums_of(body);
  const auto grown = static_cast<std::int64_t>(found.plain - stated.plain);
  const auto weighted = static_cast<std::int64_t>(found.weighted - stated.weighted);
  const auto most = static_cast<std::int64_t>(255 * body.size());
  if (grown == 0 || grown < -255 || grown > 255 || weighted < -most || weighted > most || weighted % grown != 0)
    return {};
  const std::int64_t number = weighted / grown;
  if (number < 1 || number > static_cast<std::int64_t>(body.size())) return {};
  const std::string_view before = body.substr(0, static_cast<std::size_t>(number - 1));
  const std::size_t line_start = before.rfind('\n') + 1;
  return BytePosition{static_cast<unsigned>(std::count(before.begin(), before.end(), '\n') + 1),
                      static_cast<unsigned>(before.size() - line_start + 1)};
}

}  // namespace restrip::verify
