// The halves of operations by linked rules give what split_and_link(), collapse_and_link() and flip_and_link() give on
// a second mesh, colour by colour and in their reports, and leave a valid colouring between them.
#include "restrip/operations/linked_hooks.hpp"

#include <gtest/gtest.h>

#include "hooked_operations.hpp"

namespace restrip {
namespace {

TEST(LinkedHooks, GiveWhatLinkedOperationsGive) { hooked::expect_what_operations_give(HookRules::linked); }

}  // namespace
}  // namespace restrip
