// Strips of a StripMesh from scratch.
#include "restrip/search/stripify.hpp"

namespace restrip {

template std::size_t stripify(StripMesh&, Effort, Cost, std::uint64_t, std::uint64_t);

}  // namespace restrip
