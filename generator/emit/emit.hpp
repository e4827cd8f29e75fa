// The stage `emit` of the generator's pipeline: the files of all languages, and their names before the work.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "automaton/automaton.hpp"
#include "certify/certificate.hpp"
#include "common/output.hpp"
#include "tables/operation_layout.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {

/// Names of language_files(); C++ has headers, certificates and MANIFEST.
using Languages = std::set<std::string>;
using Names = std::vector<std::filesystem::path>;

/// Files and a report of them. Same input, same bytes.
struct Emitted {
  std::vector<files::NamedBytes> files;
  std::string text;
  std::string json;
};

/// The shipped families. MANIFEST comes last and lists the C++ files, which restrip-verify reads.
[[nodiscard]] Names names_of_tables(const std::vector<Description>& families, const Languages& languages);
[[nodiscard]] Emitted emit_tables(const std::vector<Certificate>& certificates, const Packing& packing, unsigned max_k,
                                  const Languages& languages);

/// Custom operations and families, each with a layout.
[[nodiscard]] Names names_of_operations(const std::vector<Description>& descriptions, const Languages& languages);
[[nodiscard]] Emitted emit_operations(const std::vector<Certificate>& certificates,
                                      const std::vector<OperationLayout>& layouts, const Languages& languages);

/// The automaton.
[[nodiscard]] Names names_of_automaton(const Languages& languages);
[[nodiscard]] Emitted emit_automaton(const Automaton& automaton, const Languages& languages);

}  // namespace restrip::generator
