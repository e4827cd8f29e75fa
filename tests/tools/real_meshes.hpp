// Real meshes for the tests, from the folder that RESTRIP_MESHES names.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

/// In a test: `const auto file = REAL_MESH("bunny.obj");`. Skips the test, visibly, if the mesh is missing.
#define REAL_MESH(name)                        \
  restrip::tools::real_mesh(name);             \
  if (restrip::tools::real_mesh(name).empty()) \
  GTEST_SKIP() << (name) << " is missing: set RESTRIP_MESHES to the folder that holds the real meshes"

namespace restrip::tools {

inline std::filesystem::path real_mesh(const char* name) {
  const char* folder = std::getenv("RESTRIP_MESHES");
  if (folder == nullptr) return {};
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

}  // namespace restrip::tools
