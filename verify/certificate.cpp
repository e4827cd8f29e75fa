#include "certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "input.hpp"
#include "mutants.hpp"

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

Row parse_row(LineReader& reader, const Section& section, bool gives_ports_up) {
  Row row;
  row.copy = reader.starts_with("copy");
  row.line = reader.line();
  const std::size_t masks = gives_ports_up ? 4 : 3;
  reader.expect_words(1 + masks + (row.copy ? 3 : 0),
                      fmt::format("\"{}\", {} masks{}", reader.words()[0], masks, row.copy ? ", \"by\" symmetry" : ""));
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
  LineReader reader(file, std::move(text));
  Certificate certificate;
  certificate.file = file;
  reader.next("\"restrip-certificate 1\"");
  reader.expect_line("restrip-certificate 1");
  reader.next("\"family\"");
  reader.expect_line("family " + family.name);
  reader.next("a section");
  for (const Section& section : family.sections) {
    certificate.sections.push_back(parse_section(reader, section));
    certificate.rows += certificate.sections.back().rows.size();
  }
  reader.expect_words(2, "\"end\" number");
  if (!reader.starts_with("end")) reader.fail(fmt::format("expected \"end\", found \"{}\"", reader.rest(0)));
  if (reader.number(1) != static_cast<std::int64_t>(certificate.rows) && !mutated(Mutant::skip_row_count))
    reader.fail(fmt::format("expected \"end {}\", the number of rows of this file", certificate.rows));
  if (!reader.at_end()) {
    reader.next("nothing");
    reader.fail("expected the end of the file after \"end\"");
  }
  return certificate;
}

std::string text_of(const Row& row, bool gives_ports_up) {
  std::string text = fmt::format("{} {:x} {:x} ", row.copy ? "copy" : "rule", row.key.ports, row.key.second);
  text += gives_ports_up ? fmt::format("{:x} {:x}", row.after.ports, row.after.inner)
                         : fmt::format("{:x}", row.after.inner);
  if (row.copy) text += " by " + row.by.text();
  return text;
}

}  // namespace restrip::verify
