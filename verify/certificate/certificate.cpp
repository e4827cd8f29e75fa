#include "certificate/certificate.hpp"

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

namespace {

constexpr std::array<const char*, 2> row_words = {"rule", "copy"};

/// Reads a reason that starts at word `at` and moves `at` past it. Its edges are below `edges`; `asked` are the edges
/// of the enclosing cases.
Reason parse_reason(const LineReader& reader, std::size_t& at, unsigned edges, Mask asked) {
  const auto word = [&] { return at < reader.words().size() ? reader.words()[at] : "the end of the line"; };
  const auto expect = [&](std::string_view expected) {
    if (word() != expected) reader.fail(fmt::format("expected \"{}\", found \"{}\"", expected, word()));
    ++at;
  };
  const auto is_mask = [&] { return at < reader.words().size() && word() != "else"; };
  Reason reason;
  if (word() == "-") {
    ++at;
  } else if (word() == "if") {
    if (++at == reader.words().size()) reader.fail("expected the number of an edge, found the end of the line");
    const std::int64_t edge = reader.number(at++);
    if (edge < 0 || edge >= edges) reader.fail(fmt::format("expected an edge from 0 to {}, found {}", edges - 1, edge));
    reason.edge = static_cast<unsigned>(edge);
    if (is_solid(asked, reason.edge)) reader.fail(fmt::format("edge {} is already split on", edge));
    asked |= single(reason.edge);
    expect("then");
    reason.cases.push_back(parse_reason(reader, at, edges, asked));
    expect("else");
    reason.cases.push_back(parse_reason(reader, at, edges, asked));
  } else {
    if (!is_mask()) reader.fail(fmt::format("expected a reason, found \"{}\"", word()));
    for (; is_mask(); ++at) reason.sets.push_back(reader.mask(at, edges));
  }
  return reason;
}

Row parse_row(const LineReader& reader, const Operation& operation) {
  const unsigned ports = operation.ports();
  Row row;
  row.line = reader.line();
  row.copy = reader.starts_with("copy");
  if (row.copy)
    reader.expect_words(6 + ports, fmt::format("\"copy\", 4 masks, \"by\" and {} ports", ports));
  else if (reader.words().size() < 7 || reader.words()[5] != "because")
    reader.expect_words(5, "\"rule\" and 4 masks, optionally followed by \"because\" and a reason");
  row.key = {reader.mask(1, ports), {reader.wide_mask(2, ports * (ports - 1) / 2)}};
  row.after = {reader.mask(3, operation.after.inner_edges()), reader.mask(4, ports)};
  if (row.copy) {
    if (reader.words()[5] != "by") reader.fail(fmt::format("expected \"by\", found \"{}\"", reader.words()[5]));
    Mask seen = 0;
    for (std::size_t i = 6; i < reader.words().size(); ++i) {
      const std::int64_t port = reader.number(i);
      if (port < 0 || port >= ports || is_solid(seen, static_cast<unsigned>(port)))
        reader.fail(fmt::format("expected each port from 0 to {} once, found \"{}\"", ports - 1, reader.rest(6)));
      row.by.push_back(static_cast<unsigned>(port));
      seen |= single(row.by.back());
    }
  } else if (std::size_t at = 6; reader.words().size() >= at) {
    if (!may_have_reasons(operation))
      reader.fail("expected no reason: reasons require strips whose cost begins like the default cost");
    row.reason = parse_reason(reader, at, operation.after.inner_edges() + ports, 0);
    if (at != reader.words().size())
      reader.fail(fmt::format("expected the end of the reason, found \"{}\"", reader.rest(at)));
  }
  return row;
}

/// Leaves the reader on the first line after the section. `before` are the sections above.
SectionRows parse_section(LineReader& reader, const Section& section, const std::vector<SectionRows>& before) {
  SectionRows result;
  parse_section_head(reader, section.position, claim_words, result.claims, row_words);
  for (; reader.starts_with("rule") || reader.starts_with("copy"); reader.next("a row, a section or \"end\"")) {
    Row row = parse_row(reader, section.operations.front());
    if (const bool ascending = result.rows.empty() || result.rows.back().key < row.key; !ascending) {
      if (result.rows.back().key == row.key)
        reader.fail(fmt::format("duplicate row: the key {:x} {:x} already has a row in line {}", row.key.ports,
                                row.key.joined.bits, result.rows.back().line));
      reader.fail("expected rows in ascending order of (P, J)");
    }
    const std::vector<Row>& first = before.empty() ? result.rows : before.front().rows;
    const auto rule = std::find_if(first.begin(), first.end(), [](const Row& one) { return !one.copy; });
    if (!row.copy && rule != first.end() && rule->reason.has_value() != row.reason.has_value())
      reader.fail(fmt::format("the rule in line {} has {} reason: expected a reason for all rules or for none",
                              rule->line, rule->reason ? "a" : "no"));
    result.rows.push_back(std::move(row));
  }
  return result;
}

}  // namespace

std::string Reason::text() const {
  if (!cases.empty()) return fmt::format("if {} then {} else {}", edge, cases[0].text(), cases[1].text());
  return sets.empty() ? "-" : fmt::format("{:x}", fmt::join(sets, " "));
}

std::string Row::text() const {
  const std::string masks = fmt::format("{} {:x} {:x} {:x} {:x}", copy ? "copy" : "rule", key.ports, key.joined.bits,
                                        after.inner, after.ports);
  if (copy) return fmt::format("{} by {}", masks, fmt::join(by, " "));
  return reason ? fmt::format("{} because {}", masks, reason->text()) : masks;
}

const Row* SectionRows::row_of(Key key) const {
  const auto place = std::lower_bound(rows.begin(), rows.end(), key, [](const Row& row, Key k) { return row.key < k; });
  return place != rows.end() && place->key == key ? &*place : nullptr;
}

Certificate parse_certificate(const std::string& file, std::string text, const Family& family) {
  Certificate certificate;
  certificate.file = file;
  parse_form(file, std::move(text), {"restrip-certificate 3", "operation " + family.name}, [&](LineReader& reader) {
    for (const Section& section : family.sections) {
      certificate.sections.push_back(parse_section(reader, section, certificate.sections));
      certificate.rows += certificate.sections.back().rows.size();
    }
    return certificate.rows;
  });
  return certificate;
}

}  // namespace restrip::verify
