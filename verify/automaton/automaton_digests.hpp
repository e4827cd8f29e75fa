#pragma once
// Digests of the answers of an automaton's certificate (docs/reference/verifiers.md, "Digests of the automaton"), for
// comparison with look-ups in other languages.

#include "automaton/automaton_certificate.hpp"
#include "judge/answer_digests.hpp"

namespace restrip::verify {

/// The largest fans whose colours, plus a few bits, fit a mask.
inline constexpr unsigned largest_digest_fan = 28;

/// The digests of every position with up to `max_k` triangles.
Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k);

}  // namespace restrip::verify
