#include <fmt/format.h>

#include <cstdint>
#include <set>

#include "common/counted.hpp"
#include "lod/coloring_check.hpp"
#include "restrip/output/strips.hpp"
#include "search/strip_locator.hpp"

namespace restrip::tools {

std::string find_fault(const StripMesh& mesh, const StripLocator& locator) {
  const Strips strips = extract_strips(mesh);
  if (strips.size() != locator.strips())
    return fmt::format("{}, but the locator has {}", counted(strips.size(), "strip"), locator.strips());
  for (const Triangle t : strips.order)
    if (!locator.knows(t)) return fmt::format("the locator does not know triangle {}", t);
  std::set<std::uint32_t> names;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    const StripLocator::Position first = locator.position(strip.front());
    const bool up = first.order < locator.position(strip.back()).order;
    if (!names.insert(first.strip).second)
      return fmt::format("the locator has the strip of triangle {} twice", strip.front());
    for (std::size_t i = 1; i < strip.size(); ++i) {
      const StripLocator::Position before = locator.position(strip[i - 1]);
      const StripLocator::Position here = locator.position(strip[i]);
      if (here.strip != first.strip || here.order == before.order || (before.order < here.order) != up)
        return fmt::format("the locator has triangle {} in the wrong place", strip[i]);
    }
  }
  return {};
}

}  // namespace restrip::tools
