// Gives the verifier of operations one deliberate fault, named by the argument, and tells the first test that notices
// it. With the fault `none` every test must pass.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "named_mutant.hpp"
#include "operation_mutants.hpp"

namespace {

using restrip::verify::operations::OperationMutant;

/// Instead of the reports of GoogleTest: the name of the first test that fails, and how many passed.
class Notice : public testing::EmptyTestEventListener {
 public:
  std::string killer;
  int passed = 0;

 private:
  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Passed())
      ++passed;
    else if (killer.empty())
      killer = fmt::format("{}.{}", test.test_suite_name(), test.name());
  }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const std::optional<OperationMutant> mutant =
      argc == 2 ? restrip::verify::test::mutant_named<OperationMutant>(argv[1]) : std::nullopt;
  if (!mutant) {
    fmt::print(stderr, "usage: verify_operations_mutants NAME, with a name from operation_mutants.hpp\n");
    return 2;
  }
  restrip::verify::operations::active_operation_mutant = *mutant;
  GTEST_FLAG_SET(fail_fast, true);
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  auto* const notice = new Notice;  // the listeners own it
  listeners.Append(notice);
  if (RUN_ALL_TESTS() != 0 && !notice->killer.empty()) {
    fmt::print("\nkilled by: {}\n", notice->killer);
    return 0;
  }
  fmt::print("\nsurvived {} tests\n", notice->passed);
  return 1;
}
