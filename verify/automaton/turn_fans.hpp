#pragma once
// The index automaton's answers in whole fans: triangles with their corners, every colouring tried, every strip walked,
// every swap found by the corners about which strips pass.

#include "fan_check.hpp"
#include "turn_answers.hpp"

namespace restrip::verify {

/// Every key of every place of valence k, of all families, with all that may lie behind the ports: the answer must be
/// sound, cost what it says, and no sound recolouring may cost less. `every` = n looks at the first place and every
/// n-th after it.
FanCheck check_turns_against_search(const TurnCertificate& certificate, unsigned k, unsigned every = 1);

}  // namespace restrip::verify
