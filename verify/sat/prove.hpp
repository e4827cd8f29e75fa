#pragma once
// Every position of the certificates: its formula, the solver's verdict, the check of the solver's proof, the controls.

#include <functional>
#include <string>
#include <vector>

#include "sat/controls.hpp"

namespace restrip::verify::sat {

struct Options {
  std::string tables_dir = "tables";
  std::vector<std::string> families;  ///< of certificates; all when empty
  unsigned max_k = largest_fan;
  std::string solver = "cadical";
  std::string checker;       ///< another one, instead of ours
  std::string lrat_checker;  ///< one that confirms what ours has found, given the proof as LRAT; none when empty
  std::string out;           ///< where formulas and proofs are kept; nowhere when empty
  bool controls = false;
  std::size_t control_rows = 2;  ///< rows that the controls alter at each position; 0 for every row
  unsigned threads = 1;
};

struct PositionResult {
  std::string name;  ///< "open-split k 8 gaps 2 5"
  std::size_t variables = 0;
  std::size_t clauses = 0;
  std::size_t proof_lines = 0;
  std::size_t core = 0;  ///< lines on which the empty clause rests; only our own checker tells
  double seconds = 0;    ///< wall clock, controls not included
  std::string fault;     ///< why the position is not proved
  ControlResult controls;

  bool held() const { return fault.empty() && controls.fault.empty(); }
};

/// The listener hears of each position in the order of the certificates, whatever the threads do. Throws InputError
/// (bad certificates, unknown family) and std::runtime_error (a program that cannot be run, a folder that cannot be
/// written).
void prove_tables(const Options& options, const std::function<void(const PositionResult&)>& listener);

}  // namespace restrip::verify::sat
