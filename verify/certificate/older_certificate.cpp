#include "certificate/older_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/coloring.hpp"

namespace restrip::verify {
namespace {

constexpr std::string_view family_title = "restrip-certificate 2";
constexpr std::string_view operation_title = "restrip-operation-certificate 1";

/// The nearest solid port in descending order of index; cyclic in a closed fan.
std::optional<unsigned> preceding_solid_port(unsigned port, Mask ports, unsigned count, bool closed) {
  for (unsigned step = 1; step < count; ++step) {
    if (!closed && step > port) break;
    const unsigned candidate = (port + count - step) % count;
    if (is_solid(ports, candidate)) return candidate;
  }
  return {};
}

PortPairs pairs_of(const LineReader& reader, Mask joined, Mask ports, unsigned count, bool closed) {
  PortPairs pairs;
  for (unsigned port = 0; port < count; ++port) {
    if (!is_solid(joined, port)) continue;
    const std::optional<unsigned> preceding = preceding_solid_port(port, ports, count, closed);
    if (!is_solid(ports, port) || !preceding) reader.fail("expected `joined` to name solid ports with predecessors");
    pairs.add(*preceding, port);
  }
  return pairs;
}

class OlderFamily {
 public:
  OlderFamily(const Family& family, Certificate& certificate)
      : certificate_(certificate),
        flip_(family.name == "flip"),
        closed_(family.name == "split" || family.name == "collapse") {}

  void read_section(LineReader& reader, const Section& section) {
    SectionRows rows;
    if (!reader.starts_with("section") || reader.rest(1) != section.position)
      reader.fail(fmt::format("expected \"section {}\", found \"{}\"", section.position, reader.rest(0)));
    for (reader.next("a claim"); reader.starts_with("claim"); reader.next("a claim or a row")) {
      const auto* const word = std::find(claim_words.begin(), claim_words.end(), reader.words().at(1));
      if (word == claim_words.end() || reader.words().size() != 3) reader.fail("unknown claim");
      rows.claims[static_cast<std::size_t>(word - claim_words.begin())] = {reader.number(2), reader.line()};
    }
    for (; reader.starts_with("rule") || reader.starts_with("copy"); reader.next("a row")) {
      Row row = read_row(reader, section.operations.front());
      ++certificate_.rows;
      // The rows of the two colours of a flip's inner edge.
      const auto same =
          std::find_if(rows.rows.begin(), rows.rows.end(), [&](const Row& r) { return r.key == row.key; });
      if (flip_ && same != rows.rows.end()) {
        if (same->after != row.after) reader.fail(fmt::format("expected the recolouring of line {}", same->line));
        continue;
      }
      rows.rows.push_back(std::move(row));
    }
    std::sort(rows.rows.begin(), rows.rows.end(), [](const Row& one, const Row& other) { return one.key < other.key; });
    certificate_.sections.push_back(std::move(rows));
  }

 private:
  Row read_row(const LineReader& reader, const Operation& operation) const {
    const unsigned ports = operation.ports();
    const std::size_t masks = flip_ ? 4 : 3;
    Row row;
    row.line = reader.line();
    row.copy = reader.starts_with("copy");
    if (reader.words().size() < masks + 3 || (row.copy && reader.words().size() != masks + 4))
      reader.fail("expected a row");
    row.key.ports = reader.mask(1, ports);
    const Mask second = reader.mask(2, flip_ ? 1 : ports);
    const unsigned inner = operation.after.inner_edges();
    if (flip_) {
      const std::optional<SolidGraph> graph = inner_graph(operation.before, second);
      row.key.joined = joined_ports(operation.before, graph.value(), row.key.ports);
      row.after = {reader.mask(4, inner), reader.mask(3, ports)};
    } else {
      row.key.joined = pairs_of(reader, second, row.key.ports, ports, closed_);
      row.after = {reader.mask(3, inner), row.key.ports};
    }
    if (!row.copy) {
      row.reason = parse_reason(reader, masks + 2, inner + (flip_ ? ports : 0));
      return row;
    }
    const std::int64_t n = reader.number(masks + 3);
    if (n < 0 || n >= ports) reader.fail("expected a symmetry");
    const bool mirror = reader.words()[masks + 2] == "mirror";
    for (unsigned port = 0; port < ports; ++port)
      row.by.push_back((mirror ? static_cast<unsigned>(n) + ports - port : port + static_cast<unsigned>(n)) % ports);
    return row;
  }

  Certificate& certificate_;
  bool flip_;
  bool closed_;
};

}  // namespace

bool is_older_certificate(std::string_view text) {
  return text.starts_with(family_title) || text.starts_with(operation_title);
}

Certificate parse_older_certificate(const std::string& file, std::string text, const Family& family) {
  if (text.starts_with(operation_title)) {
    Certificate certificate;
    certificate.file = file;
    certificate.full_keys = true;
    const FormHead head{std::string(operation_title), "operation " + family.name,
                        fmt::format("\"claim {}\" number", claim_words.front())};
    parse_form(file, std::move(text), head, [&](LineReader& reader) {
      SectionRows rows;
      parse_claims(reader, claim_words, rows.claims);
      parse_rows(reader, family.sections.front(), certificate, rows);
      certificate.sections.push_back(std::move(rows));
      return certificate.rows = certificate.sections.front().rows.size();
    });
    return certificate;
  }
  Certificate certificate;
  certificate.file = file;
  certificate.other_order = true;
  OlderFamily reader_of(family, certificate);
  parse_form(file, std::move(text), family_head(family.name), [&](LineReader& reader) {
    for (const Section& section : family.sections) reader_of.read_section(reader, section);
    return certificate.rows;
  });
  return certificate;
}

}  // namespace restrip::verify
