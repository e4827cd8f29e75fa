// The automaton's certificate in memory, and its parser (docs/explanation/automaton.md, "Certificate"). The parser
// checks form: exactly the required rows, in order. The truth of rows is checked elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "automaton/arc.hpp"
#include "judge/report.hpp"
#include "judge/table_dump.hpp"

namespace restrip::verify {

struct AutomatonStep {
  std::size_t to = 0;
  int cost = 0;
  std::array<std::size_t, case_count> from{};  ///< for each case of `to`
  unsigned line = 0;
};

struct AutomatonClass {
  std::string witness;
  std::optional<std::size_t> as_first;   ///< its row of meetings; empty for the empty arc and with the boundary inside
  std::optional<std::size_t> as_second;  ///< its column; empty for the empty arc
  Costs costs;
  std::vector<std::optional<AutomatonStep>> steps;  ///< by letter; none for a boundary after a boundary
  unsigned line = 0;

  bool has_boundary() const { return verify::has_boundary(witness); }
};

/// An arc that is a whole closed fan.
struct AutomatonClosing {
  std::size_t arc = 0;
  unsigned line = 0;
};

/// Two arcs around A and D.
struct AutomatonMeeting {
  std::size_t first = 0;
  std::size_t second = 0;
  bool chord = false;
  unsigned line = 0;
};

struct AutomatonCertificate {
  std::string file;
  std::vector<AutomatonClass> classes;
  std::vector<std::optional<AutomatonClosing>> closings;  ///< by class
  std::vector<std::vector<AutomatonMeeting>> meetings;    ///< by row and column
  std::size_t rows = 0;

  const AutomatonStep* step(std::size_t c, char letter) const {
    const auto& found = classes[c].steps[letters.find(letter)];
    return found ? &*found : nullptr;
  }
  /// The meeting of two classes that can be the first and the second arc.
  const AutomatonMeeting& meeting(std::size_t first, std::size_t second) const {
    return meetings[classes[first].as_first.value()][classes[second].as_second.value()];
  }
};

/// Throws InputError if anything differs from docs/explanation/automaton.md.
AutomatonCertificate parse_automaton(const std::string& file, std::string text);

// Checks a compiled automaton, given a program's output of its numbers and of digests of its answers
// (docs/reference/verifiers.md, "Dump of the automaton"): each number that a look-up can use must agree with the
// certificate's rows, and the digests must equal the digests of the certificate's answers.

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
