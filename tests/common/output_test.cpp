// Claims: an output appears whole under the intended name, through links, with the right permissions, and nothing else
// changes; a file that cannot or must not be written is refused before the work, in one line with a remedy.
// tests/tools/program_test.py has inputs and outputs that are one file, pipes, and a full disk.
#include "common/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "common/reading.hpp"
#include "common/system_calls.hpp"
#include "support/refusal_of.hpp"
#include "tools/folders.hpp"

namespace restrip::files {
namespace {

namespace fs = std::filesystem;

class Outputs : public tools::ScratchFolder {
 protected:
  [[nodiscard]] fs::path at(const char* name) const { return folder_ / name; }
  /// The message about this output before anything is written; the folder must not change.
  [[nodiscard]] std::string complaint(const fs::path& file, const OutputRules& rules = {}) const {
    const auto before = contents_of(folder_);
    const std::string said = refusal_of([&] { const Output output(file, rules); });
    EXPECT_EQ(contents_of(folder_), before);
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }
  static mode_t mode_of(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 0777U : 0;
  }
};

#define EXPECT_SAYS(said, wanted) \
  EXPECT_NE(std::string(said).find(wanted), std::string::npos) << "it says: '" << (said) << "'"

TEST_F(Outputs, AreWhatWasWritten) {
  const std::string large(3'000'000, 'x');
  for (const std::string& bytes : {std::string("new"), std::string(), large}) {
    Output(at("a")).write(bytes);
    EXPECT_EQ(contents_of(folder_), (std::map<std::string, std::string>{{"a", bytes}}));
  }
  // Names may have the maximum length of the file system.
  const std::string longest(255, 'n');
  Output(folder_ / longest).write("long");
  EXPECT_EQ(bytes_of(folder_ / longest), "long");
  EXPECT_SAYS(complaint(folder_ / (longest + "n")), "File name too long");
}

TEST_F(Outputs, PermissionsComeFromTheUmaskOrTheReplacedFile) {
  const mode_t before = ::umask(027);
  Output(at("fresh")).write("x");
  ::umask(before);
  EXPECT_EQ(mode_of(at("fresh")), 0640U);
  put("secret", "old");
  fs::permissions(at("secret"), fs::perms::owner_read | fs::perms::owner_write);
  Output(at("secret")).write("new");
  EXPECT_EQ(mode_of(at("secret")), 0600U);
  EXPECT_EQ(bytes_of(at("secret")), "new");
}

TEST_F(Outputs, GoThroughLinks) {
  fs::create_directory(at("store"));
  put("store/file", "old");
  fs::create_symlink("file", at("store/inner"));
  fs::create_symlink("store/inner", at("outer"));
  fs::create_symlink("store/fresh", at("dangling"));
  Output(at("outer")).write("new");
  Output(at("dangling")).write("first");
  EXPECT_EQ(contents_of(folder_), (std::map<std::string, std::string>{{"dangling", "-> store/fresh"},
                                                                      {"outer", "-> store/inner"},
                                                                      {"store", "no file"},
                                                                      {"store/file", "new"},
                                                                      {"store/fresh", "first"},
                                                                      {"store/inner", "-> file"}}));
  fs::create_symlink("loop", at("loop"));
  EXPECT_SAYS(complaint(at("loop")), "loop: cannot be written: its links lead nowhere");
  fs::create_symlink("no/such/folder", at("lost"));
  EXPECT_SAYS(complaint(at("lost")), "does not exist; make it first");
}

TEST_F(Outputs, BystandersStay) {
  // A file with the name of a draft may exist.
  put("precious", "precious");
  for (int i = 0; i < 5; ++i) {
    const fs::path name = folder_ / fmt::format(".restrip-{}-{}", ::getpid(), i);
    if (i % 2 == 0)
      put(name, "mine");
    else
      fs::create_symlink("precious", name);
  }
  for (const char* name : {"a.part", "a.partial", "a.tmp"}) put(name, "mine");
  auto wanted = contents_of(folder_);
  Output(at("a")).write("new");
  wanted["a"] = "new";
  EXPECT_EQ(contents_of(folder_), wanted);
}

TEST_F(Outputs, TwoWritersDoNotMeet) {
  std::vector<std::string> texts;
  std::vector<std::thread> writers;
  for (char c = 'a'; c < 'e'; ++c) texts.emplace_back(100'000, c);
  for (const std::string& text : texts)
    writers.emplace_back([&] {
      for (int i = 0; i < 20; ++i) Output(at("out")).write(text);
    });
  for (std::thread& writer : writers) writer.join();
  const auto contents = contents_of(folder_);
  ASSERT_EQ(contents.size(), 1U);
  EXPECT_NE(std::find(texts.begin(), texts.end(), contents.at("out")), texts.end());
}

TEST_F(Outputs, MustBeOfTheFormat) {
  const OutputRules rules{{".pm", ".svg"}, {}};
  EXPECT_EQ(complaint(at("a.pm"), rules), "");
  EXPECT_EQ(complaint(at("a.SVG"), rules), "");
  EXPECT_SAYS(complaint(at("a.obj"), rules), "a.obj: has the extension '.obj', but what is written is .pm or .svg");
  EXPECT_SAYS(complaint(at("a"), rules), "has the extension ''");
  // Also through links; a store of files without extensions is allowed.
  put("mesh.obj", "precious");
  put("store", "");
  fs::create_symlink("mesh.obj", at("b.pm"));
  fs::create_symlink("store", at("c.pm"));
  EXPECT_SAYS(complaint(at("b.pm"), rules), "leads to");
  EXPECT_EQ(complaint(at("c.pm"), rules), "");
  EXPECT_EQ(complaint("/dev/null", rules), "");
}

TEST_F(Outputs, WhatCannotBeWrittenIsNamedBeforehand) {
  put("file", "x");
  EXPECT_SAYS(complaint(""), "is empty; name a file");
  EXPECT_SAYS(complaint(folder_), "it is a folder; name a file inside it");
  EXPECT_SAYS(complaint(folder_ / ""), "it is a folder; name a file inside it");
  EXPECT_SAYS(complaint(at("none/a")), "does not exist; make it first");
  EXPECT_SAYS(complaint(at("none/")), "cannot be written");
  EXPECT_SAYS(complaint(at("file/a")), "Not a directory; name a file in a folder that you may write to");
  EXPECT_SAYS(complaint("/proc/self/a"), "cannot be written");  // not even by root
  if (::geteuid() == 0) return;                                 // who may write everywhere else
  put("protected", "x");
  fs::permissions(at("protected"), fs::perms::owner_read);
  EXPECT_SAYS(complaint(at("protected")), "Permission denied");
  fs::create_directory(at("locked"));
  fs::permissions(at("locked"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_SAYS(complaint(at("locked/a")), "Permission denied");
  fs::permissions(at("locked"), fs::perms::owner_all);
}

TEST_F(Outputs, ADescriptorThatIsOpenIsUsed) {
  // As /dev/stdout redirected to a file: later writes to the same descriptor come after.
  const int open = ::open(at("out").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_GE(open, 0);
  ASSERT_EQ(::write(open, "one ", 4), 4);
  Output(fmt::format("/dev/fd/{}", open)).write("two ");
  ASSERT_EQ(::write(open, "three", 5), 5);
  ::close(open);
  EXPECT_EQ(bytes_of(at("out")), "one two three");
  const int reading = ::open(at("out").c_str(), O_RDONLY);
  EXPECT_SAYS(complaint(fmt::format("/dev/fd/{}", reading)), "Bad file descriptor");
  ::close(reading);
  EXPECT_SAYS(complaint(fmt::format("/dev/fd/{}", reading)), "Bad file descriptor");
}

TEST_F(Outputs, SignalsWaitUntilTheFileExists) {
  // Interrupted in the middle of writing, a child process first finishes the file.
  put("a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    system_calls().fsync = [](int file) {
      ::raise(SIGINT);
      return ::fsync(file);
    };
    Output(at("a")).write("new");
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
  EXPECT_EQ(contents_of(folder_), (std::map<std::string, std::string>{{"a", "new"}}));
}

// ---- sets

TEST_F(Outputs, ASetIsWrittenWithItsFolders) {
  OutputSet set(at("x/y"), {"a", "z/b", "index"});
  set.write({{"a", "1"}, {"z/b", "2"}, {"index", "3"}});
  EXPECT_EQ(contents_of(at("x/y")),
            (std::map<std::string, std::string>{{"a", "1"}, {"z", "no file"}, {"z/b", "2"}, {"index", "3"}}));
}

TEST_F(Outputs, ASetThatIsNotWrittenLeavesNothing) {
  put("file", "x");
  const auto before = contents_of(folder_);
  { const OutputSet set(at("x/y"), {"a", "z/b", "index"}); }
  EXPECT_EQ(contents_of(folder_), before);
  EXPECT_THROW(OutputSet(at("x/y"), {"a", "../../file/b"}), FileError);
  EXPECT_THROW(OutputSet(at("file"), {"a"}), FileError);
  EXPECT_THROW(OutputSet("", {"a"}), FileError);
  EXPECT_THROW(OutputSet("/dev", {"null"}), FileError);
  EXPECT_THROW(OutputSet(folder_, {"a", "file"}, {{}, {at("file")}}), FileError);
  EXPECT_EQ(contents_of(folder_), before);
}

}  // namespace
}  // namespace restrip::files
