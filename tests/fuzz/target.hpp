// A fuzz target: one reader of the programs, or a LiveMesh, with small files to start from.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "../support/promise.hpp"
#include "common/reading.hpp"

/// Parses --target=NAME and --write-seeds=FOLDER (writes one file for each seed, then exits): the command line shared
/// by libFuzzer and our driver.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);

namespace restrip::fuzz {

struct Target {
  std::string name;
  std::vector<std::string> seeds;  ///< all are accepted; written by our programs if these write the format
  /// Reads the bytes as the programs do, and checks the result. True if they are accepted, false if they are refused as
  /// promised. Throws or ends the process if the reader breaks its promise.
  std::function<bool(std::string_view)> read;
  unsigned runs = 0;  ///< default number of runs in a test; with sanitizers seconds, of `live` a minute
};

/// Readers of meshes, of tables and custom operations (by the verifier); a LiveMesh, driven and loaded.
[[nodiscard]] std::vector<Target> mesh_targets();
[[nodiscard]] std::vector<Target> table_targets();
[[nodiscard]] std::vector<Target> live_targets();

using testing_support::promise;

/// False if the reader throws this exception.
template <class Error = files::FileError, class Read>
std::function<bool(std::string_view)> refusing(Read&& read) {
  return [read](std::string_view bytes) {
    try {
      return read(bytes);
    } catch (const Error&) {
      return false;
    }
  };
}

/// The target chosen in LLVMFuzzerInitialize.
[[nodiscard]] const Target& chosen_target();

}  // namespace restrip::fuzz
