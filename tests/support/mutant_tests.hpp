#pragma once
// A program with tests and a copy of the tested code that contains the deliberate faults of a list
// (tests/runtime/mutate.py). It runs the tests with each fault and reports the first test that fails.

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "mutant_names.hpp"
#include "mutants.hpp"

namespace restrip::testing_support {

struct MutantTests {
  std::vector<std::string> stages;  ///< filters of GoogleTest, run in order, followed by all other tests
  std::string left_out;             ///< of the last stage: tests that run only by name, or never
  /// Processor time of a stage: a multiple of its time without a fault, because a test that is merely slow proves
  /// nothing.
  rlim_t seconds = 60;
};

class MutantRun {
 public:
  explicit MutantRun(MutantTests tests) : tests_(std::move(tests)) {
    std::string others = "-" + tests_.left_out;
    for (const std::string& earlier : tests_.stages) others += ":" + earlier;
    tests_.stages.push_back(others);
  }

  /// Acts on the program's arguments; returns its exit code.
  int run(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    void* const memory = mmap(nullptr, longest_name, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 2;
    running_ = static_cast<char*>(memory);
    const std::string what = argc == 2 ? argv[1] : "";
    constexpr std::size_t faults = std::size(mutant_names);
    if (what == "none") return judge(0) ? 0 : 1;
    for (std::size_t number = 1; number <= faults; ++number)
      if (what == mutant_names[number - 1].name) return judge(number) ? 0 : 1;
    unsigned part = 0;
    unsigned parts = 0;
    if (std::sscanf(what.c_str(), "%u/%u", &part, &parts) != 2 || part < 1 || part > parts) {
      std::fprintf(stderr,
                   "usage: %s NAME, a fault of its list mutants.txt or none; or PART/PARTS, every PARTS-th of them\n",
                   argv[0]);
      return 2;
    }
    std::size_t wrong = 0;
    for (std::size_t number = part; number <= faults; number += parts) wrong += judge(number) ? 0U : 1U;
    std::printf("%zu of %zu have an unexpected outcome\n", wrong, (faults - part) / parts + 1);
    return wrong == 0 ? 0 : 1;
  }

 private:
  static constexpr std::size_t longest_name = 200;
  static constexpr rlim_t seconds_if_endless = 2;
  static constexpr rlim_t bytes =
      rlim_t{1} << 30;  // upper limit of written memory; one test maps more addresses without touching them

  class Watch : public ::testing::EmptyTestEventListener {
   public:
    explicit Watch(char* running) : running_(running) {}
    void OnTestStart(const ::testing::TestInfo& test) override {
      std::snprintf(running_, longest_name, "%s.%s", test.test_suite_name(), test.name());
    }
    void OnTestPartResult(const ::testing::TestPartResult& result) override {
      if (result.failed()) _exit(1);
    }

   private:
    char* running_;
  };

  /// Runs the tests of this filter with the fault of this number (0: none), up to the first failure, in a separate
  /// process. Returns its status, or -1.
  int status_of(std::size_t number, const std::string& filter, rlim_t limit) const {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) return -1;
    if (child == 0) {
      const rlimit time{limit, limit + 1};
      const rlimit space{bytes, bytes};
      if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_DATA, &space) != 0) _exit(2);
      ::testing::GTEST_FLAG(filter) = filter;
      ::testing::TestEventListeners& listeners = ::testing::UnitTest::GetInstance()->listeners();
      if (number > 0) {
        delete listeners.Release(listeners.default_result_printer());
        if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(2);
        listeners.Append(new Watch(running_));
      }
      active_mutant = static_cast<int>(number);
      const bool passed = RUN_ALL_TESTS() == 0;
      std::fflush(stdout);
      if (::testing::UnitTest::GetInstance()->test_to_run_count() == 0) _exit(2);  // the filter matches no test
      _exit(passed ? 0 : 1);
    }
    int status = 0;
    return waitpid(child, &status, 0) == child ? status : -1;
  }

  /// Runs the tests with the fault of this number and reports the outcome. True if the outcome is as expected.
  bool judge(std::size_t number) const {
    const MutantName fault = number > 0 ? mutant_names[number - 1] : MutantName{"none", false, true, ""};
    const rlim_t limit = fault.endless ? seconds_if_endless : tests_.seconds;
    int status = *fault.test != '\0' ? status_of(number, fault.test, limit) : 0;
    for (std::size_t stage = 0; stage < tests_.stages.size() && status == 0; ++stage) {
      // A fault without effect has passed the quick tests; the slow ones add nothing.
      if (stage + 1 == tests_.stages.size() && fault.equivalent && number > 0) break;
      status = status_of(number, tests_.stages[stage], limit);
    }
    std::printf("%s: ", fault.name);
    if (status == 0) {
      std::printf("%s\n", fault.equivalent ? "not noticed, as expected" : "NOT NOTICED");
      return fault.equivalent;
    }
    if (status < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 2)) {
      std::printf("NOT RUN\n");
      return false;
    }
    const bool timeless = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
    const bool as_it_should = !fault.equivalent && (!timeless || fault.endless);
    const char* const ended = timeless ? "it did not end" : WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "";
    std::printf("%s by %s%s%s\n", as_it_should ? "noticed" : "NOTICED, AGAINST THE LIST,", running_,
                *ended != '\0' ? ": " : "", ended);
    return as_it_should;
  }

  MutantTests tests_;
  char* running_ = nullptr;  ///< name of the current test, in memory shared by the processes
};

}  // namespace restrip::testing_support
