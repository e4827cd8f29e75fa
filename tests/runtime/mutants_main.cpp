// The tests of the runtime notice every deliberate fault of mutants.txt. This program has the tests in it, compiled
// against a copy of the headers that has the faults. For each fault it tells the first test that fails.
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

/// The tests in the order in which they are run; the last stage is all the others. First what takes a few milliseconds
/// and needs little of the library; then what searches, because a fault below a search may let it run for ever; last
/// what takes a tenth of a second or more.
constexpr const char* stages[] = {
    "Operations.AnyValence:Join.*:Adopt.That*:Operations.AFree*:"
    "Refine.Inverses*:Refine.Refuses*:Refine.Refining*:Operations.Going*:Operations.Invalid*:Operations.Refused*:"
    "Operations.SmallMeshes*:StripMesh.*:Checks.Bound*:Apply.Takes*:Apply.Refuses*:Apply.In*:KeptApply.KeepsPairs*:"
    "Checked.*:Checks.Handles*:LinkedOperations.*:StripBuffer.AnUpdate*:Strips.*:"
    "ChunkLists.*:StripTrees.*:MarkedWords.*:*StripLocatorOf.AgreesAfterCuts*",
    "*StripLocatorOf.AgreesAfterRewrites*:*StripLocatorOf.AgreesWhere*:Adopt.Leaves*:Operations.LargeFans*:"
    "LinkedRules.*ForAll*:Baked.OutOfOrder*:Baked.RoundTrips*",
    "StripBuffer.WritesLittle*:StripBuffer.Nothing*:StripifyF*:Tunnel.Each*:Tunnel.Looks*:Keeper.Changes*:"
    "Refine.Keepers*:InvalidColorings.*:Moves.*:Descent.*:EndMoves.*:EndSearch.*:KeeperByCost.Tells*:"
    "Window.IsTheLeast*",
};
constexpr std::size_t last_stage = std::size(stages);

/// Processor time of a stage: a multiple of what it takes without a fault, but little for a fault that is to run on
/// for ever.
constexpr rlim_t seconds = 60;
constexpr rlim_t seconds_if_endless = 2;
constexpr rlim_t bytes = rlim_t{1} << 30;  // that may be written; one test takes more addresses and touches none

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

/// The tests of a stage, in the form that GoogleTest's filters have.
std::string filter_of(std::size_t stage) {
  if (stage < last_stage) return stages[stage];
  std::string others = "-";
  for (const char* const earlier : stages) others += std::string(earlier) + ":";
  return others;
}

/// Runs the tests of this filter with the fault of this number (0: none), up to the first that fails, in a process of
/// their own; its status, or -1.
int status_of(std::size_t number, const std::string& filter, rlim_t limit, Shared& shared) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return -1;
  if (child == 0) {
    const rlimit time{limit, limit + 1};
    const rlimit space{bytes, bytes};
    if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_DATA, &space) != 0) _exit(2);
    ::testing::GTEST_FLAG(filter) = filter;
    ::testing::TestEventListeners& listeners = ::testing::UnitTest::GetInstance()->listeners();
    if (number > 0) delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new Watch(shared));
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
  const restrip::MutantName fault =
      number > 0 ? restrip::mutant_names[number - 1] : restrip::MutantName{"none", false, true, ""};
  const rlim_t limit = fault.endless ? seconds_if_endless : seconds;
  int status = *fault.test != '\0' ? status_of(number, fault.test, limit, shared) : 0;
  for (std::size_t stage = 0; stage <= last_stage && status == 0; ++stage) {
    // A fault that changes nothing has passed the quick tests; the slow ones would say no more.
    if (stage == last_stage && fault.equivalent && number > 0) break;
    status = status_of(number, filter_of(stage), limit, shared);
  }
  std::printf("%s: ", fault.name);
  if (status == 0) {
    std::printf("%s\n", fault.equivalent ? "not noticed, and that is right" : "NOT NOTICED");
    return fault.equivalent;
  }
  if (status < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 2)) {
    std::printf("NOT RUN\n");
    return false;
  }
  // A test that is merely slow proves nothing.
  const bool timeless = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  const bool as_it_should = !fault.equivalent && (!timeless || fault.endless);
  std::printf("%s by %s%s%s\n", as_it_should ? "noticed" : "NOTICED, AGAINST THE LIST,", shared.running,
              WIFSIGNALED(status) ? ": " : "",
              timeless              ? "it did not end"
              : WIFSIGNALED(status) ? strsignal(WTERMSIG(status))
                                    : "");
  return as_it_should;
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
  if (std::sscanf(argc == 2 ? argv[1] : "", "%u/%u", &part, &parts) != 2 || part < 1 || part > parts) {
    std::fprintf(stderr,
                 "usage: runtime_mutants NAME, a fault of tests/runtime/mutants.txt or none; or PART/PARTS, every "
                 "PARTS-th of them\n");
    return 2;
  }
  std::size_t wrong = 0;
  for (std::size_t number = part; number <= faults; number += parts) wrong += judge(number, shared) ? 0U : 1U;
  std::printf("%zu of %zu are not as they should be\n", wrong, (faults - part) / parts + 1);
  return wrong == 0 ? 0 : 1;
}
