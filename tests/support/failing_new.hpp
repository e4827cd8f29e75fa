// Simulated shortage of memory: a program that links failing_new.cpp can make a chosen allocation fail, and count them.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <new>

namespace restrip::testing_support {

enum class Shortage { once, for_good };  ///< only that allocation fails, or all later ones too

/// Allocation number `countdown` from now (starting at 1) throws std::bad_alloc.
void fail_allocation(std::size_t countdown, Shortage shortage) noexcept;
/// Ends the shortage. True if an allocation has failed since the call above.
bool end_shortage() noexcept;
/// How many there have been, those that failed included.
std::size_t allocations() noexcept;

/// Calls `work` with its first allocation failing, then with its second, and so on until none fails, each under both
/// shortages. Calls `check` after each failure. Exceptions other than std::bad_alloc propagate. Returns the number of
/// allocations of `work`.
template <class Work, class Check>
std::size_t for_each_allocation(Work&& work, Check&& check) {
  for (std::size_t n = 1;; ++n)
    for (const Shortage shortage : {Shortage::once, Shortage::for_good}) {
      fail_allocation(n, shortage);
      try {
        work();
      } catch (const std::bad_alloc&) {
        // expected
      } catch (...) {
        end_shortage();
        throw;
      }
      if (!end_shortage()) return n - 1;
      check();
    }
}

}  // namespace restrip::testing_support
