// A separate folder for each test, removed afterwards; and the contents of a folder, to compare before and after.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

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

}  // namespace restrip::tools
