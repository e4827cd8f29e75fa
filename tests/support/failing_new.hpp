// Memory that runs out on demand: a program that links failing_new.cpp can make an allocation of its choice fail.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <new>

namespace restrip::testing_support {

enum class Shortage { once, for_good };  ///< only that allocation fails, or all that follow too

/// From now on allocation number `countdown` (from 1) of this process throws std::bad_alloc.
void fail_allocation(std::size_t countdown, Shortage shortage) noexcept;
/// Memory is there again. True when an allocation has failed since the call above.
bool end_shortage() noexcept;

/// Calls `work` with its first allocation failing, then with its second, and so on until none fails any more, each
/// under both shortages. Calls `check` after each failure. Exceptions other than std::bad_alloc pass. Returns the
/// number of allocations that `work` makes.
template <class Work, class Check>
std::size_t for_each_allocation(Work&& work, Check&& check) {
  for (std::size_t n = 1;; ++n)
    for (const Shortage shortage : {Shortage::once, Shortage::for_good}) {
      fail_allocation(n, shortage);
      try {
        work();
      } catch (const std::bad_alloc&) {
        // as it should be
      } catch (...) {
        end_shortage();
        throw;
      }
      if (!end_shortage()) return n - 1;
      check();
    }
}

}  // namespace restrip::testing_support
