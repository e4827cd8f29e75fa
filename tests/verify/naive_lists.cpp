#include "naive_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify::test {
namespace {

bool includes(int whole, int part) { return (whole | part) == whole; }

}  // namespace

void NaiveLists::count() {
  int rows = 0;
  int longest = 0;
  for (const auto& entry : lists) {
    rows += static_cast<int>(entry.second.size());
    longest = std::max(longest, static_cast<int>(entry.second.size()));
  }
  claims = {{"lists", static_cast<int>(lists.size())}, {"alternatives", rows}, {"longest", longest}};
}

NaiveLinked::NaiveLinked(const std::string& family, const NaiveSection& section) : family_(family), section_(&section) {
  const NaiveOperation& first = section.operations.front();
  for (int ports = 0; ports < 1 << first.ports(); ++ports) {
    recolorings_.emplace_back();
    for (int inner = 0; inner < recolorings(); ++inner) {
      const NaiveColors colors{inner, ports};
      Recoloring recoloring;
      if (first.valid(true, colors))
        recoloring = {{__builtin_popcount(static_cast<unsigned>(inner)), -first.isolated(true, colors)},
                      first.joined(true, colors),
                      {}};
      for (const Pairs& outside : first.worlds(ports))
        recoloring.sound.push_back(first.valid(true, colors) && first.fits(true, colors, outside));
      recolorings_.back().push_back(recoloring);
    }
  }
}

const NaiveLinked::Recoloring& NaiveLinked::at(int ports, int inner) const {
  return recolorings_[static_cast<std::size_t>(ports)][static_cast<std::size_t>(inner)];
}

NaiveLists NaiveLinked::good() const {
  NaiveLists result{family_, section_->position, {}, {}};
  for (int ports = 0; ports < static_cast<int>(recolorings_.size()); ++ports) {
    std::vector<int> order;
    for (int inner = 0; inner < recolorings(); ++inner)
      if (!at(ports, inner).merit.empty()) order.push_back(inner);
    // Among equally good ones, the recolouring that joins fewer ports comes first, so that the others are covered.
    std::stable_sort(order.begin(), order.end(), [&](int x, int y) {
      const Recoloring& one = at(ports, x);
      const Recoloring& other = at(ports, y);
      return one.merit != other.merit ? one.merit > other.merit
                                      : __builtin_popcount(static_cast<unsigned>(one.joined)) <
                                            __builtin_popcount(static_cast<unsigned>(other.joined));
    });
    std::vector<int>& list = result.lists[ports];
    for (const int inner : order)
      if (std::none_of(list.begin(), list.end(),
                       [&](int earlier) { return includes(at(ports, inner).joined, at(ports, earlier).joined); }))
        list.push_back(inner);
  }
  result.count();
  return result;
}

bool NaiveLinked::best_beside(int ports, const std::vector<int>& list, std::size_t world) const {
  const auto sound = [&](int inner) { return at(ports, inner).sound[world]; };
  const auto first = std::find_if(list.begin(), list.end(), sound);
  if (first == list.end()) return false;
  for (int inner = 0; inner < recolorings(); ++inner)
    if (sound(inner) && at(ports, inner).merit > at(ports, *first).merit) return false;
  return true;
}

Crimes NaiveLinked::crimes(const NaiveLists& lists) const {
  Crimes crimes;
  const auto count = [&](const char* claim, bool crime) {
    if (crime) ++crimes[claim];
  };
  for (int ports = 0; ports < static_cast<int>(recolorings_.size()); ++ports) {
    const auto found = lists.lists.find(ports);
    const std::vector<int> list = found == lists.lists.end() ? std::vector<int>{} : found->second;
    count("every port mask has its list", list.empty());
    std::vector<int> legal;
    for (const int inner : list) {
      const Recoloring& row = at(ports, inner);
      count("every alternative is legal", row.merit.empty());
      if (row.merit.empty()) continue;
      count("lists are in order of preference", !legal.empty() && at(ports, legal.back()).merit < row.merit);
      count("no alternative is covered by an earlier one", std::any_of(legal.begin(), legal.end(), [&](int earlier) {
              return includes(row.joined, at(ports, earlier).joined);
            }));
      legal.push_back(inner);
    }
    for (int inner = 0; inner < recolorings(); ++inner) {
      const Recoloring& needed = at(ports, inner);
      count("lists are complete", !needed.merit.empty() && std::none_of(legal.begin(), legal.end(), [&](int row) {
              return at(ports, row).merit >= needed.merit && includes(needed.joined, at(ports, row).joined);
            }));
    }
    for (std::size_t world = 0; world < section_->operations.front().worlds(ports).size(); ++world)
      count("in every world the first sound one is best", !best_beside(ports, list, world));
  }
  NaiveLists counted = lists;
  counted.count();
  for (std::size_t i = 0; i < counted.claims.size(); ++i)
    count("the stated numbers", lists.claims[i].second != counted.claims[i].second);
  return crimes;
}

std::string certificate_text(const std::string& family, const std::vector<NaiveLists>& sections) {
  std::string text = fmt::format("restrip-certificate 3\noperation {}\n", family);
  std::size_t rows = 0;
  for (const NaiveLists& section : sections) {
    text += fmt::format("section {}\n", section.position);
    for (const auto& [word, number] : section.claims) text += fmt::format("claim {} {}\n", word, number);
    for (const auto& [ports, list] : section.lists)
      for (const int inner : list) {
        text += fmt::format("alternative {:x} {:x}\n", ports, inner);
        ++rows;
      }
  }
  return with_end(text, rows);
}

std::vector<NaiveLinked> naive_linked(const std::vector<NaiveFamily>& families) {
  std::vector<NaiveLinked> result;
  for (const NaiveFamily& family : families)
    if (family.name == "split" || family.name == "collapse")
      for (const NaiveSection& section : family.sections) result.emplace_back("linked-" + family.name, section);
  return result;
}

}  // namespace restrip::verify::test
