#pragma once
// Checks a compiled automaton, as a program prints its numbers and digests of its answers (docs/reference/verifiers.md,
// "Dump of the automaton"): each number that a look-up can come to must be what the certificate's rows say, and the
// digests must be those of the certificate's own answers.

#include <cstdint>
#include <cstdio>
#include <string>

#include "automaton/automaton_certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

struct AutomatonDumpCheck {
  std::uint64_t numbers = 0;  ///< compared with rows of the certificate
  std::uint64_t keys = 0;     ///< whose answers were compared, by digests
  Failures wrong_numbers;
  Failures wrong_answers;
  std::string fault;  ///< why the dump could not be read to its end; empty when it could
};

/// Reads a dump with the answers of fans of up to `max_k` triangles to its end.
AutomatonDumpCheck check_automaton_dump(std::FILE* stream, const AutomatonCertificate& certificate, unsigned max_k);

/// Runs the program and checks what it prints.
AutomatonDumpCheck check_automaton_dump_of(const std::string& program, const AutomatonCertificate& certificate,
                                           unsigned max_k);

}  // namespace restrip::verify
