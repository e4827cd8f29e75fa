// The command line that libFuzzer and our own driver share.
#pragma once

#include <cstddef>
#include <cstdint>

#include "target.hpp"

/// Understands --target=NAME and --write-seeds=FOLDER (one file for each seed, then the end of the program).
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
/// Reads the bytes with the chosen target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace restrip::fuzz {

/// The one that LLVMFuzzerInitialize chose.
[[nodiscard]] const Target& chosen_target();

}  // namespace restrip::fuzz
