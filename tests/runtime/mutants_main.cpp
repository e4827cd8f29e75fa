// The tests of the runtime notice every deliberate fault of mutants.txt. This program has the tests in it, compiled
// against a copy of the headers that has the faults; the argument names one, or `none`. It tells the first test that
// fails.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>

#include "mutants.hpp"

namespace {

/// Processor time: a multiple of what the tests take without a fault, but little for a fault that is to run on for
/// ever.
constexpr rlim_t quick_seconds = 15;
constexpr rlim_t slow_seconds = 60;
constexpr rlim_t endless_seconds = 4;
constexpr rlim_t bytes = rlim_t{1} << 30;  // that may be written; one test takes more addresses and touches none

/// Tests that take a fifth of a second or more come last: the others notice nearly all.
constexpr const char* slow_tests =
    "Checks.AgreeOnEveryList*:Checks.AgreeOnRandomLists:Checks.AgreeOnSmall*:Checks.AgreeBetween*:"
    "LinkedRules.AreSoundAndOptimalInLargerFans:LinkedRules.AreTheLocalOnes*:Operations.LongWalks*:"
    "StripBuffer.Follows*:StripKeeper.IsRight*:StripKeeper.StripsDoNotAge:StripKeeper.IndicesAreFewer*:"
    "Tunnel.TakesSwapsAway*:Baked.FlipsGive*";

struct Shared {
  char running[200];  ///< the test that runs
};

class Watch : public ::testing::EmptyTestEventListener {
 public:
  explicit Watch(Shared& shared) : shared_(shared) {}
  void OnTestStart(const ::testing::TestInfo& test) override {
    std::snprintf(shared_.running, sizeof shared_.running, "%s.%s", test.test_suite_name(), test.name());
  }
  void OnTestEnd(const ::testing::TestInfo& test) override {
    if (test.result()->Failed()) _exit(1);
  }

 private:
  Shared& shared_;
};

int number_of(const std::string& name) {
  if (name == "none") return 0;
  for (std::size_t i = 0; i < std::size(restrip::mutant_names); ++i)
    if (name == restrip::mutant_names[i].name) return static_cast<int>(i) + 1;
  return -1;
}

/// Runs the tests that the filter leaves, up to the first that fails, in a process of their own; its status, or -1.
int status_of(int number, const std::string& filter, rlim_t seconds, Shared& shared) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return -1;
  if (child == 0) {
    const rlimit time{seconds, seconds + 1};
    const rlimit space{bytes, bytes};
    if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_DATA, &space) != 0) _exit(2);
    ::testing::GTEST_FLAG(filter) = filter;
    ::testing::TestEventListeners& listeners = ::testing::UnitTest::GetInstance()->listeners();
    if (number > 0) delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new Watch(shared));
    restrip::active_mutant = number;
    const bool passed = RUN_ALL_TESTS() == 0 && ::testing::UnitTest::GetInstance()->successful_test_count() > 0;
    std::fflush(stdout);
    _exit(passed ? 0 : 1);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child ? status : -1;
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const int number = argc == 2 ? number_of(argv[1]) : -1;
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (number < 0 || memory == MAP_FAILED) {
    std::fprintf(stderr, "usage: runtime_mutants NAME, with a name from tests/runtime/mutants.txt, or none\n");
    return 2;
  }
  auto& shared = *static_cast<Shared*>(memory);
  const bool equivalent = number > 0 && restrip::mutant_names[number - 1].equivalent;
  const bool endless = number > 0 && restrip::mutant_names[number - 1].endless;
  int status = status_of(number, "-" + std::string(slow_tests), endless ? endless_seconds : quick_seconds, shared);
  // A fault that changes nothing has passed the quick tests; the slow ones would say no more.
  if (status == 0 && !equivalent) status = status_of(number, slow_tests, slow_seconds, shared);
  if (status == 0) {
    std::printf(equivalent ? "survived, as it may: it changes nothing\n" : "survived\n");
    return number == 0 || equivalent ? 0 : 1;
  }
  if (status < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 2)) return 2;
  const bool timeless = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  std::printf("killed by %s%s%s\n", shared.running,
              timeless              ? ": it did not end"
              : WIFSIGNALED(status) ? ": "
                                    : "",
              WIFSIGNALED(status) && !timeless ? strsignal(WTERMSIG(status)) : "");
  // A test that is merely slow proves nothing.
  return number == 0 || equivalent || (timeless && !endless) ? 1 : 0;
}
