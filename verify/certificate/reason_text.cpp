#include "certificate/reason_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace restrip::verify {
namespace {

/// Reads a reason that starts at word `at` and moves `at` past it. `asked` are the edges of the enclosing cases.
Reason parse_part(const LineReader& reader, std::size_t& at, unsigned edges, Mask asked) {
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
    reason.cases.push_back(parse_part(reader, at, edges, asked));
    expect("else");
    reason.cases.push_back(parse_part(reader, at, edges, asked));
  } else {
    if (!is_mask()) reader.fail(fmt::format("expected a reason, found \"{}\"", word()));
    for (; is_mask(); ++at) reason.sets.push_back(reader.mask(at, edges));
  }
  return reason;
}

}  // namespace

std::string Reason::text() const {
  if (!cases.empty()) return fmt::format("if {} then {} else {}", edge, cases[0].text(), cases[1].text());
  return sets.empty() ? "-" : fmt::format("{:x}", fmt::join(sets, " "));
}

Reason parse_reason(const LineReader& reader, std::size_t first, unsigned edges) {
  std::size_t at = first;
  Reason reason = parse_part(reader, at, edges, 0);
  if (at != reader.words().size())
    reader.fail(fmt::format("expected the end of the reason, found \"{}\"", reader.rest(at)));
  return reason;
}

std::size_t cases_of(const Reason& reason) {
  return reason.cases.empty() ? 1 : cases_of(reason.cases[0]) + cases_of(reason.cases[1]);
}

}  // namespace restrip::verify
