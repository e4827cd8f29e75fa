// Writes the files of restrip-generate: headers, certificates and MANIFEST; an automaton.
#pragma once

#include <set>
#include <string>

#include "operations/tie_break.hpp"

namespace restrip::generator {

struct TablesOptions {
  std::string out;  ///< the output folder
  unsigned max_k = 8;
  unsigned threads = 1;
  std::set<std::string> languages{"c++"};  ///< of language_files()
  std::string json;                        ///< file for a list of what was written; "-": standard output; or empty
};

// The generator's pipeline, which make_tables() follows: describe (families(), read_descriptions()) -> patches
// (patches_of()) -> solve (solve_all()) -> certify (section_texts()) -> pack (pack()) -> emit (headers, files of other
// languages, MANIFEST).
//
// All functions check their output paths before they work, report on standard output what they wrote, show progress on
// a terminal, and throw std::exception with file and remedy.

/// Writes the files of the languages, all at once; for C++ headers, certificates and MANIFEST.
void make_tables(const TablesOptions& options);

/// Writes the automaton's header and certificate, or its files in other languages.
struct AutomatonOptions {
  std::string out;                         ///< the output folder
  std::string json;                        ///< file for its figures; "-": standard output; or empty
  std::string classes;                     ///< JSON file for its classes, or empty
  std::set<std::string> languages{"c++"};  ///< C++: header and certificate; others: names of language_files()
};
void make_automaton_files(const AutomatonOptions& options);

}  // namespace restrip::generator
