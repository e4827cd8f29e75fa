#include "failing_new.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace restrip::testing_support {
namespace {

std::atomic<std::size_t> countdown{0};  // 0: allocations succeed
std::atomic<bool> for_good{false};
std::atomic<bool> failed{false};
std::atomic<std::size_t> count{0};

bool runs_out() noexcept {
  if (countdown == 0) return false;
  if (countdown > 1) {
    --countdown;
    return false;
  }
  failed = true;
  if (!for_good) countdown = 0;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment) {
  ++count;
  void* memory = runs_out() ? nullptr
                 : alignment <= alignof(std::max_align_t)
                     ? std::malloc(size == 0 ? 1 : size)
                     : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void fail_allocation(std::size_t number, Shortage shortage) noexcept {
  failed = false;
  for_good = shortage == Shortage::for_good;
  countdown = number;
}

bool end_shortage() noexcept {
  countdown = 0;
  return failed;
}

std::size_t allocations() noexcept { return count; }

}  // namespace restrip::testing_support

// The nothrow and array forms of the standard library call these.
void* operator new(std::size_t size) { return restrip::testing_support::allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return restrip::testing_support::allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size) { return restrip::testing_support::allocate(size, 1); }
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept { operator delete(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
