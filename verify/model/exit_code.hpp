#pragma once
// What the verifying programs say by their exit status.

namespace restrip::verify {

inline constexpr int all_claims_hold = 0;
inline constexpr int some_claim_fails = 1;
inline constexpr int bad_input = 2;

}  // namespace restrip::verify
