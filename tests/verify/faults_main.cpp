// The tests of the verifier notice every deliberate fault of faults.txt. Each fault is tried in a process of its own,
// up to the first failure.
//
//   verify_faults none           without a fault: the tests pass that try each fault
//   verify_faults NAME           with this fault, and reports which test notices it
//   verify_faults PART/PARTS     with every PARTS-th fault
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <string>

#include "fault_names.hpp"
#include "faults.hpp"

namespace {

using restrip::fault_names;

/// Filters of GoogleTest, the quick ones first. Each automaton test takes a second or more, so faults that they notice
/// name them.
constexpr std::array<const char*, 3> stages{
    "Description.*:Families.*:Forged*:Orbits.*:OperationJudge.*Corpus:OperationJudge.Good*:OperationJudge.Symm*:"
    "Unlisted.*:IndexCost.*",
    "Corpus.*Hold:TableDump.*:OperationJudge.*:OperationHeader.*", "Corpus.Damaged*:ShippedRows.*"};
constexpr std::size_t longest_name = 200;
char* running = nullptr;  ///< the name of the current test, in memory shared by the processes

class Watch : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    std::snprintf(running, longest_name, "%s.%s", test.test_suite_name(), test.name());
  }
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.failed()) _exit(1);
  }
};

enum class Outcome { passed, failed, not_run };

/// Runs the tests of this filter with the fault of this number; 0: without a fault.
Outcome run(int number, const char* filter) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    constexpr rlimit time{120, 121};  // some faults make loops that do not end
    constexpr rlimit space{rlim_t{1} << 30, rlim_t{1} << 30};
    if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_DATA, &space) != 0) _exit(2);
    testing::GTEST_FLAG(filter) = filter;
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    if (number > 0) {
      delete listeners.Release(listeners.default_result_printer());
      listeners.Append(new Watch);
    }
    restrip::active_fault = number;
    const bool passed = RUN_ALL_TESTS() == 0;
    std::fflush(stdout);
    _exit(testing::UnitTest::GetInstance()->test_to_run_count() == 0 ? 2 : passed ? 0 : 1);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || (WIFEXITED(status) && WEXITSTATUS(status) == 2))
    return Outcome::not_run;
  return status == 0 ? Outcome::passed : Outcome::failed;
}

/// Whether the outcome is as it should be.
bool judge(std::size_t number) {
  if (number == 0)
    return std::all_of(stages.begin(), stages.end(),
                       [](const char* stage) { return run(0, stage) == Outcome::passed; });
  const auto& [name, test] = fault_names[number - 1];
  Outcome outcome = *test != '\0' ? run(static_cast<int>(number), test) : Outcome::passed;
  for (const char* stage : stages)
    if (outcome == Outcome::passed) outcome = run(static_cast<int>(number), stage);
  std::printf("%s: ", name);
  if (outcome == Outcome::failed)
    std::printf("noticed by %s\n", running);
  else
    std::printf(outcome == Outcome::passed ? "NOT NOTICED\n" : "NOT RUN\n");
  return outcome == Outcome::failed;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  void* const memory = mmap(nullptr, longest_name, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  running = static_cast<char*>(memory);
  const std::string what = argc == 2 ? argv[1] : "";
  constexpr std::size_t faults = std::size(fault_names);
  if (what == "none") return judge(0) ? 0 : 1;
  for (std::size_t number = 1; number <= faults; ++number)
    if (what == fault_names[number - 1].name) return judge(number) ? 0 : 1;
  unsigned part = 0;
  unsigned parts = 0;
  if (std::sscanf(what.c_str(), "%u/%u", &part, &parts) != 2 || part < 1 || part > parts) {
    std::fprintf(stderr, "usage: %s none, the NAME of a fault in faults.txt, or PART/PARTS\n", argv[0]);
    return 2;
  }
  std::size_t wrong = 0;
  for (std::size_t number = part; number <= faults; number += parts) wrong += judge(number) ? 0U : 1U;
  std::printf("%zu of %zu faults are not noticed\n", wrong, (faults - part) / parts + 1);
  return wrong == 0 ? 0 : 1;
}
