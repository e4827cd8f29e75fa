#pragma once
// Two arcs around A and D, laid down as a small graph: of each arc only its case is there, a strand over each solid
// link that ends, leaves by a port or goes through.

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "arc.hpp"

namespace restrip::verify {

/// A link of one of the two arcs.
struct ArcEnd {
  bool second_arc = false;
  bool right = false;
  friend constexpr bool operator==(ArcEnd, ArcEnd) = default;
};

/// Two cases with A and D between them, in ring order A, first arc, D, second arc.
struct Around {
  std::size_t first = 0;
  std::size_t second = 0;
  bool chord = false;
  bool legal = false;                             ///< degrees of A and D at most two, no cycle
  Worth worth;                                    ///< of A, D and the edges that no arc counts
  std::vector<std::pair<ArcEnd, ArcEnd>> joined;  ///< links whose strands leave by ports and are joined
};
Around around(std::size_t first, std::size_t second, bool chord);

/// All legal ones.
const std::vector<Around>& all_around();

/// Whether, in the ring A, first, D, second of these letters, the ports that two links reach are joined before the
/// operation. A solid port may be joined to the solid port before it in the ring, as its letter says.
bool joined_before(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other);

/// Whether the ports that two links reach follow each other in the fan, so that a key says whether they are joined. In
/// a ring with the boundary in it the last port of the open fan is not followed by the first.
bool in_key(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other);

}  // namespace restrip::verify
