#include "sat/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

#include "model/coloring.hpp"
#include "model/input.hpp"
#include "model/on_threads.hpp"
#include "sat/solver.hpp"
#include "sat/work_folder.hpp"

namespace restrip::verify::sat {
namespace {

struct Task {
  const Operation* operation = nullptr;
  const SectionRows* rows = nullptr;
  std::string certificate;
};

std::string in_words(const Task& task, const Counterexample& found) {
  std::string text = fmt::format("inner {:x}, ports {:x} can become inner {:x}, ports {:x}, which beats its row",
                                 found.before.inner, found.before.ports, found.after.inner, found.after.ports);
  const Survey before = survey(task.operation->before, found.before);
  const std::vector<Bound> bounds =
      bounds_of(position_of(task.operation->family, task.operation->position), task.rows->rows);
  const auto bound = std::find_if(bounds.begin(), bounds.end(), [&](const Bound& candidate) {
    return before.valid && has_key(candidate, found.before.ports, before.joined);
  });
  if (bound == bounds.end())
    return text + fmt::format(" ({} has no row for ports {:x} that join {})", task.certificate, found.before.ports,
                              listed(before.joined, task.operation->ports()));
  const auto place = static_cast<std::size_t>(bound - bounds.begin());
  return text + fmt::format(" ({}:{})", task.certificate, task.rows->rows[place].line);
}

class Prover {
 public:
  Prover(const Task& task, const Options& options, const WorkFolder& folder)
      : task_(task), options_(options), folder_(folder) {
    result_.name = task.operation->name();
    file_ = result_.name;
    std::replace(file_.begin(), file_.end(), ' ', '-');
  }

  PositionResult prove() {
    const auto start = std::chrono::steady_clock::now();
    const Position position = position_of(task_.operation->family, task_.operation->position);
    const std::vector<Bound> bounds = bounds_of(position, task_.rows->rows);
    const Encoding encoding = encode(position, bounds);
    result_.variables = static_cast<std::size_t>(encoding.cnf.variables);
    result_.clauses = encoding.cnf.clauses.size();
    const Model model = solved(encoding, file_);
    if (model) result_.fault = in_words(task_, read_back(encoding, *model));
    if (!model) check(encoding.cnf);
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (result_.fault.empty() && options_.controls) {
      if (options_.checker.empty()) cut_proof(encoding.cnf, proof_, verdict_, result_.controls);
      alter_rows(position, bounds);
    }
    folder_.finish(file_ + ".cnf");
    if (!model) folder_.finish(file_ + ".drat");
    if (verdict_.proved) folder_.finish(file_ + ".lrat");
    return std::move(result_);
  }

 private:
  Model solved(const Encoding& encoding, const std::string& name) const {
    folder_.write(name + ".cnf", dimacs_of(encoding.cnf, result_.name));
    return solve(options_.solver, folder_.path(name + ".cnf"), folder_.path(name + ".drat"),
                 folder_.path(name + ".answer"), encoding.cnf.variables);
  }

  void check(const Cnf& cnf) {
    const std::string formula_file = folder_.path(file_ + ".cnf");
    const std::string proof_file = folder_.path(file_ + ".drat");
    // Read back from the files, so that they alone are what was checked.
    proof_ = parse_proof(proof_file, read_file(proof_file), cnf.variables);
    result_.proof_lines = proof_.size();
    if (!options_.checker.empty()) {
      if (!foreign_checker_agrees(options_.checker, formula_file, proof_file, folder_.path(file_ + ".answer")))
        result_.fault = fmt::format("{} does not accept the proof", options_.checker);
      return;
    }
    verdict_ = check_proof(parse_dimacs(formula_file, read_file(formula_file)), proof_);
    result_.core = verdict_.core.size();
    if (!verdict_.proved) {
      result_.fault = fmt::format("the proof is wrong: {}", verdict_.fault);
      return;
    }
    folder_.write(file_ + ".lrat", lrat_of(cnf, proof_, verdict_));
    if (!options_.lrat_checker.empty() &&
        !foreign_checker_agrees(options_.lrat_checker, formula_file, folder_.path(file_ + ".lrat"),
                                folder_.path(file_ + ".answer")))
      result_.fault = fmt::format("{} does not accept the proof", options_.lrat_checker);
  }

  void alter_rows(const Position& position, const std::vector<Bound>& bounds) {
    const std::size_t rows =
        options_.control_rows == 0 ? bounds.size() : std::min(options_.control_rows, bounds.size());
    for (std::size_t i = 0; i < rows && result_.controls.fault.empty(); ++i) {
      const std::size_t row = i * bounds.size() / rows;
      for (const Alteration& alteration : alterations(position, bounds, row)) {
        const Encoding encoding =
            options_.control_rows == 0 ? with_key_as_facts(position, alteration) : encode(position, alteration.bounds);
        const Model model = solved(encoding, file_ + ".altered");
        ++result_.controls.altered_formulas;
        const std::string fault =
            model ? objection(*task_.operation, read_back(encoding, *model), alteration.beaten) : "still unsatisfiable";
        if (!fault.empty())
          result_.controls.fault =
              fmt::format("{}:{}: {}: {}", task_.certificate, task_.rows->rows[row].line, alteration.what, fault);
      }
    }
  }

  const Task& task_;
  const Options& options_;
  const WorkFolder& folder_;
  std::string file_;
  Proof proof_;
  ProofVerdict verdict_;
  PositionResult result_;
};

}  // namespace

void prove_tables(const Options& options, const std::function<void(const PositionResult&)>& listener) {
  const std::vector<Family> families = all_families(options.max_k);
  for (const std::string& name : options.families)
    if (std::none_of(families.begin(), families.end(), [&](const Family& family) { return family.name == name; }))
      throw InputError("--family", 0, fmt::format("there is no family \"{}\"", name));
  std::vector<Certificate> certificates;
  std::vector<Task> tasks;
  certificates.reserve(families.size());
  for (const Family& family : families) {
    if (!options.families.empty() &&
        std::find(options.families.begin(), options.families.end(), family.name) == options.families.end())
      continue;
    const std::string file = options.tables_dir + "/certificates/" + family.name + ".cert";
    certificates.push_back(parse_certificate(file, read_file(file), family));
    for (std::size_t i = 0; i < family.sections.size(); ++i)
      for (const Operation& operation : family.sections[i].operations)
        tasks.push_back({&operation, &certificates.back().sections[i], file});
  }

  const WorkFolder folder(options.out);
  std::vector<std::optional<PositionResult>> results(tasks.size());
  std::size_t told = 0;
  std::mutex mutex;
  on_threads(options.threads, tasks.size(), [&] {
    return [&](std::size_t i) {
      PositionResult result = Prover(tasks[i], options, folder).prove();
      const std::lock_guard lock(mutex);
      results[i] = std::move(result);
      for (; told < results.size() && results[told]; ++told) listener(*results[told]);
    };
  });
}

}  // namespace restrip::verify::sat
