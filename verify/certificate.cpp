#include "certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "input.hpp"
#include "mutants.hpp"
#include "sums.hpp"

namespace restrip::verify {
namespace {

bool starts_row(const LineReader& reader) { return reader.starts_with("rule") || reader.starts_with("copy"); }

void parse_claim(LineReader& reader, std::array<StatedClaim, claim_words.size()>& claims) {
  reader.expect_words(3, "\"claim\" word number");
  const auto* const word = std::find(claim_words.begin(), claim_words.end(), reader.words()[1]);
  if (word == claim_words.end()) reader.fail(fmt::format("unknown claim \"{}\"", reader.words()[1]));
  StatedClaim& claim = claims[static_cast<std::size_t>(word - claim_words.begin())];
  if (claim.line != 0) reader.fail(fmt::format("claim {} made twice, first in line {}", *word, claim.line));
  claim = {reader.number(2), reader.line()};
}

/// Reads a reason that starts at word `at`, which is left behind it. `asked` are the edges of the cases around it.
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
    if (is_solid(asked, reason.edge)) reader.fail(fmt::format("edge {} makes cases of a case of its own", edge));
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

Row parse_row(const LineReader& reader, const Section& section, bool gives_ports_up) {
  Row row;
  row.copy = reader.starts_with("copy");
  row.line = reader.line();
  const std::size_t masks = gives_ports_up ? 4 : 3;
  if (row.copy || reader.words().size() < masks + 2 || reader.words()[masks + 1] != "because")
    reader.expect_words(row.copy ? masks + 4 : 0, fmt::format("\"{}\", {} masks, {}", reader.words()[0], masks,
                                                              row.copy ? "\"by\" symmetry" : "\"because\" reason"));
  row.key = {reader.mask(1, section.ports), reader.mask(2, section.key_bits)};
  row.after = gives_ports_up ? Coloring{reader.mask(4, section.recoloring_bits), reader.mask(3, section.ports)}
                             : Coloring{reader.mask(3, section.recoloring_bits), row.key.ports};
  if (row.copy) {
    const std::string_view by = reader.words()[masks + 1];
    const std::string_view kind = reader.words()[masks + 2];
    if (by != "by") reader.fail(fmt::format("expected \"by\", found \"{}\"", by));
    if (kind != "turn" && kind != "mirror")
      reader.fail(fmt::format("expected \"turn\" or \"mirror\", found \"{}\"", kind));
    const std::int64_t n = reader.number(masks + 3);
    if (n < 0 || n >= section.ports) reader.fail(fmt::format("expected a number from 0 to {}", section.ports - 1));
    row.by = {kind == "mirror", static_cast<unsigned>(n)};
  } else {
    std::size_t at = masks + 2;
    row.reason = parse_reason(reader, at, section.recoloring_bits + (gives_ports_up ? section.ports : 0), 0);
    if (at != reader.words().size())
      reader.fail(fmt::format("expected the end of the reason, found \"{}\"", reader.rest(at)));
  }
  return row;
}

void check_order(const LineReader& reader, const std::vector<Row>& rows, const Row& row) {
  if (rows.empty() || rows.back().key < row.key || mutated(Mutant::accept_disorder)) return;
  if (rows.back().key == row.key)
    reader.fail(fmt::format("duplicate row: the key {:x} {:x} already has a row in line {}", row.key.ports,
                            row.key.second, rows.back().line));
  reader.fail("expected rows in ascending order of (ports, second mask)");
}

/// Leaves the reader on the first line after the section.
SectionRows parse_section(LineReader& reader, const Section& section) {
  if (!reader.starts_with("section") || reader.rest(1) != section.position)
    reader.fail(fmt::format("expected \"section {}\", found \"{}\"", section.position, reader.rest(0)));
  SectionRows result;
  reader.next("a claim");
  for (; reader.starts_with("claim"); reader.next("a claim or a row")) parse_claim(reader, result.claims);
  for (std::size_t i = 0; i < claim_words.size(); ++i)
    if (result.claims[i].line == 0) reader.fail(fmt::format("claim {} missing before this line", claim_words[i]));
  const bool gives_ports_up = section.operations.front().gives_ports_up;
  if (!starts_row(reader)) reader.fail(fmt::format("expected \"rule\" or \"copy\", found \"{}\"", reader.rest(0)));
  for (; starts_row(reader); reader.next("a row, a section or \"end\"")) {
    Row row = parse_row(reader, section, gives_ports_up);
    check_order(reader, result.rows, row);
    result.rows.push_back(row);
  }
  return result;
}

}  // namespace

Certificate parse_certificate(const std::string& file, std::string text, const Family& family) {
  const std::optional<Place> altered = altered_byte(text);
  if (altered && !mutated(Mutant::skip_sums))
    throw InputError(
        file, altered->line,
        fmt::format("byte {} of this line was altered, or more than one byte: the sums in the last line tell",
                    altered->byte));
  LineReader reader(file, std::move(text));
  Certificate certificate;
  certificate.file = file;
  reader.next("\"restrip-certificate 2\"");
  reader.expect_line("restrip-certificate 2");
  reader.next("\"family\"");
  reader.expect_line("family " + family.name);
  reader.next("a section");
  for (const Section& section : family.sections) {
    certificate.sections.push_back(parse_section(reader, section));
    certificate.rows += certificate.sections.back().rows.size();
  }
  if (!reader.starts_with("end")) reader.fail(fmt::format("expected \"end\", found \"{}\"", reader.rest(0)));
  reader.expect_words(4, "\"end\" number sum sum");
  if (reader.number(1) != static_cast<std::int64_t>(certificate.rows) && !mutated(Mutant::skip_row_count))
    reader.fail(fmt::format("expected \"end {}\", the number of rows of this file", certificate.rows));
  if (!reader.at_end()) reader.fail("expected the end of the file after \"end\"");
  const ByteSums sums = sums_of(reader.text_above());
  const bool as_stated = reader.number(2) == static_cast<std::int64_t>(sums.plain) &&
                         reader.number(3) == static_cast<std::int64_t>(sums.weighted);
  if (!as_stated && !mutated(Mutant::skip_sums))
    reader.fail(fmt::format("expected {} and {}, the sums of the bytes above", sums.plain, sums.weighted));
  return certificate;
}

std::string Reason::text() const {
  if (!cases.empty()) return fmt::format("if {} then {} else {}", edge, cases[0].text(), cases[1].text());
  return sets.empty() ? "-" : fmt::format("{:x}", fmt::join(sets, " "));
}

std::string text_of(const Row& row, bool gives_ports_up) {
  std::string text = fmt::format("{} {:x} {:x} ", row.copy ? "copy" : "rule", row.key.ports, row.key.second);
  text += gives_ports_up ? fmt::format("{:x} {:x}", row.after.ports, row.after.inner)
                         : fmt::format("{:x}", row.after.inner);
  return text + (row.copy ? " by " + row.by.text() : " because " + row.reason.text());
}

}  // namespace restrip::verify
