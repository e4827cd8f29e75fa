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

/// The loop colours alone, ports ignored: how the paper counts its 4-vertex rules.
struct LoopOrbits {
  std::size_t all = 0;
  std::size_t without_solid_loop = 0;
};

LoopOrbits loop_orbits(const Section& section) {
  std::set<Mask> seen;
  const Symmetries symmetry = symmetries(operation_at(section.position));
  const Mask end = Mask{1} << section.position.k;
  for (Mask loop = 0; loop < end; ++loop) {
    Mask smallest = loop;
    for (const PatchMap& s : symmetry.maps) smallest = std::min(smallest, permute(loop, s.before));
    seen.insert(smallest);
  }
  return {seen.size(), seen.size() - seen.count(end - 1)};
}

struct Line {
  unsigned k = 0;
  std::size_t configurations = 0;
  std::vector<unsigned> arcs;
  std::vector<std::size_t> valid, orbits, valid_orbits, costing, loops, loops_without_solid;
};

std::string listed(const std::vector<std::size_t>& numbers) { return fmt::format("{}", fmt::join(numbers, " ")); }

std::vector<Line> lines(const std::string& family, unsigned max_k) {
  std::vector<Line> table;
  for (const Section& section : solved(family, max_k, 1)) {
    for (std::size_t i = 0; i < section.serves.size(); ++i) {
      const Claims& claims = section.claims[i];
      if (table.empty() || table.back().k != section.position.k)
        table.push_back({section.position.k, claims.configurations, {}, {}, {}, {}, {}, {}, {}});
      Line& line = table.back();
      line.valid.push_back(claims.valid);
      line.arcs.push_back(section.serves[i].at);
      line.orbits.push_back(claims.orbits);
      line.valid_orbits.push_back(claims.valid_orbits);
      line.costing.push_back(claims.costing);
      if (family == "split") {
        const LoopOrbits loops = loop_orbits(section);
        line.loops.push_back(loops.all);
        line.loops_without_solid.push_back(loops.without_solid_loop);
      }
    }
  }
  return table;
}

}  // namespace

std::string count_report(unsigned max_k) {
  std::string text = "Splits of a closed fan (columns by arc a = 1 … k/2)\n\n";
  const char* format = "{:>2}  {:>14}  {:>9}  {:<30}  {:<30}  {:<16}  {}\n";
  text += fmt::format(fmt::runtime(format), "k", "configurations", "valid", "orbits of all", "orbits of valid",
                      "cost a strip", "loop colours alone");
  std::size_t places = 0;
  for (const Line& line : lines("split", max_k)) {
    places += line.arcs.size();
    text += fmt::format(fmt::runtime(format), line.k, line.configurations, line.valid.front(), listed(line.orbits),
                        listed(line.valid_orbits), listed(line.costing), listed(line.loops));
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
  for (const Line& line : lines("collapse", max_k))
    text += fmt::format(fmt::runtime(narrow), line.k, line.configurations, listed(line.valid),
                        listed(line.valid_orbits), listed(line.costing));
  return text;
}

std::string count_json(unsigned max_k) {
  nlohmann::ordered_json report;
  for (const char* family : {"split", "collapse"}) {
    for (const Line& line : lines(family, max_k)) {
      nlohmann::ordered_json row{{"k", line.k},
                                 {"configurations", line.configurations},
                                 {"arcs", line.arcs},
                                 {"valid", line.valid},
                                 {"orbits", line.orbits},
                                 {"valid_orbits", line.valid_orbits},
                                 {"costing", line.costing}};
      if (!line.loops.empty()) row["loop_orbits"] = line.loops;
      report[family].push_back(row);
    }
  }
  return report.dump(2) + "\n";
}

}  // namespace restrip::generator
