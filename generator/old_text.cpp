#include "old_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "emit.hpp"
#include "packing.hpp"
#include "reason.hpp"

namespace restrip::generator {
namespace {

using Out = std::back_insert_iterator<std::string>;

void add_claims(Out out, const Section& section, bool keys) {
  const Claims claims = sum(section.claims);
  fmt::format_to(out, "claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                 claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  if (keys) fmt::format_to(out, "claim keys {}\n", section.rows.size());
  fmt::format_to(out, "claim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n", claims.costing,
                 claims.worst_strips, claims.worst_isolated);
}

std::string name_of(const PatchMap& map) {
  const std::size_t k = map.port.size();
  bool turn = true;
  for (std::size_t i = 0; i < k; ++i) turn = turn && map.port[i] == (map.port[0] + i) % k;
  if (k <= 2) turn = map.port[0] == 0;
  return fmt::format("{} {}", turn ? "turn" : "mirror", map.port[0]);
}

/// Rows whose key is a mask of the colours or pairs before, as some function says.
struct OldRow {
  const Row* row = nullptr;
  PortPairs joined;
};
using OldKey = std::pair<Mask, std::uint64_t>;

template <class Spell>
std::map<OldKey, OldRow> spelled(const Section& section, Spell&& spell) {
  std::map<OldKey, OldRow> rows;
  for_each_valid(operation_at(section.position), [&](const Configuration& c) {
    rows[{c.ports, spell(c)}] = {&row_of(section, c.ports, c.outcome.joined), c.outcome.joined};
  });
  return rows;
}

template <class Image>
int witness(const OldKey& key, const std::vector<PatchMap>& maps, Image&& image) {
  int found = -1;
  OldKey representative = key;
  for (std::size_t s = 0; s < maps.size(); ++s)
    if (const OldKey other = image(maps[s]); other < representative) {
      representative = other;
      found = static_cast<int>(s);
    }
  return found;
}

std::uint64_t old_mask(const PortPairs& pairs) {
  std::uint64_t mask = 0;
  for (const Mask pair : pairs.masks()) {
    const auto low = static_cast<unsigned>(std::countr_zero(pair));
    const auto high = static_cast<unsigned>(std::bit_width(pair)) - 1;
    mask |= std::uint64_t{1} << (high * (high - 1) / 2 + low);
  }
  return mask;
}

}  // namespace

std::string old_section_text(const Section& section) {
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "section {}\n", position_text(section.position));
  const bool is_flip = section.position.family->numbers.empty();
  if (section.linked) {
    std::map<Mask, std::size_t> lists;
    for (const Row& row : section.rows) ++lists[row.key.ports];
    std::size_t longest = 0;
    for (const auto& [ports, length] : lists) longest = std::max(longest, length);
    fmt::format_to(out, "claim lists {}\nclaim alternatives {}\nclaim longest {}\n", lists.size(), section.rows.size(),
                   longest);
    for (const Row& row : section.rows) fmt::format_to(out, "alternative {:x} {:x}\n", row.key.ports, row.recoloring);
    return text;
  }
  add_claims(out, section, false);
  const Operation operation = operation_of_rows(section.position, Sight::patch, section.goal);
  const Reasoner reasoner(operation);
  if (is_flip) {
    const std::vector<PatchMap> maps = symmetries(operation).maps;
    for (const auto& [key, old] : spelled(section, [](const Configuration& c) { return c.before; })) {
      const auto image = [&, inner = key.second, ports = key.first](const PatchMap& map) {
        return OldKey{permute(ports, map.port), inner};
      };
      const int by = witness(key, maps, image);
      fmt::format_to(out, "{} {:x} {:x} {:x} {:x}", by < 0 ? "rule" : "copy", key.first, key.second, old.row->kept,
                     old.row->recoloring);
      if (by >= 0)
        fmt::format_to(out, " by {}\n", name_of(maps[static_cast<std::size_t>(by)]));
      else
        fmt::format_to(out, " because {}\n", reasoner.reason(key.first, old.joined.masks(), *old.row).text());
    }
    return text;
  }
  for (const Row& row : section.rows) {
    const FanKey key = fan_key(row.key, section.position);
    fmt::format_to(out, "{} {:x} {:x} {:x}", row.witness < 0 ? "rule" : "copy", key.ports, key.joined, row.recoloring);
    if (row.witness >= 0)
      fmt::format_to(out, " by {}\n", name_of(section.symmetry[static_cast<std::size_t>(row.witness)]));
    else
      fmt::format_to(out, " because {}\n", reasoner.reason(row.key.ports, row.key.joined.masks(), row).text());
  }
  return text;
}

std::string old_operation_certificate(const Section& section) {
  const Operation operation = operation_at(section.position);
  const std::vector<PatchMap> maps = symmetries(operation).maps;
  const auto rows = spelled(section, [](const Configuration& c) { return old_mask(c.outcome.joined); });
  std::string text = fmt::format("restrip-operation-certificate 1\noperation {}\n", section.certificate);
  auto out = std::back_inserter(text);
  add_claims(out, section, true);
  std::optional<Reasoner> reasoner;
  if (has_reasons(operation)) reasoner.emplace(operation);
  for (const auto& [key, old] : rows) {
    const auto image = [&, ports = key.first, &joined = old.joined](const PatchMap& map) {
      return OldKey{permute(ports, map.port), old_mask(joined.moved(map.port))};
    };
    const int by = witness(key, maps, image);
    fmt::format_to(out, "{} {:x} {:x} {:x} {:x}", by < 0 ? "rule" : "copy", key.first, key.second, old.row->recoloring,
                   old.row->kept);
    if (by < 0 && reasoner)
      fmt::format_to(out, " because {}", reasoner->reason(key.first, old.joined.masks(), *old.row).text());
    if (by >= 0) fmt::format_to(out, " by {}", fmt::join(maps[static_cast<std::size_t>(by)].port, " "));
    text += '\n';
  }
  return sealed(std::move(text), rows.size());
}

}  // namespace restrip::generator
