// Prints the compiled automaton of rows and what the look-ups of three families answer; the first argument names one.
#include "restrip/tables/row_dump.hpp"

#include <cstring>

#include "restrip/automaton/ear_goes.hpp"
#include "restrip/automaton/fan_turns.hpp"
#include "restrip/automaton/remove_vertex.hpp"

int main(int argc, char** argv) {
  using restrip::Word;
  if (argc != 2) return 2;
  restrip::tables::RowDump dump(restrip::tables::row_automaton);
  for (unsigned k = 2; k <= 8; ++k) {
    if (std::strcmp(argv[1], "ear-goes") == 0)
      dump.answers("ear-goes", {k}, k, [k](Word p, Word j) { return restrip::exact::best_ear_goes(k, p, j); });
    if (k == 2) continue;
    if (std::strcmp(argv[1], "fan-turns") == 0)
      dump.answers("fan-turns", {k}, k, [k](Word p, Word j) { return restrip::exact::best_fan_turns(k, p, j); });
    if (std::strcmp(argv[1], "remove-vertex") == 0)
      dump.answers("remove-vertex", {k}, k,
                   [k](Word p, Word j) { return restrip::exact::best_remove_vertex(k, p, j); });
  }
  return dump.end();
}
