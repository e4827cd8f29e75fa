// restrip-sat: proves that no rule can be beaten, by a SAT solver whose proofs are checked.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "files/report_output.hpp"
#include "files/system_calls.hpp"
#include "model/input.hpp"
#include "model/program.hpp"
#include "sat/prove.hpp"

namespace {

using namespace restrip::verify;

struct Sums {
  std::size_t positions = 0;
  std::size_t failed = 0;
  std::size_t clauses = 0;
  std::size_t proof_lines = 0;
  std::size_t core = 0;
  sat::ControlResult controls;
};

std::string line_of(const sat::PositionResult& result, bool controls) {
  std::string line = fmt::format("{:<28} {:>9} {:>7} {:>11} {:>6} {:>7.2f}", result.name, result.variables,
                                 result.clauses, result.proof_lines, result.core, result.seconds);
  if (controls)
    line += fmt::format(" {:>7} {:>4} of {}", result.controls.altered_formulas, result.controls.refused,
                        result.controls.cut_proofs);
  if (!result.fault.empty()) line += "\n  NOT PROVED: " + result.fault;
  if (!result.controls.fault.empty()) line += "\n  CONTROL FAILED: " + result.controls.fault;
  return line + '\n';
}

nlohmann::ordered_json json_of(const sat::PositionResult& result) {
  return {{"position", result.name},
          {"variables", result.variables},
          {"clauses", result.clauses},
          {"proof_lines", result.proof_lines},
          {"core", result.core},
          {"seconds", result.seconds},
          {"altered_formulas", result.controls.altered_formulas},
          {"cut_proofs", result.controls.cut_proofs},
          {"refused", result.controls.refused},
          {"proved", result.fault.empty()},
          {"fault", result.fault.empty() ? result.controls.fault : result.fault}};
}

std::string closing_line(const Sums& sums, const sat::Options& options) {
  std::string line =
      fmt::format("{}: {} positions, {} clauses, {} proof lines checked by {}",
                  sums.failed == 0 ? "proved" : fmt::format("NOT proved ({} failed)", sums.failed), sums.positions,
                  sums.clauses, sums.proof_lines, options.checker.empty() ? "restrip-sat" : options.checker);
  if (!options.lrat_checker.empty())
    line += fmt::format(", the {} on which they rest by {}", sums.core, options.lrat_checker);
  if (options.controls)
    line += fmt::format("; {} altered formulas satisfiable; {} of {} cut proofs refused",
                        sums.controls.altered_formulas, sums.controls.refused, sums.controls.cut_proofs);
  return line + "; read: certificates only; no header was read\n";
}

int run(const sat::Options& options, const std::string& json) {
  const restrip::files::ReportOutput out(json);
  const bool text = !out.replaces_text();
  Sums sums;
  nlohmann::ordered_json positions = nlohmann::ordered_json::array();
  const bool show_progress = !text && isatty(STDERR_FILENO) != 0;
  if (text)
    fmt::print("{:<28} {:>9} {:>7} {:>11} {:>6} {:>7}{}\n", "position", "variables", "clauses", "proof lines", "core",
               "seconds", options.controls ? " altered  cut proofs refused" : "");
  sat::prove_tables(options, [&](const sat::PositionResult& result) {
    ++sums.positions;
    sums.failed += result.held() ? 0U : 1U;
    sums.clauses += result.clauses;
    sums.proof_lines += result.proof_lines;
    sums.core += result.core;
    sums.controls.altered_formulas += result.controls.altered_formulas;
    sums.controls.cut_proofs += result.controls.cut_proofs;
    sums.controls.refused += result.controls.refused;
    if (show_progress) fmt::print(stderr, "\r{} positions", sums.positions);
    positions.push_back(json_of(result));
    if (text) fmt::print("{}", line_of(result, options.controls));
    std::fflush(stdout);
  });
  if (show_progress) fmt::print(stderr, "\r\x1b[K");
  out.print(closing_line(sums, options),
            nlohmann::ordered_json{{"proved", sums.failed == 0}, {"positions", positions}}.dump(2) + "\n");
  return sums.failed == 0 ? all_claims_hold : some_claim_fails;
}

/// Our checker on its own.
int check_one(const std::string& formula, const std::string& proof) {
  const sat::Cnf cnf = sat::parse_dimacs(formula, read_file(formula));
  const sat::ProofVerdict verdict = sat::check_proof(cnf, sat::parse_proof(proof, read_file(proof), cnf.variables));
  fmt::print("{}\n", verdict.proved ? "s VERIFIED" : fmt::format("s NOT VERIFIED\nc {}: {}", proof, verdict.fault));
  return verdict.proved ? all_claims_hold : some_claim_fails;
}

}  // namespace

int main(int argc, char** argv) {
  restrip::files::ignore_file_size_signal();
  sat::Options options;
  std::string json;
  std::vector<std::string> files;

  CLI::App app(
      "Proves by SAT that no rule can be beaten: for each position a formula says that some valid configuration has a "
      "sound recolouring better than its row; a solver finds that it cannot be satisfied, and its proof is checked.");
  app.name("restrip-sat");
  app.footer(
      "Exit code: 0 all proved, 1 something is not, 2 bad input or a program that cannot be run.\n\n"
      "Examples, from the top of the source tree (the package cadical must be installed):\n"
      "  build/release/bin/restrip-sat --tables-dir tables --threads 2\n"
      "  build/release/bin/restrip-sat --tables-dir tables --family split --controls --out /tmp/restrip-proofs");
  app.add_option("--tables-dir", options.tables_dir, "The folder with certificates/")->capture_default_str();
  app.add_option("--family", options.families, "Only this certificate, such as split; may be repeated");
  app.add_option("--solver", options.solver, "Called as SOLVER -q --no-binary FORMULA PROOF")->capture_default_str();
  auto* const checker = app.add_option("--checker", options.checker,
                                       "Another proof checker, such as drat-trim, called as CHECKER FORMULA PROOF");
  app.add_option("--lrat-checker", options.lrat_checker,
                 "A checker of LRAT, such as restrip-lrat, that must accept each proof as well; called as CHECKER "
                 "FORMULA PROOF")
      ->excludes(checker);
  app.add_option("--out", options.out, "Keep formulas and proofs, as DRAT and as LRAT, in this folder");
  auto* const controls =
      app.add_flag("--controls", options.controls,
                   "Alter rows, which must make the formulas satisfiable, and cut lines out of the proofs");
  app.add_option("--control-rows", options.control_rows,
                 "Rows that --controls alters at each position; 0 for every row")
      ->capture_default_str()
      ->needs(controls);
  add_json_option(app, json);
  app.add_option("--threads", options.threads, "How many threads; the result does not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  auto* const check = app.add_option("--check", files, "Only check one proof: --check FORMULA PROOF");
  check->expected(2)->type_name("FILE FILE");
  for (CLI::Option* option : app.get_options())
    if (option != check && option->get_name() != "--help") check->excludes(option);
  return exit_code_of(app, argc, argv,
                      [&] { return files.empty() ? run(options, json) : check_one(files[0], files[1]); });
}
