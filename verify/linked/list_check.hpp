#pragma once
// Points 1 to 4 of docs/reference/certificate.md, "Linked rules", for one list of alternatives: the conditions under
// which its first sound row is the best, whatever lies outside.

#include <array>
#include <string>

#include "judge/report.hpp"
#include "linked/linked_certificate.hpp"
#include "model/coloring.hpp"

namespace restrip::verify {

/// Ascending: a greater merit is preferred.
struct Merit {
  int solid = 0;
  int fewer_isolated = 0;  ///< minus the isolated triangles
  friend constexpr auto operator<=>(Merit, Merit) = default;
};

/// All ports stay solid.
struct Recoloring {
  Colors colors;
  Survey survey;
  Merit merit;
};

enum class ListClaim { present, legal, ordered, uncovered, complete };
inline constexpr std::size_t list_claim_count = 5;

using ListFailures = std::array<Failures, list_claim_count>;

/// All recolourings with these solid ports, by their inner mask.
std::vector<Recoloring> recolorings_of(const Side& after, Mask ports);

/// Adds the faults of the list of these ports. An illegal row fails only that claim and is otherwise ignored.
void check_list(const Side& after, const std::vector<Recoloring>& recolorings, Mask ports, List list,
                const std::string& file, ListFailures& failures);

}  // namespace restrip::verify
