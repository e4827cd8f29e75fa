// Gives the verifier of operations one deliberate fault, named by the argument, and tells the first test that notices
// it. With the fault `none` every test must pass.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "operation_mutant_names.hpp"
#include "operation_mutants.hpp"

namespace {

using restrip::verify::operations::OperationMutant;

// Without a default case: the compiler warns about a fault that is not among the names.
constexpr std::string_view name_of(OperationMutant mutant) {
  switch (mutant) {
#define RESTRIP_CASE(name)    \
  case OperationMutant::name: \
    return #name;
    RESTRIP_EACH_MUTANT(RESTRIP_CASE)
#undef RESTRIP_CASE
  }
  return {};
}

std::optional<OperationMutant> mutant_named(std::string_view name) {
#define RESTRIP_ITEM(name) OperationMutant::name,
  for (const OperationMutant mutant : {RESTRIP_EACH_MUTANT(RESTRIP_ITEM)})
    if (name_of(mutant) == name) return mutant;
#undef RESTRIP_ITEM
  return std::nullopt;
}

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
  const std::optional<OperationMutant> mutant = argc == 2 ? mutant_named(argv[1]) : std::nullopt;
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
