// Must not be compiled with -fsanitize-coverage: it is what such files call.
#include "step_counter.hpp"

#include <cstdlib>
#include <new>

namespace {
std::uint64_t blocks = 0;
std::uint64_t news = 0;
}  // namespace

extern "C" void __sanitizer_cov_trace_pc();               // NOLINT(bugprone-reserved-identifier): the compiler's name
extern "C" void __sanitizer_cov_trace_pc() { ++blocks; }  // NOLINT(bugprone-reserved-identifier)

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++news;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace restrip::counter {

std::uint64_t steps() noexcept { return blocks; }
std::uint64_t allocations() noexcept { return news; }

}  // namespace restrip::counter
