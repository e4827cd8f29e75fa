// Claim: if any system call or allocation fails while a file is read or written, the result is an error, every file is
// whole, old or new, the last file of a set does not describe a mixture, nothing else is left, and no descriptor stays
// open. Each call fails in turn, until a run has no failure.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/output.hpp"
#include "common/reading.hpp"
#include "common/system_calls.hpp"
#include "support/failing_new.hpp"
#include "support/refusal_of.hpp"
#include "tools/folders.hpp"

namespace restrip::files {
namespace {

namespace fs = std::filesystem;

int countdown = 0;  // to the call that fails; 0: none does
bool hit = false;
bool hit_closing = false;

/// Whether this call fails; errno is set.
bool fails(int error) {
  if (countdown == 0 || --countdown != 0) return false;
  hit = true;
  errno = error;
  return true;
}

/// Real calls, except the one at which the countdown ends.
SystemCalls with_faults() {
  return {
      .open = [](const char* path, int flags, mode_t mode) { return fails(ENOSPC) ? -1 : ::open(path, flags, mode); },
      .read = [](int file, void* bytes, std::size_t size) { return fails(EIO) ? -1 : ::read(file, bytes, size); },
      .write =
          [](int file, const void* bytes, std::size_t size) {
            // In pieces, so that something is half-written.
            return fails(ENOSPC) ? -1 : ::write(file, bytes, std::min<std::size_t>(size, 3));
          },
      .fchmod = [](int file, mode_t mode) { return fails(EPERM) ? -1 : ::fchmod(file, mode); },
      .fsync = [](int) { return fails(EIO) ? -1 : 0; },  // loss of power is not tested
      .close =
          [](int file) {
            const bool failed = fails(EIO);  // and closed all the same, as Linux does
            hit_closing = hit_closing || failed;
            ::close(file);
            return failed ? -1 : 0;
          },
      .rename = [](const char* from, const char* to) { return fails(EACCES) ? -1 : ::rename(from, to); },
      // A draft that cannot be removed must stay; a file to be replaced must not.
      .unlink =
          [](const char* path) {
            const bool draft = std::string_view(path).find("/.restrip-") != std::string_view::npos;
            return !draft && fails(EACCES) ? -1 : ::unlink(path);
          },
      .mkdir = [](const char* path, mode_t mode) { return fails(ENOSPC) ? -1 : ::mkdir(path, mode); },
  };
}

std::size_t open_descriptors() {
  const fs::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(fs::begin(all), fs::end(all)));
}

class Faults : public tools::ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    usual_ = system_calls();
    system_calls() = with_faults();
  }
  void TearDown() override {
    system_calls() = usual_;
    ScratchFolder::TearDown();
  }

  using Contents = std::map<std::string, std::string>;

  /// Does the work in a folder that `prepare` fills again, each time with another failure. After a failure the folder
  /// looks like one of `refused`; without one it looks like `wanted`. Returns the number of system calls.
  int each_in_turn(const std::function<void()>& prepare, const std::function<void()>& work,
                   const std::vector<Contents>& refused, const Contents& wanted) {
    const auto start_over = [&] {
      fs::remove_all(folder_);
      fs::create_directories(folder_);
      prepare();
    };
    start_over();
    const std::size_t descriptors = open_descriptors();
    std::set<Contents> met;
    const auto check = [&](bool failed) {
      EXPECT_EQ(open_descriptors(), descriptors);
      const Contents found = contents_of(folder_);
      if (failed) met.insert(found);
      EXPECT_TRUE(failed ? std::count(refused.begin(), refused.end(), found) == 1 : found == wanted)
          << testing::PrintToString(found);
    };
    const std::size_t allocations = testing_support::for_each_allocation(work, [&] {
      check(true);
      start_over();
    });
    EXPECT_GT(allocations, 0U);
    for (int n = 1;; ++n) {
      SCOPED_TRACE(fmt::format("system call {}", n));
      start_over();
      hit = hit_closing = false;
      countdown = n;
      const std::string said = refusal_of(work);
      countdown = 0;
      EXPECT_EQ(said.find('\n'), std::string::npos);
      check(!said.empty());
      // Nothing is lost when a file that was only read, or a probe, cannot be closed. Every other failure must be
      // noticed.
      EXPECT_TRUE(!said.empty() || !hit || hit_closing) << "a failure that was not noticed";
      if (hit) continue;
      EXPECT_EQ(met.size(), refused.size());
      return n - 1;
    }
  }

  SystemCalls usual_{};
};

TEST_F(Faults, WritingOneFile) {
  const auto write = [&] { Output(file("a")).write("the new text"); };
  const Contents old{{"a", "the old text"}};
  const Contents wanted{{"a", "the new text"}};
  // Probe: open, close. Draft: open, permissions, four pieces, sync, close, rename.
  EXPECT_EQ(each_in_turn([&] { put("a", "the old text"); }, write, {old}, wanted), 11);
  EXPECT_EQ(each_in_turn([] {}, write, {Contents()}, wanted), 10);
}

TEST_F(Faults, WritingThroughALink) {
  const Contents old{{"a", "-> b"}, {"b", "the old text"}};
  const Contents wanted{{"a", "-> b"}, {"b", "the new text"}};
  const auto prepare = [&] {
    put("b", "the old text");
    fs::create_symlink("b", file("a"));
  };
  EXPECT_EQ(each_in_turn(
                prepare, [&] { Output(file("a")).write("the new text"); }, {old}, wanted),
            11);
}

TEST_F(Faults, WritingASet) {
  const auto prepare = [&] {
    put("a", "old a");
    put("index", "old index");
  };
  const auto work = [&] {
    OutputSet set(folder_, {"a", "more/b", "index"});
    set.write({{"a", "new a"}, {"more/b", "new b"}, {"index", "new index"}});
  };
  const std::vector<Contents> refused{{{"a", "old a"}, {"index", "old index"}},
                                      {{"a", "old a"}},
                                      {{"a", "new a"}},
                                      {{"a", "new a"}, {"more", "no file"}, {"more/b", "new b"}}};
  const Contents wanted{{"a", "new a"}, {"more", "no file"}, {"more/b", "new b"}, {"index", "new index"}};
  EXPECT_GT(each_in_turn(prepare, work, refused, wanted), 25);
}

TEST_F(Faults, Reading) {
  const Contents there{{"a", "text"}};
  const auto read = [&] { EXPECT_EQ(read_whole(file("a")), "text"); };
  EXPECT_EQ(each_in_turn([&] { put("a", "text"); }, read, {there}, there), 4);
}

TEST_F(Faults, InterruptedCallsGoOn) {
  static int turn;
  turn = 0;
  system_calls().write = [](int file, const void* bytes, std::size_t size) -> ssize_t {
    errno = EINTR;
    return ++turn % 2 == 1 ? -1 : ::write(file, bytes, std::min<std::size_t>(size, 1));
  };
  system_calls().read = [](int file, void* bytes, std::size_t size) -> ssize_t {
    errno = EINTR;
    return ++turn % 2 == 1 ? -1 : ::read(file, bytes, std::min<std::size_t>(size, 1));
  };
  Output(file("a")).write("letter by letter");
  EXPECT_EQ(read_whole(file("a")), "letter by letter");
}

}  // namespace
}  // namespace restrip::files
