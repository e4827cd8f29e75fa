// The tables of operation files and of a family, and what is printed of them.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include "judge.hpp"
#include "restrip/tables/operation_dump.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_matching.hpp"

namespace {

using namespace restrip;
using judge::Digest;

void tell(Digest& told, const tables::OperationRule& rule) {
  told.add(rule.colors, rule.ports, rule.strips, rule.valid);
}

template <class Triangles>
void surface(Digest& told, const Triangles& triangles) {
  for (const tables::PatchTriangle& one : triangles)
    for (const std::uint8_t side : one.side) told.add(tables::edge_of(side));
  for (std::uint32_t edges = 0; edges < 32; ++edges)
    told.add(tables::isolated_among(triangles, tables::patch_edges(edges & 7, edges >> 3)));
}

using Family = tables::SurfaceFamily<std::uint16_t, 67, 2, 4, 8>;

/// Two positions of a family: bisect twice, the second one behind some entries that are never read.
Family family_of_two() {
  Family family{};
  family.position = "k {0} a {1}, {2}{3 {x} {!} {3} {1";
  for (std::size_t place = 0; place < 2; ++place) {
    const std::size_t first = 35 * place;
    std::copy(tables::bisect.entries.begin(), tables::bisect.entries.end(), family.entries.begin() + first);
    family.positions[place] = {
        {static_cast<unsigned>(3 + place), 1, 0}, tables::bisect.before, tables::bisect.after, 4, first};
    family.position_triangles[place] = {5, 2 * place, 4 * place};
    std::copy(tables::bisect.triangles_before.begin(), tables::bisect.triangles_before.end(),
              family.triangles_before.begin() + 2 * place);
    std::copy(tables::bisect.triangles_after.begin(), tables::bisect.triangles_after.end(),
              family.triangles_after.begin() + 4 * place);
  }
  return family;
}

void single() {
  Digest told("operations");
  for (std::uint32_t inner = 0; inner < 2; ++inner)
    for (std::uint32_t ports = 0; ports < 16; ++ports) {
      tell(told, tables::rule_of(tables::bisect, inner, ports));
      tell(told, tables::rule_of(tables::bisect_matching, inner, ports));
    }
  surface(told, tables::bisect.triangles_before);
  surface(told, tables::bisect.triangles_after);
  told.add(tables::most_patch_triangles, tables::patch_edges(~std::uint32_t{0}, 1),
           tables::patch_edges(1, ~std::uint32_t{0}));
  for (std::uint8_t i = 0; i < 32; ++i)
    told.add(tables::edge_of(i), tables::edge_of(static_cast<std::uint8_t>(tables::PatchTriangle::port_side + i)));
  told.add(tables::edge_of(tables::PatchTriangle::boundary_side));
}

void of_family(Family family, bool matching) {
  Digest told("family", matching ? 1 : 0);
  family.matching = matching;
  for (const tables::FamilyNumbers& at :
       {tables::FamilyNumbers{3, 1, 0}, {4, 1, 0}, {4, 2, 0}, {2, 1, 0}, {3, 1, 1}, {9, 0, 0}}) {
    told.add(tables::place_of(family, at));
    const auto table = tables::position_of(family, at);
    told.add(table.vertices, table.ports, table.matching, table.before.triangles, table.after.edges);
    for (std::uint32_t inner = 0; inner < 2; ++inner)
      for (std::uint32_t ports = 0; ports < 16; ++ports) {
        tell(told, tables::rule_of(family, at, inner, ports));
        tell(told, tables::rule_of(table, inner, ports));
      }
    surface(told, table.triangles_before);
    surface(told, table.triangles_after);
  }
}

/// What members hold of which nothing is said.
void defaults() {
  Digest told("defaults");
  tell(told, {});
  const tables::FamilyPosition place;
  const tables::PositionTriangles triangles;
  const tables::PatchTriangle triangle;
  const tables::OperationTable<std::uint8_t, 1> table{};
  const tables::SurfaceOperation<std::uint8_t, 1, 1, 1> operation{};
  const tables::SurfaceFamily<std::uint8_t, 1, 1, 1, 1> family{};
  const tables::PositionTable<std::uint8_t> view;
  told.add(sizeof(tables::PatchTriangle), sizeof(tables::FamilyNumbers));
  told.add(place.before.triangles, place.before.edges, place.ports, place.first, place.numbers[0]);
  told.add(triangles.vertices, triangles.first_before, triangles.first_after, triangle.from, triangle.from_side);
  told.add(table.ports, table.matching, operation.vertices, family.matching, *family.position);
  told.add(view.ports, view.matching, view.vertices, view.entries == nullptr);
}

/// What dumps have told, what one tells that cannot be written, and one after an error.
void not_written(int ended) {
  std::fflush(stdout);
  const int told = dup(1);
  const int full = open("/dev/full", O_WRONLY);
  dup2(full, 1);
  const int first = tables::print_dump("bisect", tables::bisect);
  dup2(told, 1);
  const int second = tables::print_dump("bisect", tables::bisect);
  std::clearerr(stdout);
  Digest answers("written");
  answers.add(ended, first, second);
}

/// Of families, and what is dumped, behind all digests but the last.
void families_and_dumps() {
  const Family family = family_of_two();
  of_family(family, false);
  of_family(family, true);
  int ended = tables::print_dump("bisect", tables::bisect);
  ended += tables::print_dump("bisect_matching", tables::bisect_matching);
  ended += tables::print_dump("family", family);
  Family matching = family_of_two();
  matching.matching = true;
  ended += tables::print_dump("matching", matching);
  ended += tables::print_dump("entries", static_cast<const tables::OperationTable<std::uint16_t, 32>&>(tables::bisect));
  ended += tables::print_dump("positions", static_cast<const tables::OperationFamily<std::uint16_t, 67, 2>&>(family));
  not_written(ended);
}

}  // namespace

int main(int argc, char** argv) { return judge::run(argc, argv, {defaults, single, families_and_dumps}); }
