#include "part.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "emit.hpp"

namespace restrip::generator {
namespace {

/// About proportional to the time that a part takes, as measured for k = 8 … 10: it grows fourfold with k.
std::uint64_t weight(const Part& part) {
  const Position& position = position_of(part);
  std::uint64_t unit = 1;
  if (const auto* section = std::get_if<Section>(&part.section)) {
    const bool ring = closed(*position.family);
    if (!position.family->after.chord.empty()) unit = ring ? 8 : 4;
    // The claims of such a section count the configurations of every position served.
    if (serves_every_position(*position.family)) unit = section->serves.size() * (ring ? 2 : 1);
  } else if (!serves_every_position(*position.family)) {
    unit = 3;
  }
  return unit << (2 * position.k);
}

}  // namespace

std::vector<Part> parts(unsigned max_k, Goal goal) {
  std::vector<Part> all;
  for (const std::string& family : certificate_families())
    for (Section& section : sections_of(family, max_k)) all.push_back({family, std::move(section), {}});
  for (const Family& family : families())
    if (family.linked)
      for (LinkedSection& section : linked_sections_of(family, max_k))
        all.push_back({"linked-" + family.name, std::move(section), {}});
  for (Part& part : all) std::visit([goal](auto& section) { section.goal = goal; }, part.section);
  return all;
}

const Position& position_of(const Part& part) {
  return std::visit([](const auto& section) -> const Position& { return section.position; }, part.section);
}

std::size_t rows_of(const Part& part) {
  if (const auto* section = std::get_if<Section>(&part.section)) return section->rows.size();
  std::size_t rows = 0;
  for (const auto& list : std::get<LinkedSection>(part.section).lists) rows += list.size();
  return rows;
}

void solve(Part& part, Wanted wanted) {
  std::visit(
      [&](auto& section) {
        solve(section);
        if (wanted == Wanted::rules_and_text) part.text = section_text(section);
      },
      part.section);
}

std::vector<std::size_t> share_of(const std::vector<Part>& all, unsigned index, unsigned count) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return weight(all[x]) > weight(all[y]); });
  std::vector<std::uint64_t> load(count, 0);
  std::vector<std::size_t> share;
  for (const std::size_t i : order) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += weight(all[i]);
    if (least - load.begin() == static_cast<std::ptrdiff_t>(index) - 1) share.push_back(i);
  }
  std::sort(share.begin(), share.end());
  return share;
}

}  // namespace restrip::generator
