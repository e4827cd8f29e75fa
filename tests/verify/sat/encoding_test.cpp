// The encoder: its formulas have exactly the models that the verifier's survey of colours wants, and none of the
// deliberate faults of encoding_faults.txt goes unnoticed. They lie in the copy that this program is built of.
#include "sat/encoding.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "model/coloring.hpp"
#include "model/input.hpp"
#include "naive_rup.hpp"
#include "sat/controls.hpp"
#include "sat/mutant_names.hpp"
#include "sat/mutants.hpp"
#include "sat/solver.hpp"
#include "sat/work_folder.hpp"
#include "support.hpp"

namespace restrip::verify::sat::test {
namespace {

/// A position with the bounds that the shipped certificates give it.
struct Given {
  const Operation* operation;
  Position position;
  std::vector<Bound> bounds;
};

const std::vector<Given>& shipped_positions() {
  static const std::vector<Family> families = all_families();
  static const std::vector<Given> positions = [] {
    std::vector<Given> result;
    for (const Family& family : families) {
      const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
      const Certificate certificate = parse_certificate(file, read_file(file), family);
      for (std::size_t i = 0; i < family.sections.size(); ++i)
        for (const Operation& operation : family.sections[i].operations) {
          Position position = position_of(operation.family, operation.position);
          std::vector<Bound> bounds = bounds_of(position, certificate.sections[i].rows);
          result.push_back({&operation, std::move(position), std::move(bounds)});
        }
    }
    return result;
  }();
  return positions;
}

std::size_t colors_of(const Given& given) {
  return given.position.before.edges.size() + given.position.after.edges.size() + given.position.after.owner.size() +
         (given.position.gives_ports_up ? given.position.after.owner.size() : 0);
}

struct Comparison {
  std::size_t pairs = 0;
  std::size_t models = 0;
  std::size_t differences = 0;
  std::string first_difference;
};

/// Every assignment of the inputs, extended by unit propagation, against the verifier's judgment.
void compare_models(const Given& given, const std::vector<Bound>& bounds, Comparison& result) {
  const Encoding encoding = encode(given.position, bounds);
  std::vector<Literal> inputs;
  for (const auto* part : {&encoding.ports, &encoding.before, &encoding.after})
    inputs.insert(inputs.end(), part->begin(), part->end());
  if (given.position.gives_ports_up)
    inputs.insert(inputs.end(), encoding.ports_after.begin(), encoding.ports_after.end());
  ASSERT_EQ(inputs.size(), colors_of(given));
  for (Mask colors = 0; colors < mask_count(static_cast<unsigned>(inputs.size())); ++colors) {
    std::vector<Literal> facts;
    for (unsigned i = 0; i < inputs.size(); ++i) facts.push_back(is_solid(colors, i) ? inputs[i] : -inputs[i]);
    const Propagation found = propagate(encoding.cnf.clauses, encoding.cnf.variables, facts);
    ASSERT_TRUE(found.conflict || std::find(found.value.begin() + 1, found.value.end(), 0) == found.value.end())
        << "the inputs leave a variable open";
    std::vector<bool> model;
    for (const int value : found.value) model.push_back(value > 0);
    const Counterexample pair = read_back(encoding, model);  // looks at inputs only
    const Survey before = survey(given.operation->before, pair.before);
    bool beats = false;
    if (before.valid) {
      const auto bound = std::find_if(bounds.begin(), bounds.end(), [&](const Bound& candidate) {
        return has_key(candidate, pair.before.ports, before.joined);
      });
      ASSERT_NE(bound, bounds.end());
      beats = objection(*given.operation, pair, *bound).empty();
    }
    ++result.pairs;
    result.models += beats ? 1U : 0U;
    if (beats != found.conflict) continue;
    if (result.differences++ == 0)
      result.first_difference = fmt::format("{}: inner {:x}, ports {:x} to inner {:x}, ports {:x}: {} to the verifier",
                                            given.operation->name(), pair.before.inner, pair.before.ports,
                                            pair.after.inner, pair.after.ports, beats ? "better" : "not better");
  }
}

/// The bounds as they are, and all of them made worse in each way.
Comparison compare_models(const Given& given) {
  Comparison result;
  compare_models(given, given.bounds, result);
  EXPECT_EQ(result.models, 0U) << given.operation->name();
  std::vector<Bound> less_solid = given.bounds;
  std::vector<Bound> more_isolated = given.bounds;
  std::vector<Bound> fewer_kept = given.bounds;
  for (Bound& bound : less_solid) --bound.solid;
  for (Bound& bound : more_isolated) ++bound.isolated;
  for (Bound& bound : fewer_kept) --bound.kept;
  compare_models(given, less_solid, result);
  compare_models(given, more_isolated, result);
  if (given.position.gives_ports_up) compare_models(given, fewer_kept, result);
  return result;
}

TEST(SatEncoding, ModelsAreThePairsThatBeatTheBounds) {
  Comparison all;
  std::size_t positions = 0;
  for (const Given& given : shipped_positions()) {
    if (colors_of(given) > 13) continue;
    ++positions;
    const Comparison one = compare_models(given);
    EXPECT_EQ(one.differences, 0U) << one.first_difference;
    all.pairs += one.pairs;
    all.models += one.models;
  }
  // Closed fans of three triangles, open ones of up to four or five, the flip.
  EXPECT_GE(positions, 15U);
  EXPECT_GT(all.pairs, 100000U);
  EXPECT_GT(all.models, 1000U);
}

TEST(SatEncoding, EveryPositionIsThere) {
  // docs/notation.md, "The families".
  std::size_t expected = 1;
  for (std::size_t k = 1; k <= largest_fan; ++k) {
    if (k >= 3) expected += 2 * (k / 2);
    for (std::size_t i = 0; i <= k; ++i)
      for (std::size_t j = i + 1; j <= k; ++j) expected += i + j <= k ? 2U : 0U;
    expected += 2 * (k / 2 + 1);
  }
  EXPECT_EQ(shipped_positions().size(), expected);
}

bool has_model(const Position& position, const std::vector<Bound>& bounds, const WorkFolder& folder) {
  const Cnf cnf = encode(position, bounds).cnf;
  folder.write("f.cnf", dimacs_of(cnf, "a fault or none"));
  return solve("cadical", folder.path("f.cnf"), folder.path("f.drat"), folder.path("f.answer"), cnf.variables)
      .has_value();
}

/// Whether every `stride`-th row of a small position can be beaten when it is altered.
bool altered_rows_have_models(const Given& given, std::size_t stride, const WorkFolder& folder) {
  for (std::size_t row = 0; colors_of(given) <= 12 && row < given.bounds.size(); row += stride)
    for (const Alteration& alteration : alterations(given.position, given.bounds, row))
      if (!has_model(given.position, alteration.bounds, folder)) return false;
  return true;
}

// Those of the flip and of splits are controls of the program (SatProofs.ControlsHold).
TEST(SatEncoding, AlteredRowsCanBeBeaten) {
  RESTRIP_NEEDS_CADICAL();
  const WorkFolder folder("");
  for (const Given& given : shipped_positions())
    EXPECT_TRUE(altered_rows_have_models(given, 7, folder)) << given.operation->name();
}

/// How a fault shows: some position becomes satisfiable; some altered row does not; or only the comparison of models
/// tells.
enum class Shows { satisfiable, control, models };

bool is_noticed(Shows by, const WorkFolder& folder) {
  const auto shows = [&](const Given& given) {
    switch (by) {
      case Shows::satisfiable:
        return colors_of(given) <= 14 && has_model(given.position, given.bounds, folder);
      case Shows::control:
        return !altered_rows_have_models(given, 1, folder);
      case Shows::models:
        break;
    }
    return colors_of(given) <= 9 && compare_models(given).differences != 0;
  };
  return std::any_of(shipped_positions().begin(), shipped_positions().end(), shows);
}

TEST(SatEncoding, EveryFaultIsNoticed) {
  RESTRIP_NEEDS_CADICAL();
  const WorkFolder folder("");
  const std::set<std::string> by_control = {"chord_never",     "first_edge_never", "count_one_short",
                                            "forget_isolated", "forbid_all_pairs", "empty_ports_only"};
  // Harmless: a closed strip has no port, so its configuration has the key of a valid one.
  const std::set<std::string> by_models = {"any_cycle_before"};
  EXPECT_EQ(std::size(mutant_names), 20U);
  for (std::size_t i = 0; i < std::size(mutant_names); ++i) {
    const std::string name = mutant_names[i].name;
    const Shows by = by_control.contains(name)  ? Shows::control
                     : by_models.contains(name) ? Shows::models
                                                : Shows::satisfiable;
    active_mutant = static_cast<int>(i) + 1;
    EXPECT_TRUE(is_noticed(by, folder)) << name;
  }
  active_mutant = 0;
}

}  // namespace
}  // namespace restrip::verify::sat::test
