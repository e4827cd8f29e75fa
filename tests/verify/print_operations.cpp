// Prints the dump of one compiled operation, named by the argument: the shipped ones, and some of the corpus, which the
// build generates.

#include <cstring>

#include "restrip/tables/operation_dump.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#include "restrip/tables/operations/bisect_costs.hpp"
#include "restrip/tables/operations/bisect_matching.hpp"
#include "restrip/tables/operations/flip_forest.hpp"
#include "restrip/tables/operations/flip_matching.hpp"
#include "restrip/tables/operations/hub_goes.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/merge_boundary.hpp"
#include "restrip/tables/operations/merge_face_matching.hpp"
#include "restrip/tables/operations/merge_matching.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "restrip/tables/operations/split_face.hpp"
#include "restrip/tables/operations/spoke_flips.hpp"

// A family answers at its positions and nowhere else.
static_assert(restrip::tables::rule_of(restrip::tables::hub_goes, {3}, 0, 0b111).ports != 0b111);
static_assert(restrip::tables::rule_of(restrip::tables::hub_goes, {6}, 0b011111, 0).strips == 0);
static_assert(!restrip::tables::rule_of(restrip::tables::hub_goes, {6}, 0b111111, 0).valid);
static_assert(restrip::tables::rule_of(restrip::tables::spoke_flips, {6, 4}, 0, 0).valid);
static_assert(!restrip::tables::rule_of(restrip::tables::spoke_flips, {6, 5}, 0, 0).valid);
static_assert(!restrip::tables::rule_of(restrip::tables::spoke_flips, {7, 0}, 0, 0).valid);

int main(int argc, char** argv) {
  namespace tables = restrip::tables;
  const auto is = [&](const char* name) { return argc == 2 && std::strcmp(argv[1], name) == 0; };
  if (is("bisect")) return tables::print_dump("bisect", tables::bisect);
  if (is("bisect-boundary")) return tables::print_dump("bisect-boundary", tables::bisect_boundary);
  if (is("bisect-costs")) return tables::print_dump("bisect-costs", tables::bisect_costs);
  if (is("bisect-matching")) return tables::print_dump("bisect-matching", tables::bisect_matching);
  if (is("flip-forest")) return tables::print_dump("flip-forest", tables::flip_forest);
  if (is("flip-matching")) return tables::print_dump("flip-matching", tables::flip_matching);
  if (is("hub-goes")) return tables::print_dump("hub-goes", tables::hub_goes);
  if (is("join-faces")) return tables::print_dump("join-faces", tables::join_faces);
  if (is("merge")) return tables::print_dump("merge", tables::merge);
  if (is("merge-boundary")) return tables::print_dump("merge-boundary", tables::merge_boundary);
  if (is("merge-face-matching")) return tables::print_dump("merge-face-matching", tables::merge_face_matching);
  if (is("merge-matching")) return tables::print_dump("merge-matching", tables::merge_matching);
  if (is("refine-face")) return tables::print_dump("refine-face", tables::refine_face);
  if (is("split-face")) return tables::print_dump("split-face", tables::split_face);
  if (is("spoke-flips")) return tables::print_dump("spoke-flips", tables::spoke_flips);
  std::fprintf(stderr,
               "usage: print_operations NAME, of an operation of tables/operations or tests/corpus/operations\n");
  return 2;
}
