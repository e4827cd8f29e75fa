#include "certify/certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "certify/reason.hpp"

namespace restrip::generator {
namespace {

/// A section with claims, rows and reasons.
std::string section_text(const Section& section, Watched watched) {
  std::string text = fmt::format("section {}\n", position_text(section.position));
  const Claims claims = sum(section.claims);
  text += fmt::format("claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                      claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  text += fmt::format("claim keys {}\nclaim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n",
                      section.rows.size(), claims.costing, claims.worst_strips, claims.worst_isolated);
  const Operation operation = operation_of_rows(section.position);
  std::vector<unsigned> identity(operation.patch.after.ports());
  std::iota(identity.begin(), identity.end(), 0U);
  // The map of a row's ports to the ports of its representative in the search.
  const auto to_representative = [&](const Row& row) -> const std::vector<unsigned>& {
    return row.witness < 0 ? identity : section.symmetry[static_cast<std::size_t>(row.witness)].port;
  };
  struct Line {
    const Row* row = nullptr;
    std::string joined;
    Key representative;
  };
  std::vector<Line> lines;
  for (const Row& row : section.rows) {
    const std::vector<unsigned>& to = to_representative(row);
    lines.push_back({&row, row.key.joined.text(), {permute(row.key.ports, to), row.key.joined.moved(to)}});
  }
  // By P, then by J as a number.
  std::sort(lines.begin(), lines.end(), [](const Line& x, const Line& y) {
    return std::tuple{x.row->key.ports, x.joined.size(), std::string_view(x.joined)} <
           std::tuple{y.row->key.ports, y.joined.size(), std::string_view(y.joined)};
  });
  std::optional<Reasoner> reasoner;
  if (has_reasons(operation)) reasoner.emplace(operation);
  // The rule row of an orbit is its first line, whichever row the search started with.
  std::map<Key, const Row*> rule_of;
  Progress progress("finding reasons", section.rows.size(), watched);
  for (const auto& [line_row, joined, representative] : lines) {
    const Row& row = *line_row;
    const auto [rule, is_rule] = rule_of.try_emplace(representative, &row);
    text +=
        fmt::format("{} {:x} {} {:x} {:x}", is_rule ? "rule" : "copy", row.key.ports, joined, row.recoloring, row.kept);
    if (!is_rule) {
      const std::vector<unsigned> back = inverse(to_representative(*rule->second));
      std::vector<unsigned> ports;
      for (const unsigned port : to_representative(row)) ports.push_back(back[port]);
      text += fmt::format(" by {}", fmt::join(ports, " "));
    } else if (reasoner) {
      text += fmt::format(" because {}", reasoner->find(row.key.ports, row.key.joined.masks(), row).reason.text());
    }
    text += '\n';
    progress.step();
  }
  return text;
}

}  // namespace

std::size_t Certificate::rows() const {
  std::size_t n = 0;
  for (const Section& section : sections) n += section.rows.size();
  return n;
}

std::vector<Certificate> certify(std::vector<Section> sections, unsigned threads, bool with_texts) {
  std::vector<std::string> texts(sections.size());
  if (with_texts)
    share_sections(sections, threads, "certifying",
                   [&](std::size_t i, Watched watched) { texts[i] = section_text(sections[i], watched); });
  std::vector<Certificate> all;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string& name = sections[i].certificate;
    if (all.empty() || all.back().name != name)
      all.push_back({name, {}, fmt::format("restrip-certificate 3\noperation {}\n", name)});
    all.back().text += texts[i];
    all.back().sections.push_back(std::move(sections[i]));
  }
  for (Certificate& certificate : all)
    certificate.text = with_texts ? sealed(std::move(certificate.text), certificate.rows()) : "";
  return all;
}

std::string sealed(std::string text, std::size_t rows) {
  std::uint64_t sum = 0;
  std::uint64_t weighted = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    sum += byte;
    weighted += (i + 1) * byte;
  }
  return text + fmt::format("end {} {} {}\n", rows, sum, weighted);
}

}  // namespace restrip::generator
