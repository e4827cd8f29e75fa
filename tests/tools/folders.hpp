// A separate folder for each test, removed afterwards; the contents of a folder, to compare before and after; and real
// meshes, from the folder that RESTRIP_MESHES names.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>

/// In a test: `const auto file = REAL_MESH("bunny.obj");`. Skips the test, visibly, if the mesh is missing. Large ones
/// are used with RESTRIP_LONG_TESTS only: the others show the same in a tenth of the time.
#define REAL_MESH(name)                                                                                     \
  restrip::tools::real_mesh(name);                                                                          \
  if (restrip::tools::real_mesh(name).empty())                                                              \
  GTEST_SKIP() << (name)                                                                                    \
               << " is missing or large: set RESTRIP_MESHES to the folder that holds the real meshes, and " \
                  "configure with RESTRIP_LONG_TESTS"

namespace restrip {

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Every file below the folder, hidden ones as well, with its bytes; links with where they lead.
inline std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    contents[name] = entry.is_symlink()        ? "-> " + std::filesystem::read_symlink(entry).string()
                     : entry.is_regular_file() ? bytes_of(entry)
                                               : "no file";
  }
  return contents;
}

}  // namespace restrip

namespace restrip::tools {

class ScratchFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
  /// Writes a file of this name.
  void put(const std::filesystem::path& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  std::filesystem::path folder_ = [] {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::path(testing::TempDir()) /
           fmt::format("restrip_{}_{}", test->test_suite_name(), test->name());
  }();
};

inline std::filesystem::path real_mesh(const char* name) {
  const char* folder = std::getenv("RESTRIP_MESHES");
  if (folder == nullptr) return {};
  const std::filesystem::path file = std::filesystem::path(folder) / name;
#ifdef RESTRIP_LONG_TESTS
  constexpr std::uintmax_t largest = std::numeric_limits<std::uintmax_t>::max();
#else
  constexpr std::uintmax_t largest = 1'500'000;
#endif
  const bool is_used = std::filesystem::is_directory(file) ||
                       (std::filesystem::exists(file) && std::filesystem::file_size(file) <= largest);
  return is_used ? file : std::filesystem::path();
}

}  // namespace restrip::tools
