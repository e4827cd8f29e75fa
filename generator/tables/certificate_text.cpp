#include "tables/certificate_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "solve/reason.hpp"

namespace restrip::generator {
namespace {

constexpr unsigned certificate_version = 3;

using Out = std::back_insert_iterator<std::string>;

void add_alternatives(Out out, const Section& section) {
  std::map<Mask, std::size_t> lists;
  for (const Row& row : section.rows) ++lists[row.key.ports];
  std::size_t longest = 0;
  for (const auto& [ports, length] : lists) longest = std::max(longest, length);
  fmt::format_to(out, "claim lists {}\nclaim alternatives {}\nclaim longest {}\n", lists.size(), section.rows.size(),
                 longest);
  for (const Row& row : section.rows) fmt::format_to(out, "alternative {:x} {:x}\n", row.key.ports, row.recoloring);
}

/// A row in the certificate's order: by P, then by J as a number.
struct WrittenRow {
  const Row* row = nullptr;
  std::string joined;
  std::size_t orbit = 0;  ///< index of its representative among the section's rows
  [[nodiscard]] auto order() const { return std::tuple{row->key.ports, joined.size(), std::string_view(joined)}; }
};

std::vector<WrittenRow> written_rows(const Section& section) {
  std::vector<WrittenRow> lines;
  std::map<Key, std::size_t> representatives;
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    const Row& row = section.rows[i];
    Key representative = row.key;
    if (row.witness >= 0) {
      const std::vector<unsigned>& port = section.symmetry[static_cast<std::size_t>(row.witness)].port;
      representative = {permute(row.key.ports, port), row.key.joined.moved(port)};
    }
    const std::size_t orbit = representatives.try_emplace(representative, i).first->second;
    lines.push_back({&row, row.key.joined.text(), orbit});
  }
  std::sort(lines.begin(), lines.end(), [](const WrittenRow& x, const WrittenRow& y) { return x.order() < y.order(); });
  return lines;
}

/// The map of the row's ports to the ports of its representative in the search.
std::vector<unsigned> to_representative(const Section& section, const Row& row) {
  if (row.witness >= 0) return section.symmetry[static_cast<std::size_t>(row.witness)].port;
  // Called only for orbits with a copy, so a symmetry exists.
  std::vector<unsigned> identity(section.symmetry.at(0).port.size());
  for (unsigned i = 0; i < identity.size(); ++i) identity[i] = i;
  return identity;
}

void add_rules(Out out, const Section& section, Watched watched) {
  const Claims claims = sum(section.claims);
  fmt::format_to(out, "claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                 claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  fmt::format_to(out, "claim keys {}\nclaim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n",
                 section.rows.size(), claims.costing, claims.worst_strips, claims.worst_isolated);
  const Operation operation = operation_of_rows(section.position, Sight::patch);
  std::optional<Reasoner> reasoner;
  if (has_reasons(operation)) reasoner.emplace(operation);
  // The rule row of an orbit is its first line, whichever row the search started with.
  std::map<std::size_t, const Row*> rule_of;
  Progress progress("finding reasons", section.rows.size(), watched);
  for (const WrittenRow& line : written_rows(section)) {
    const Row& row = *line.row;
    const auto [rule, is_rule] = rule_of.try_emplace(line.orbit, &row);
    fmt::format_to(out, "{} {:x} {} {:x} {:x}", is_rule ? "rule" : "copy", row.key.ports, line.joined, row.recoloring,
                   row.kept);
    if (!is_rule) {
      const std::vector<unsigned> back = inverse(to_representative(section, *rule->second));
      std::vector<unsigned> ports;
      for (const unsigned port : to_representative(section, row)) ports.push_back(back[port]);
      fmt::format_to(out, " by {}", fmt::join(ports, " "));
    } else if (reasoner) {
      fmt::format_to(out, " because {}", reasoner->find(row.key.ports, row.key.joined.masks(), row).reason.text());
    }
    fmt::format_to(out, "\n");
    progress.step();
  }
}

}  // namespace

std::string section_text(const Section& section, Watched watched) {
  std::string text = fmt::format("section {}\n", position_text(section.position));
  if (section.linked)
    add_alternatives(std::back_inserter(text), section);
  else
    add_rules(std::back_inserter(text), section, watched);
  return text;
}

std::size_t Certificate::rows() const {
  std::size_t n = 0;
  for (const Section& section : sections) n += section.rows.size();
  return n;
}

std::vector<Certificate> by_certificate(std::vector<Section> sections, std::vector<std::string> texts) {
  std::vector<Certificate> all;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (all.empty() || all.back().name != sections[i].certificate) all.push_back({sections[i].certificate, {}, {}});
    all.back().sections.push_back(std::move(sections[i]));
    if (!texts.empty()) all.back().texts.push_back(std::move(texts.at(i)));
  }
  return all;
}

std::vector<std::string> section_texts(const std::vector<Section>& sections, unsigned threads) {
  std::vector<std::string> texts(sections.size());
  share_sections(sections, threads, Watched::yes, "certifying",
                 [&](std::size_t i) { texts[i] = section_text(sections[i]); });
  return texts;
}

std::string certificate_text(const Certificate& certificate) {
  std::string text = fmt::format("restrip-certificate {}\noperation {}\n", certificate_version, certificate.name);
  for (const std::string& section : certificate.texts) text += section;
  return sealed(std::move(text), certificate.rows());
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
