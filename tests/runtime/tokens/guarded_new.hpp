// For the one source of a program: whoever looks behind an allocated block ends the program. Nothing is given back.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace restrip::judge {

inline std::size_t allocated = 0;

}  // namespace restrip::judge

void* operator new(std::size_t size) {
  constexpr std::size_t page = 4096;
  restrip::judge::allocated += size;
  void* const room = mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (size > page || room == MAP_FAILED || mprotect(static_cast<char*>(room) + page, page, PROT_NONE) != 0)
    std::exit(2);
  return static_cast<char*>(room) + page - size;
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
