#pragma once
// What holds for fans of every valence: the worst that an operation can cost, over all arcs of any length
// (docs/automaton.md, "Every k").

#include <cstddef>
#include <string>
#include <vector>

namespace restrip::verify {

/// The worst of one kind of operation, with a smallest fan in which it occurs.
struct Fact {
  std::string operations;
  std::string measure;  ///< "strips" or "isolated"
  int worst = 0;
  std::size_t k = 0;    ///< triangles of the fan of the witness
  std::string witness;  ///< its arcs, letter by letter
};

struct Facts {
  std::vector<Fact> facts;
  std::size_t arcs = 0;   ///< kinds of arcs
  std::size_t pairs = 0;  ///< pairs of them that were looked at
};

/// Throws std::logic_error should there be no end of new kinds of arcs.
Facts facts_of_every_fan();

/// The facts as a table for documents.
std::string table_of(const Facts& facts);

}  // namespace restrip::verify
