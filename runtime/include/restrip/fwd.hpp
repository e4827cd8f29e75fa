// Declarations of the classes that a program names in its own headers: enough for parameters, and for members behind a
// pointer. And how much is done for good strips: the policies of operations (policy.hpp has what each does), and the
// efforts of strips from scratch (stripify.hpp).
#pragma once

#include <cstdint>

#include "restrip/precondition.hpp"

namespace restrip {

class StripMesh;
class LiveMesh;
struct LiveOptions;
struct Interrupt;
struct BakedFile;
struct OperationView;
class LiveBuffer;
class Keeper;

/// The numbers are the codes of the C interface, so a new policy comes last. The order is that of policy.hpp.
enum class Policy : std::uint8_t { bare, rules, local, quick, full };

/// The default policy, chosen for default_cost (mesh/cost.hpp).
inline constexpr Policy default_policy = Policy::quick;

/// In the order of their running times. The resulting cost is never higher than with the previous effort.
enum class Effort {
  fast,  ///< one pass, linear time. Strips: greedy, about 200 to 700 triangles per strip; otherwise strips of some 50
         ///< triangles that keep turning left and right, and a few moves at their ends
  full,  ///< strips: then rounds of tunnelling, towards one strip for each connected component; otherwise annealing and
         ///< chains of moves at strip ends, some 10 microseconds a triangle
  best   ///< strips: the same as full; otherwise annealing for several times as long, and chains until none gains
};

/// The default effort, here and in LiveMesh, in C and JavaScript and on every command line. policy.hpp has the default
/// for maintaining strips.
inline constexpr Effort default_effort = Effort::fast;

}  // namespace restrip
