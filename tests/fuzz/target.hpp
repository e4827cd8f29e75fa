// A fuzz target: one reader of the programs, with small files to start from.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::fuzz {

struct Target {
  std::string name;
  std::vector<std::string> seeds;  ///< all are accepted; written by our programs if these write the format
  /// Reads the bytes as the programs do, and checks the result. True if they are accepted, false if they are refused as
  /// promised. Throws or ends the process if the reader breaks its promise.
  std::function<bool(std::string_view)> read;
  unsigned runs = 0;  ///< default number of runs in a test; about two seconds with sanitizers
};

/// Readers of meshes, of tables (by the verifier), of custom operations (by the verifier), and of the generator's
/// shards.
[[nodiscard]] std::vector<Target> mesh_targets();
[[nodiscard]] std::vector<Target> table_targets();
[[nodiscard]] std::vector<Target> operation_targets();
[[nodiscard]] std::vector<Target> shard_targets();

/// A promise of a reader: throws std::logic_error if it is broken.
void promise(bool kept, const char* what);

}  // namespace restrip::fuzz
