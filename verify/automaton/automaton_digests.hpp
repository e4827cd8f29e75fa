#pragma once
// Digests of what an automaton's certificate answers (docs/reference/verifiers.md, "Digests of the automaton"), to
// compare look-ups in other languages with.

#include "automaton/automaton_certificate.hpp"
#include "judge/answer_digests.hpp"

namespace restrip::verify {

/// The largest fans whose colours, and a bit more, fit a mask.
inline constexpr unsigned largest_digest_fan = 28;

/// Of every position with up to so many triangles.
Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k);

}  // namespace restrip::verify
