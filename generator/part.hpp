// A part of the tables: one section of one certificate, the unit in which work is shared by threads and by machines.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "linked.hpp"
#include "section.hpp"

namespace restrip::generator {

struct Part {
  std::string family;  ///< as its certificate names it: "linked-split" for linked rules of the split
  std::variant<Section, LinkedSection> section;
  std::string text;  ///< of the section, as the certificate writes it
};

/// All parts for valences up to max_k (3 … 13), not yet solved, in the order of the certificates and their sections.
[[nodiscard]] std::vector<Part> parts(unsigned max_k, Goal goal = Goal::strips);

[[nodiscard]] const Position& position_of(const Part& part);

/// How many rows a solved part has.
[[nodiscard]] std::size_t rows_of(const Part& part);

/// What is wanted of a part: with the text come the reasons, which take most of the time.
enum class Wanted { rules, rules_and_text };

/// Finds rules and reasons, and writes the text. Threads may solve different parts at the same time.
void solve(Part& part, Wanted wanted = Wanted::rules_and_text);

/// The place in `all` of the parts that belong to shard `index` (1 … count) of `count`, ascending. Every part is in
/// exactly one shard. Parts are dealt out by an estimate of their time, the longest first, each to the shard that has
/// least: so shards take about the same time as long as there are clearly more long parts than shards.
[[nodiscard]] std::vector<std::size_t> share_of(const std::vector<Part>& all, unsigned index, unsigned count);

}  // namespace restrip::generator
