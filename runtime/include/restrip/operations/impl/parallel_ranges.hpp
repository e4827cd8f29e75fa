// One loop over a range of numbers, cut into pieces that run at the same time: oneTBB when RESTRIP_USE_TBB is defined,
// else std::jthread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

#ifdef RESTRIP_USE_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace restrip::detail {

/// Calls body(begin, end) for ranges that together are [0, n), each number once. `threads`: 1 uses only the caller's
/// thread, 0 one thread for each processor. The first exception of a range is thrown again here, after all ranges have
/// ended. In a program without exceptions a thread that cannot be started ends the program.
template <class Body>
void parallel_ranges(std::size_t n, unsigned threads, const Body& body) {
  constexpr std::size_t few = 32;  // operations that are not worth a thread
  if (threads == 1 || n <= few) {
    if (n > 0) body(std::size_t{0}, n);
    return;
  }
#ifdef RESTRIP_USE_TBB
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, few),
                      [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
  });
#else
  if (threads == 0) threads = (std::max)(1U, std::thread::hardware_concurrency());
  const std::size_t pieces = std::min<std::size_t>(threads, (n + few - 1) / few);
  const auto run = [&](std::size_t piece) {
    body(n / pieces * piece + (std::min)(piece, n % pieces),
         n / pieces * (piece + 1) + (std::min)(piece + 1, n % pieces));
  };
#ifdef __cpp_exceptions
  std::vector<std::exception_ptr> failures(pieces);
  const auto run_and_catch = [&](std::size_t piece) noexcept {
    try {
      run(piece);
    } catch (...) {
      failures[piece] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> workers;
    workers.reserve(pieces - 1);
    std::size_t piece = 1;
    try {
      for (; piece < pieces; ++piece) workers.emplace_back(run_and_catch, piece);
    } catch (const std::system_error&) {
      // No more threads can be started: this one does the rest.
      for (; piece < pieces; ++piece) run_and_catch(piece);
    }
    run_and_catch(0);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
#else
  std::vector<std::jthread> workers;
  workers.reserve(pieces - 1);
  for (std::size_t piece = 1; piece < pieces; ++piece) workers.emplace_back(run, piece);
  run(0);
#endif
#endif
}

}  // namespace restrip::detail
