// Work shared by threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace restrip {

/// Each thread makes a worker and calls it with numbers below `count`. Each number is used once, lower ones earlier.
/// The first exception ends the work, and is thrown again when all threads have ended.
template <class MakeWorker>
void on_threads(unsigned threads, std::size_t count, const MakeWorker& make_worker) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    try {
      auto work = make_worker();
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

/// The same with one worker for all threads.
template <class Work>
void share(std::size_t count, unsigned threads, const Work& work) {
  on_threads(threads, count, [&] { return [&](std::size_t i) { work(i); }; });
}

}  // namespace restrip
