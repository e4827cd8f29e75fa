// Must not be compiled with -fsanitize-coverage: it is what such files call.
#include "step_counter.hpp"

namespace {
std::uint64_t blocks = 0;
}  // namespace

extern "C" void __sanitizer_cov_trace_pc();               // NOLINT(bugprone-reserved-identifier): the compiler's name
extern "C" void __sanitizer_cov_trace_pc() { ++blocks; }  // NOLINT(bugprone-reserved-identifier)

std::uint64_t restrip::counter::steps() noexcept { return blocks; }
