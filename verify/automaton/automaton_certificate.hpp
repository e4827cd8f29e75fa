#pragma once
// The automaton's certificate in memory, and its parser (docs/automaton.md, "Certificate"). The parser settles form:
// every row that must be there, in its order, and no other. Whether a row is true is checked elsewhere.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "arc.hpp"

namespace restrip::verify {

struct AutomatonStep {
  std::size_t to = 0;
  Worth gain;
  std::array<std::size_t, all_cases.size()> from{};  ///< for each case that `to` has; its place in all_cases
  unsigned line = 0;
};

struct AutomatonClass {
  std::string witness;
  Worths values;
  std::array<std::optional<AutomatonStep>, 4> steps;  ///< by letter; no boundary behind a boundary
  unsigned line = 0;

  bool has_boundary() const { return verify::has_boundary(witness); }
};

/// An arc that is a whole closed fan.
struct AutomatonClosing {
  std::size_t arc = 0;
  Worth value;
  unsigned line = 0;
};

/// Two arcs around A and D.
struct AutomatonMeeting {
  std::size_t first = 0;
  std::size_t second = 0;
  bool chord = false;
  Worth value;
  unsigned line = 0;
};

struct AutomatonCertificate {
  std::string file;
  std::vector<AutomatonClass> classes;
  std::vector<std::optional<AutomatonClosing>> closings;               ///< by class
  std::vector<std::vector<std::optional<AutomatonMeeting>>> meetings;  ///< by first and second class
  std::size_t rows = 0;

  /// Whether an arc of this class can lie between A and D, or be a whole closed fan.
  bool can_be_first(std::size_t c) const { return c != 0 && !classes[c].has_boundary(); }
};

/// InputError when anything is not as docs/automaton.md says.
AutomatonCertificate parse_automaton(const std::string& file, std::string text);

}  // namespace restrip::verify
