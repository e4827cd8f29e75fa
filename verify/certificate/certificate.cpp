#include "certificate/certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace restrip::verify {
namespace {

constexpr std::array<const char*, 2> row_words = {"rule", "copy"};

bool starts_row(const LineReader& reader) { return reader.starts_with("rule") || reader.starts_with("copy"); }

Permutation parse_ports(const LineReader& reader, std::size_t first, unsigned ports) {
  Permutation permutation;
  Mask seen = 0;
  for (std::size_t i = first; i < reader.words().size(); ++i) {
    const std::int64_t port = reader.number(i);
    if (port < 0 || port >= ports || is_solid(seen, static_cast<unsigned>(port)))
      reader.fail(fmt::format("expected each port from 0 to {} once, found \"{}\"", ports - 1, reader.rest(first)));
    permutation.push_back(static_cast<unsigned>(port));
    seen |= single(permutation.back());
  }
  return permutation;
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
    row.by = parse_ports(reader, 6, ports);
  } else if (reader.words().size() > 5) {
    if (!may_have_reasons(operation))
      reader.fail("expected no reason: reasons require strips or forests whose cost begins like the default cost");
    row.reason = parse_reason(reader, 6, operation.after.inner_edges() + ports);
  }
  return row;
}

/// Leaves the reader on the first line after the section.
SectionRows parse_section(LineReader& reader, const Section& section, const Certificate& certificate) {
  SectionRows result;
  parse_section_head(reader, section.position, claim_words, result.claims, row_words);
  parse_rows(reader, section, certificate, result);
  return result;
}
const Row* first_rule(const SectionRows& rows) {
  const auto rule = std::find_if(rows.rows.begin(), rows.rows.end(), [](const Row& row) { return !row.copy; });
  return rule == rows.rows.end() ? nullptr : &*rule;
}

void expect_reasons_as_before(const LineReader& reader, const Certificate& certificate, const SectionRows& rows,
                              const Row& row) {
  if (row.copy) return;
  const Row* const rule = first_rule(certificate.sections.empty() ? rows : certificate.sections.front());
  if (rule != nullptr && rule->reason.has_value() != row.reason.has_value())
    reader.fail(fmt::format("the rule in line {} has {} reason: expected a reason for all rules or for none",
                            rule->line, rule->reason ? "a" : "no"));
}

}  // namespace

void parse_rows(LineReader& reader, const Section& section, const Certificate& certificate, SectionRows& result) {
  for (; starts_row(reader); reader.next("a row, a section or \"end\"")) {
    Row row = parse_row(reader, section.operations.front());
    expect_order(reader, result.rows, row);
    expect_reasons_as_before(reader, certificate, result, row);
    result.rows.push_back(std::move(row));
  }
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

void expect_order(const LineReader& reader, const std::vector<Row>& rows, const Row& row) {
  if (rows.empty() || rows.back().key < row.key) return;
  if (rows.back().key == row.key)
    reader.fail(fmt::format("duplicate row: the key {:x} {:x} already has a row in line {}", row.key.ports,
                            row.key.joined.bits, rows.back().line));
  reader.fail("expected rows in ascending order of (P, J)");
}

Certificate parse_certificate(const std::string& file, std::string text, const Family& family) {
  Certificate certificate;
  certificate.file = file;
  parse_form(file, std::move(text), head_of(family.name), [&](LineReader& reader) {
    for (const Section& section : family.sections) {
      certificate.sections.push_back(parse_section(reader, section, certificate));
      certificate.rows += certificate.sections.back().rows.size();
    }
    return certificate.rows;
  });
  return certificate;
}

}  // namespace restrip::verify
