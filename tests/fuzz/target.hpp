// What a fuzz target is: one reader of the programs, with small files to begin from.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::fuzz {

struct Target {
  std::string name;
  std::vector<std::string> seeds;  ///< accepted, all of them; written by our own programs where they write the format
  /// Reads the bytes as the programs do, and checks what must hold of a result. True when they are accepted, false when
  /// they are refused as the reader promises. Throws or ends the process when the reader breaks its word.
  std::function<bool(std::string_view)> read;
  unsigned runs = 0;  ///< that a test makes; some two seconds with sanitizers
};

/// The readers of meshes, of tables as the verifier reads them, of operations of a user's own as it reads those, and of
/// the generator's shards.
[[nodiscard]] std::vector<Target> mesh_targets();
[[nodiscard]] std::vector<Target> table_targets();
[[nodiscard]] std::vector<Target> operation_targets();
[[nodiscard]] std::vector<Target> shard_targets();

/// A promise of a reader: throws std::logic_error when it is broken.
void promise(bool kept, const char* what);

}  // namespace restrip::fuzz
