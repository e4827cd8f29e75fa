// The tests of the verifier notice every deliberate fault of mutants.txt. This program has the tests in it, and a copy
// of the verifier that has the faults. For each fault it tells the first test that fails.

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>

#include "mutant_names.hpp"
#include "mutants.hpp"

namespace {

/// The tests in the order in which they are run, the quick ones first; the last stage is all the others, but for those
/// of the files that the verifier writes.
constexpr const char* stages[] = {
    "Description.*:Families.*:Forged*:Orbits.*:OperationJudge.*Corpus:OperationJudge.Good*:OperationJudge.Symm*",
    "Corpus.*Hold:TableDump.*:OperationJudge.*",
    "Automaton*:OperationHeader.*",
    "Corpus.Damaged*:Lists.Good*",
};
constexpr std::size_t last_stage = std::size(stages);
constexpr rlim_t seconds = 120;  // of processor time, a multiple of what a stage takes

struct Shared {
  char failed[200];  ///< the first test that failed
};

class Watch : public ::testing::EmptyTestEventListener {
 public:
  explicit Watch(Shared& shared) : shared_(shared) {}
  void OnTestStart(const ::testing::TestInfo& test) override {
    std::snprintf(shared_.failed, sizeof shared_.failed, "%s.%s", test.test_suite_name(), test.name());
  }
  void OnTestPartResult(const ::testing::TestPartResult& result) override {
    if (result.failed()) _exit(1);
  }

 private:
  Shared& shared_;
};

std::string filter_of(std::size_t stage) {
  if (stage < last_stage) return stages[stage];
  std::string others = "-Lists.EveryFlipped*:Faults.*";
  for (const char* const earlier : stages) others += std::string(":") + earlier;
  return others;
}

/// Runs the tests of this filter with the fault of this number (0: none), up to the first that fails, in a process of
/// their own; its status, or -1.
int status_of(std::size_t number, const std::string& filter, Shared& shared) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return -1;
  if (child == 0) {
    const rlimit time{seconds, seconds + 1};
    if (setrlimit(RLIMIT_CPU, &time) != 0) _exit(2);
    ::testing::GTEST_FLAG(filter) = filter;
    ::testing::TestEventListeners& listeners = ::testing::UnitTest::GetInstance()->listeners();
    if (number > 0) {
      delete listeners.Release(listeners.default_result_printer());
      if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(2);
      listeners.Append(new Watch(shared));
    }
    restrip::active_mutant = static_cast<int>(number);
    const bool passed = RUN_ALL_TESTS() == 0;
    std::fflush(stdout);
    if (::testing::UnitTest::GetInstance()->test_to_run_count() == 0) _exit(2);  // the filter names no test
    _exit(passed ? 0 : 1);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child ? status : -1;
}

/// Runs the tests with the fault of this number and tells what came of it. True if that is as it should be.
bool judge(std::size_t number, Shared& shared) {
  const bool none = number == 0;
  const restrip::MutantName fault =
      none ? restrip::MutantName{"none", false, true, ""} : restrip::mutant_names[number - 1];
  int status = *fault.test != '\0' ? status_of(number, fault.test, shared) : 0;
  for (std::size_t stage = 0; stage <= last_stage && status == 0; ++stage)
    status = status_of(number, filter_of(stage), shared);
  if (status == 0) {
    std::printf("%s: %s\n", fault.name, fault.equivalent ? "not noticed, and that is right" : "NOT NOTICED");
    return fault.equivalent;
  }
  const bool ran = status > 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == 2);
  const bool too_slow = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;  // proves nothing
  std::printf("%s: %s by %s%s%s\n", fault.name, ran && !too_slow && !none ? "noticed" : "NOT JUDGED", shared.failed,
              WIFSIGNALED(status) ? ": " : "", WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "");
  return ran && !too_slow && !fault.equivalent;
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  void* const memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  auto& shared = *static_cast<Shared*>(memory);
  const std::string what = argc == 2 ? argv[1] : "";
  constexpr std::size_t faults = std::size(restrip::mutant_names);
  if (what == "none") return judge(0, shared) ? 0 : 1;
  for (std::size_t number = 1; number <= faults; ++number)
    if (what == restrip::mutant_names[number - 1].name) return judge(number, shared) ? 0 : 1;
  unsigned part = 0;
  unsigned parts = 0;
  if (std::sscanf(what.c_str(), "%u/%u", &part, &parts) != 2 || part < 1 || part > parts) {
    std::fprintf(stderr,
                 "usage: verify_mutants NAME, a fault of tests/verify/mutants.txt or none; or PART/PARTS, every "
                 "PARTS-th of them\n");
    return 2;
  }
  bool as_it_should = true;
  for (std::size_t number = part; number <= faults; number += parts)
    as_it_should = judge(number, shared) && as_it_should;
  return as_it_should ? 0 : 1;
}
