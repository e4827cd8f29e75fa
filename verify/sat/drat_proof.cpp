#include "sat/drat_proof.hpp"

#include "sat/number_reader.hpp"

namespace restrip::verify::sat {

Proof parse_proof(const std::string& file, const std::string& text, int variables) {
  NumberReader reader(file, text);
  Proof proof;
  while (!reader.at_end()) {
    std::string_view line = reader.next_line();
    const bool deletes = line.starts_with("d ");
    if (deletes) line.remove_prefix(2);
    proof.push_back({deletes, reader.clause(line, variables), reader.line()});
  }
  return proof;
}

}  // namespace restrip::verify::sat
