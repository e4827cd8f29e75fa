// Checks a compiled automaton, given a program's output of its numbers and of digests of its answers
// (docs/reference/verifiers.md, "Dump of the automaton"): each number that a look-up can use must agree with the
// certificate's rows, and the digests must equal the digests of the certificate's answers.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "automaton/automaton_certificate.hpp"
#include "judge/answer_digests.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

struct AutomatonDumpCheck {
  std::uint64_t numbers = 0;  ///< numbers compared with rows of the certificate
  std::uint64_t keys = 0;     ///< keys whose answers were compared, by digests
  Failures wrong_numbers;
  Failures wrong_answers;
  std::string fault;  ///< why the dump could not be read to its end; otherwise empty
};

/// Reads a dump with the answers of fans of up to `max_k` triangles to its end.
AutomatonDumpCheck check_automaton_dump(std::FILE* stream, const AutomatonCertificate& certificate, unsigned max_k);

/// Runs the program and checks its output.
AutomatonDumpCheck check_automaton_dump_of(const std::string& program, const AutomatonCertificate& certificate,
                                           unsigned max_k);

/// The largest fans whose colours, plus a few bits, fit a mask.
inline constexpr unsigned largest_digest_fan = 28;

/// Digests of the answers of a certificate at every position with up to `max_k` triangles
/// (docs/reference/verifiers.md, "Digests of the automaton"), to compare look-ups in other languages with.
Digests automaton_digests(const AutomatonCertificate& certificate, unsigned max_k);

}  // namespace restrip::verify
