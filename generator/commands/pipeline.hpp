// The generator's pipeline, one function for each stage:
//
//   describe   families(), read_descriptions()        descriptions of operations
//   solve      patches_of(), solve_all()              a section for each position: the best recolouring of every key
//   certify    certify()                              certificates: claims, rows, and a reason for each rule
//   tables     pack(), or operation_layouts()         the rules as arrays
//   emit       emit_tables(), or emit_operations()    the files of all languages
//
// The shipped families share one packing and a MANIFEST; each custom operation has a table of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "describe/description.hpp"
#include "emit/emit.hpp"
#include "solve/section.hpp"

namespace restrip::generator {

struct Order {
  std::vector<Description> descriptions;
  bool shipped = true;  ///< the families of the shipped tables, or custom operations
  unsigned max_k = 8;   ///< the largest first number of a position
  unsigned threads = 1;
  std::set<std::string> languages{"c++"};  ///< of language_files(); C++ has headers, certificates and MANIFEST
};

/// For custom operations in these files. Without `max_k` families have positions up to default_max_k.
/// Throws std::runtime_error if two have the same name, or if `max_k` has no effect.
[[nodiscard]] Order order_of(const std::vector<std::string>& files, std::optional<unsigned> max_k);

/// The names of all files.
[[nodiscard]] std::vector<std::filesystem::path> names_of(const Order& order);

/// The files and a report, from patches_of(). The bytes do not depend on the number of threads.
[[nodiscard]] Emitted make(const Order& order, const std::vector<Patches>& patches);

}  // namespace restrip::generator
