#include "operation_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify::operations {
namespace {

void parse_claims(LineReader& reader, OperationCertificate& certificate) {
  for (std::size_t i = 0; i < number_words.size(); ++i, reader.next("a claim or a row")) {
    const std::string expected = fmt::format("\"claim {}\" number", number_words[i]);
    reader.expect_words(3, expected);
    if (!reader.starts_with("claim") || reader.words()[1] != number_words[i])
      reader.fail(fmt::format("expected {}, found \"{}\"", expected, reader.rest(0)));
    certificate.claims[i] = {reader.number(2), reader.line()};
  }
}

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

RuleRow parse_row_of(const LineReader& reader, const OperationFile& operation) {
  const unsigned ports = operation.ports();
  RuleRow row;
  row.line = reader.line();
  row.copy = reader.starts_with("copy");
  if (!row.copy && !reader.starts_with("rule"))
    reader.fail(fmt::format("expected \"rule\", \"copy\" or \"end\", found \"{}\"", reader.rest(0)));
  if (row.copy)
    reader.expect_words(6 + ports, fmt::format("\"copy\", 4 masks, \"by\" and {} ports", ports));
  else if (reader.words().size() < 7 || reader.words()[5] != "because")
    reader.expect_words(5, "\"rule\" and 4 masks, or behind them \"because\" and a reason");
  row.key = {reader.mask(1, ports), {reader.mask(2, ports * (ports - 1) / 2)}};
  row.after = {reader.mask(3, operation.after.inner_edges()), reader.mask(4, ports)};
  if (row.copy) {
    if (reader.words()[5] != "by") reader.fail(fmt::format("expected \"by\", found \"{}\"", reader.words()[5]));
    row.by = parse_ports(reader, 6, ports);
  } else if (reader.words().size() > 5) {
    if (!may_have_reasons(operation))
      reader.fail("reasons are for strips and forests whose cost begins as it does by default; expected none");
    row.reason = parse_reason(reader, 6, operation.after.inner_edges() + ports);
  }
  return row;
}

void check_row_reason(const LineReader& reader, const std::vector<RuleRow>& rows, const RuleRow& row) {
  if (row.copy) return;
  const auto rule = std::find_if(rows.begin(), rows.end(), [](const RuleRow& r) { return !r.copy; });
  if (rule != rows.end() && rule->reason.has_value() != row.reason.has_value())
    reader.fail(fmt::format("the rule in line {} has {} reason: expected the same of all", rule->line,
                            rule->reason ? "a" : "no"));
}

void check_row_order(const LineReader& reader, const std::vector<RuleRow>& rows, const RuleRow& row) {
  if (rows.empty() || rows.back().key < row.key) return;
  if (rows.back().key == row.key)
    reader.fail(fmt::format("duplicate row: the key {:x} {:x} already has a row in line {}", row.key.ports,
                            row.key.joined.bits, rows.back().line));
  reader.fail("expected rows in ascending order of (P, J)");
}

}  // namespace

std::string RuleRow::text() const {
  const std::string masks = fmt::format("{} {:x} {:x} {:x} {:x}", copy ? "copy" : "rule", key.ports, key.joined.bits,
                                        after.inner, after.ports);
  if (copy) return fmt::format("{} by {}", masks, fmt::join(by, " "));
  return reason ? fmt::format("{} because {}", masks, reason->text()) : masks;
}

const RuleRow* OperationCertificate::row_of(OperationKey key) const {
  const auto place =
      std::lower_bound(rows.begin(), rows.end(), key, [](const RuleRow& row, OperationKey k) { return row.key < k; });
  return place != rows.end() && place->key == key ? &*place : nullptr;
}

OperationCertificate parse_operation_certificate(const std::string& file, std::string text,
                                                 const OperationFile& operation) {
  OperationCertificate certificate;
  certificate.file = file;
  parse_form(file, std::move(text),
             {"restrip-operation-certificate 1", "operation " + operation.name,
              fmt::format("\"claim {}\" number", number_words.front())},
             [&](LineReader& reader) {
               parse_claims(reader, certificate);
               for (; !reader.starts_with("end"); reader.next("a row or \"end\"")) {
                 RuleRow row = parse_row_of(reader, operation);
                 check_row_order(reader, certificate.rows, row);
                 check_row_reason(reader, certificate.rows, row);
                 certificate.rows.push_back(std::move(row));
               }
               return certificate.rows.size();
             });
  return certificate;
}

}  // namespace restrip::verify::operations
