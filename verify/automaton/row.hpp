#pragma once
// Rows of triangles with ports that may be given up: where they lie among the ports of an operation, and what a
// certificate answers (docs/automaton.md, "Families of your own").

#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "judge/report.hpp"
#include "model/description.hpp"

namespace restrip::verify {

/// The side after an operation as a row.
struct TriangleRow {
  std::vector<unsigned> ports;  ///< in the order of the row, which is their cyclic order
  std::vector<unsigned> edges;  ///< inner edge i joins triangles i and i + 1 of the row
  bool front = false;           ///< the first triangle has the first two ports
  bool back = false;            ///< the last triangle has the last two ports
};

/// An operation of a family at one position.
struct RowOperation {
  Operation operation;
  TriangleRow row;
};

/// All positions of a family with a first number of at most `max_k`. InputError when the family is not one that the
/// automaton of rows answers.
std::vector<RowOperation> row_operations_of(const Description& family, unsigned max_k);

/// A recolouring: bit i of `links` joins triangles i and i + 1 of the row.
struct RowAnswer {
  Mask links = 0;
  Mask kept = 0;
};

/// The inner edges that links are.
Mask inner_of(const TriangleRow& row, Mask links);

/// Bit i of `joined`: port i is joined to the solid port before it, cyclically; where there are two, either bit does.
RowAnswer row_answer(const AutomatonCertificate& certificate, const TriangleRow& row, Mask ports, Mask joined);

/// Answers compared, and those that were wrong.
struct RowCheck {
  std::uint64_t keys = 0;
  Failures failures;
};

/// Every configuration of a position: the answer is sound in every world, and no recolouring is better.
RowCheck check_row(const AutomatonCertificate& certificate, const RowOperation& at);

}  // namespace restrip::verify
