// Claim: if any system call or allocation fails while a file is read or written, the result is an error, every file is
// whole, old or new, nothing else is left, and no descriptor stays open. Each is made to fail in turn, until a run
// meets no failure.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "common/output.hpp"
#include "common/reading.hpp"
#include "common/system_calls.hpp"
#include "support/failing_new.hpp"
#include "support/refusal_of.hpp"
#include "tools/scratch_folder.hpp"

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

/// The true calls, except for the one where the countdown ends.
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
      .fsync = [](int) { return fails(EIO) ? -1 : 0; },  // what a disk has after a loss of power is not tested
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
  /// looks like `old`, if it matters; without one it looks like `wanted`. Returns the number of system calls.
  int each_in_turn(const std::function<void()>& prepare, const std::function<void()>& work,
                   const std::optional<Contents>& old, const Contents& wanted) {
    const auto start_over = [&] {
      fs::remove_all(folder_);
      fs::create_directories(folder_);
      prepare();
    };
    start_over();
    const std::size_t descriptors = open_descriptors();
    const auto check = [&](bool refused) {
      EXPECT_EQ(open_descriptors(), descriptors);
      const Contents found = contents_of(folder_);
      EXPECT_EQ(found, refused ? old.value_or(found) : wanted) << (refused ? "refused" : "done");
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
      const bool refused = !said.empty();
      EXPECT_EQ(said.find('\n'), std::string::npos);
      check(refused);
      // Nothing is lost when a file that was only read, or a probe, cannot be closed. Every other failure must be
      // noticed.
      EXPECT_TRUE(refused || !hit || hit_closing) << "a failure that was not noticed";
      if (!hit) return n - 1;
    }
  }

  SystemCalls usual_{};
};

TEST_F(Faults, WritingOneFile) {
  const auto write = [&] { Output(file("a")).write("the new text"); };
  const Contents old{{"a", "the old text"}};
  const Contents wanted{{"a", "the new text"}};
  // Probe: open, close. Draft: open, permissions, four pieces, sync, close, rename.
  EXPECT_EQ(each_in_turn([&] { put("a", "the old text"); }, write, old, wanted), 11);
  EXPECT_EQ(each_in_turn([] {}, write, Contents(), wanted), 10);
}

TEST_F(Faults, WritingThroughALink) {
  const Contents old{{"a", "-> b"}, {"b", "the old text"}};
  const Contents wanted{{"a", "-> b"}, {"b", "the new text"}};
  const auto prepare = [&] {
    put("b", "the old text");
    fs::create_symlink("b", file("a"));
  };
  EXPECT_EQ(each_in_turn(
                prepare, [&] { Output(file("a")).write("the new text"); }, old, wanted),
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
  const Contents old{{"a", "old a"}, {"index", "old index"}};
  const Contents wanted{{"a", "new a"}, {"more", "no file"}, {"more/b", "new b"}, {"index", "new index"}};
  // Files that already have their new name go back.
  EXPECT_GT(each_in_turn(prepare, work, old, wanted), 30);
}

// Renames fail from the n-th on, so nothing can be restored either.
TEST_F(Faults, WritingASetWithoutAWayBack) {
  static int renames_left;
  system_calls().rename = [](const char* from, const char* to) {
    errno = EROFS;
    return renames_left-- > 0 ? ::rename(from, to) : -1;
  };
  system_calls().unlink = [](const char* path) {
    errno = EROFS;
    return renames_left > 0 || std::string_view(path).find("/.restrip-") != std::string_view::npos ? ::unlink(path)
                                                                                                   : -1;
  };
  std::size_t refused = 0;
  for (int n = 0;; ++n) {
    SCOPED_TRACE(fmt::format("{} renames", n));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    put("a", "old a");
    put("c", "old c");
    put("index", "old index");
    renames_left = n;
    const std::string message = refusal_of([&] {
      OutputSet set(folder_, {"a", "b", "c", "index"});
      set.write({{"a", "new a"}, {"b", "new b"}, {"c", "new c"}, {"index", "new index"}});
    });
    const Contents found = contents_of(folder_);
    if (message.empty()) {
      EXPECT_EQ(found, (Contents{{"a", "new a"}, {"b", "new b"}, {"c", "new c"}, {"index", "new index"}}));
      break;
    }
    ++refused;
    EXPECT_NE(message.find("cannot be written: Read-only file system"), std::string::npos) << message;
    if (n == 0) {
      EXPECT_EQ(found, (Contents{{"a", "old a"}, {"c", "old c"}, {"index", "old index"}}));
      continue;
    }
    // The last file does not describe a mixture, and old files are not lost: they have their names, or one that the
    // message names.
    EXPECT_FALSE(found.contains("index"));
    for (const std::string bytes : {"old a", "old c", "old index"}) {
      const auto place =
          std::find_if(found.begin(), found.end(), [&](const auto& item) { return item.second == bytes; });
      ASSERT_NE(place, found.end()) << bytes;
      EXPECT_TRUE(place->first == bytes.substr(4) || message.find(place->first) != std::string::npos) << message;
    }
  }
  EXPECT_EQ(refused, 7U);  // three old files go aside, four new ones get their names
}

TEST_F(Faults, Reading) {
  const Contents there{{"a", "text"}};
  const auto read = [&] { EXPECT_EQ(read_whole(file("a")), "text"); };
  EXPECT_EQ(each_in_turn([&] { put("a", "text"); }, read, there, there), 4);
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
