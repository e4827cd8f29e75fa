#pragma once
// Work that several threads share.

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace restrip::verify {

/// Each thread makes itself a worker and has it called with numbers below `count`, of which every one comes once, the
/// lower ones earlier. An exception ends the work, and is thrown when all threads have ended.
template <class MakeWorker>
void on_threads(unsigned threads, std::size_t count, const MakeWorker& make_worker) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto run = [&] {
    try {
      auto work = make_worker();
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(run);
    run();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace restrip::verify
