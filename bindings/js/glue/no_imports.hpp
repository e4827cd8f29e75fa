// Functions that the standard library of WebAssembly calls when memory runs out or when it would throw. Its own
// versions print, for which the module would import files. These stop the module instead.
#pragma once

#ifdef __wasm__

#include <cstddef>
#include <cstdlib>
#include <new>

// A module is one source, so that these are defined once.
void* operator new(std::size_t bytes) {
  void* memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) __builtin_trap();
  return memory;
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return std::malloc(bytes != 0 ? bytes : 1); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

#if _LIBCPP_VERSION >= 150000
void std::__libcpp_verbose_abort(const char*, ...) noexcept { __builtin_trap(); }
#endif

#endif
