#include "tables/count.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Orbits of the loop colours alone, without ports: the paper counts its 4-vertex rules in this way.
std::size_t loop_orbits(const Section& section) {
  std::set<Mask> seen;
  const Symmetries symmetry = symmetries(operation_at(section.position));
  for (Mask loop = 0; loop < Mask{1} << section.position.k; ++loop) {
    Mask smallest = loop;
    for (const PatchMap& s : symmetry.maps) smallest = std::min(smallest, permute(loop, s.before));
    seen.insert(smallest);
  }
  return seen.size();
}

/// A row for each k, with lists by position.
OrderedJson rows_of(const std::string& family, unsigned max_k) {
  OrderedJson rows;
  for (const Section& section : solved(family, max_k, 1))
    for (std::size_t i = 0; i < section.serves.size(); ++i) {
      const Claims& claims = section.claims[i];
      if (rows.empty() || rows.back()["k"] != section.position.k)
        rows.push_back({{"k", section.position.k}, {"configurations", claims.configurations}});
      OrderedJson& row = rows.back();
      row["arcs"].push_back(section.serves[i].at);
      row["valid"].push_back(claims.valid);
      row["orbits"].push_back(claims.orbits);
      row["valid_orbits"].push_back(claims.valid_orbits);
      row["costing"].push_back(claims.costing);
      if (family == "split") row["loop_orbits"].push_back(loop_orbits(section));
    }
  return rows;
}

std::string listed(const OrderedJson& numbers) {
  return fmt::format("{}", fmt::join(numbers.get<std::vector<std::size_t>>(), " "));
}

}  // namespace

CountReport count(unsigned max_k) {
  OrderedJson report;
  for (const char* family : {"split", "collapse"}) report[family] = rows_of(family, max_k);
  std::string text = "Splits of a closed fan (columns by arc a = 1 … k/2)\n\n";
  const char* format = "{:>2}  {:>14}  {:>9}  {:<30}  {:<30}  {:<16}  {}\n";
  text += fmt::format(fmt::runtime(format), "k", "configurations", "valid", "orbits of all", "orbits of valid",
                      "cost a strip", "loop colours alone");
  std::size_t places = 0;
  for (const OrderedJson& row : report["split"]) {
    places += row["arcs"].size();
    text += fmt::format(fmt::runtime(format), row["k"].get<unsigned>(), row["configurations"].get<std::size_t>(),
                        row["valid"][0].get<std::size_t>(), listed(row["orbits"]), listed(row["valid_orbits"]),
                        listed(row["costing"]), listed(row["loop_orbits"]));
  }
  text += fmt::format(
      "\n{} split positions to k = {}; with k = 9 the paper's text counts nineteen.\n"
      "configurations      colours of the 2k dual edges at the vertex\n"
      "valid               degrees at most two and no solid loop\n"
      "orbits              classes under the mirror and, where a = k - a, the half turn\n"
      "cost a strip        valid configurations whose best rule adds one strip\n"
      "loop colours alone  orbits when the ports are ignored: the paper draws 9 + 9 for its 4-vertex; here 10 and 9, "
      "and\n"
      "                    9 and 8 without the all-solid loop, which no stripification has\n",
      places, max_k);
  text += "\nCollapses onto a closed fan\n\n";
  const char* narrow = "{:>2}  {:>14}  {:<28}  {:<24}  {}\n";
  text += fmt::format(fmt::runtime(narrow), "k", "configurations", "valid", "orbits of valid", "cost a strip");
  for (const OrderedJson& row : report["collapse"])
    text += fmt::format(fmt::runtime(narrow), row["k"].get<unsigned>(), row["configurations"].get<std::size_t>(),
                        listed(row["valid"]), listed(row["valid_orbits"]), listed(row["costing"]));
  return {text, report.dump(2) + "\n"};
}

}  // namespace restrip::generator
