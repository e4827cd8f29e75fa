#pragma once
// Points 1 to 4 of docs/certificate.md, "Linked rules", for one list of alternatives: what it takes for its first row
// that is sound to be the best, whatever lies outside.

#include <array>
#include <string>

#include "judgment.hpp"
#include "linked_certificate.hpp"

namespace restrip::verify {

enum class ListClaim { present, legal, ordered, uncovered, complete };
inline constexpr std::size_t list_claim_count = 5;

using ListFailures = std::array<Failures, list_claim_count>;

/// All recolourings beside these solid ports, by their inner mask.
std::vector<SurveyedColoring> recolorings_of(const Patch& after, Mask ports);

/// Adds what is wrong with the list of these ports. An illegal row fails that claim alone and counts nowhere else.
void check_list(const Patch& after, const std::vector<SurveyedColoring>& recolorings, Mask ports, List list,
                const std::string& file, ListFailures& failures);

}  // namespace restrip::verify
