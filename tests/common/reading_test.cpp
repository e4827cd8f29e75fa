// Claims: a file of any kind is read unchanged; a file that is too large or endless is refused with the limit named,
// after reading no more than the limit; and a file that cannot be read is named with a remedy.
#include "common/reading.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <thread>

#include "support/refusal_of.hpp"
#include "tools/folders.hpp"

namespace restrip::files {
namespace {

using Reading = tools::ScratchFolder;

std::string complaint(const std::filesystem::path& file, const ReadLimits& limits = {}) {
  return refusal_of([&] { (void)read_whole(file, limits); });
}

TEST_F(Reading, EveryByteArrives) {
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{1} << 20, (std::size_t{1} << 20) + 1}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * i >> 3);
    put("a", bytes);
    EXPECT_EQ(read_whole(file("a")), bytes) << size;
  }
  EXPECT_EQ(read_whole("/dev/null"), "");
  // A regular file that announces no size.
  EXPECT_TRUE(read_whole("/proc/self/status").starts_with("Name:"));
}

TEST_F(Reading, APipeIsReadToItsEnd) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  const std::string bytes(2'500'000, 'x');
  std::thread writer([&] { put("pipe", bytes); });
  EXPECT_EQ(read_whole(file("pipe")), bytes);
  writer.join();
}

TEST_F(Reading, WhatNeverEndsIsRefusedWithItsLimit) {
  EXPECT_NE(complaint("/dev/zero", {1 << 20, 5 << 20}).find("is larger than 5 MiB, the limit for a pipe or device"),
            std::string::npos);
  put("a", std::string(1001, 'x'));
  EXPECT_NE(complaint(file("a"), {1000, 1}).find("a: is larger than 1000 bytes, the limit for a file; cut it"),
            std::string::npos);
  EXPECT_EQ(complaint(file("a"), {1001, 1}), "");
  // Known by its size alone: nothing of it is read.
  std::filesystem::resize_file(file("a"), std::uintmax_t{1} << 40);
  EXPECT_NE(complaint(file("a")).find("is larger than 16 GiB"), std::string::npos);
}

TEST_F(Reading, WhatCannotBeReadIsNamed) {
  EXPECT_NE(complaint(file("none")).find("none: no such file; check the path"), std::string::npos);
  EXPECT_NE(complaint(folder_).find("is a directory; name a file inside it"), std::string::npos);
  put("a", "x");
  EXPECT_NE(complaint(folder_ / "a" / "b").find("cannot be opened: Not a directory"), std::string::npos);
}

TEST(Extensions, AreOfLowerCase) {
  EXPECT_EQ(extension_of("a/B.OBJ"), ".obj");
  EXPECT_EQ(extension_of("a.b/c"), "");
}

}  // namespace
}  // namespace restrip::files
