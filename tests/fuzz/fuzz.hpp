// The command line shared by libFuzzer and our driver.
#pragma once

#include <cstddef>
#include <cstdint>

#include "target.hpp"

/// Parses --target=NAME and --write-seeds=FOLDER (writes one file for each seed, then exits).
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
/// Reads the bytes with the chosen target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace restrip::fuzz {

/// The target chosen in LLVMFuzzerInitialize.
[[nodiscard]] const Target& chosen_target();

}  // namespace restrip::fuzz
