#include "certificate.hpp"

#include <fmt/format.h>

#include "input.hpp"
#include "mutants.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<const char*, 2> row_words = {"rule", "copy"};

bool starts_row(const LineReader& reader) { return reader.starts_with("rule") || reader.starts_with("copy"); }

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
    row.reason = parse_reason(reader, masks + 2, section.recoloring_bits + (gives_ports_up ? section.ports : 0));
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
  SectionRows result;
  parse_section_head(reader, section.position, claim_words, result.claims, row_words);
  const bool gives_ports_up = section.operations.front().gives_ports_up;
  for (; starts_row(reader); reader.next("a row, a section or \"end\"")) {
    Row row = parse_row(reader, section, gives_ports_up);
    check_order(reader, result.rows, row);
    result.rows.push_back(row);
  }
  return result;
}

}  // namespace

Certificate parse_certificate(const std::string& file, std::string text, const Family& family) {
  Certificate certificate;
  certificate.file = file;
  parse_form(file, std::move(text), family_head(family.name), [&](LineReader& reader) {
    for (const Section& section : family.sections) {
      certificate.sections.push_back(parse_section(reader, section));
      certificate.rows += certificate.sections.back().rows.size();
    }
    return certificate.rows;
  });
  return certificate;
}

std::string text_of(const Row& row, bool gives_ports_up) {
  std::string text = fmt::format("{} {:x} {:x} ", row.copy ? "copy" : "rule", row.key.ports, row.key.second);
  text += gives_ports_up ? fmt::format("{:x} {:x}", row.after.ports, row.after.inner)
                         : fmt::format("{:x}", row.after.inner);
  return text + (row.copy ? " by " + row.by.text() : " because " + row.reason.text());
}

}  // namespace restrip::verify
