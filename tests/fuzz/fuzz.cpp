#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "target.hpp"

namespace restrip::fuzz {
namespace {

std::optional<Target> chosen;

}  // namespace

const Target& chosen_target() { return chosen.value(); }

}  // namespace restrip::fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace restrip::fuzz;
  const std::string_view by_name = "--target=";
  const std::string_view to_folder = "--write-seeds=";
  std::string wanted;
  std::string folder;
  for (int i = 1; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    if (argument.starts_with(by_name)) wanted = argument.substr(by_name.size());
    if (argument.starts_with(to_folder)) folder = argument.substr(to_folder.size());
  }
  std::string names;
  for (auto* targets : {&mesh_targets, &table_targets, &live_targets})
    for (Target& target : targets()) {
      names += ' ' + target.name;
      if (target.name == wanted) chosen = std::move(target);
    }
  if (!chosen) {
    std::fprintf(stderr, "restrip-fuzz: name a target, --target=NAME:%s\n", names.c_str());
    std::exit(2);
  }
  if (!folder.empty()) {
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < chosen->seeds.size(); ++i)
      std::ofstream(std::filesystem::path(folder) / std::to_string(i), std::ios::binary) << chosen->seeds[i];
    std::exit(0);
  }
  return 0;
}

/// Reads the bytes with the chosen target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A copy of exactly this size, so that sanitizers detect reads beyond it.
  const std::vector<char> bytes(data, data + size);
  restrip::fuzz::chosen_target().read({bytes.data(), bytes.size()});
  return 0;
}
