// Whether a locator agrees with a walk along the strip of every triangle.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "restrip/output/strips.hpp"
#include "search/strip_locator.hpp"

namespace restrip {

/// What is wrong, or nothing: along every strip the order grows or falls in steps of one, and no two strips share a
/// name.
inline std::string disagreement(const StripLocator& locator, const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  if (strips.size() != locator.strips())
    return std::to_string(locator.strips()) + " strips in the locator, " + std::to_string(strips.size()) +
           " in the mesh";
  std::set<std::uint32_t> names;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    const StripLocator::Position first = locator.position(strip.front());
    if (!names.insert(first.strip).second) return "two strips with one name";
    const bool up = strip.size() < 2 || locator.position(strip[1]).order > first.order;
    for (std::size_t i = 1; i < strip.size(); ++i) {
      const StripLocator::Position a = locator.position(strip[i - 1]);
      const StripLocator::Position b = locator.position(strip[i]);
      if (b.strip != first.strip) return "a strip with two names";
      if (b.order != (up ? a.order + 1 : a.order - 1)) return "out of order";
      const auto forwards = locator.position(strip[i - 1], strip[i]);
      const auto backwards = locator.position(strip[i], strip[i - 1]);
      if (forwards.first.strip != a.strip || forwards.first.order != a.order || forwards.second != b.order ||
          backwards.first.strip != a.strip || backwards.first.order != b.order || backwards.second != a.order)
        return "two triangles together are not where each is";
    }
  }
  return "";
}

}  // namespace restrip
