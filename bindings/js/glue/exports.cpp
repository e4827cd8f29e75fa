// What the module for JavaScript has besides the C interface (restrip.h), which JavaScript calls itself: memory for
// arguments, the reason of a call that was stopped, and the picture of all strips in one call.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#include "restrip.h"

#ifdef __wasm__
#include "stop.hpp"

// Functions that the standard library of WebAssembly calls when memory runs out or when it would throw. Its own
// versions print, for which the module would import files. These stop the module instead.
void* operator new(std::size_t bytes) {
  void* memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) RESTRIP_THROW(std::bad_alloc, "restrip: out of memory");
  return memory;
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return std::malloc(bytes != 0 ? bytes : 1); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

#if _LIBCPP_VERSION >= 150000
void std::__libcpp_verbose_abort(const char*, ...) noexcept { __builtin_trap(); }
#endif

/// The reason of the last call that ended by a trap, or null; reading it clears it.
extern "C" __attribute__((export_name("restrip_js_stopped"))) const char* restrip_js_stopped() {
  return std::exchange(restrip::web::stopped_because, nullptr);
}
#define RESTRIP_JS_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else  // compiled only as a check
#define RESTRIP_JS_EXPORT(name) extern "C"
#endif

RESTRIP_JS_EXPORT(restrip_js_take) void* restrip_js_take(std::size_t bytes) { return std::malloc(bytes); }
RESTRIP_JS_EXPORT(restrip_js_give_back) void restrip_js_give_back(void* memory) { std::free(memory); }

/// Writes nine numbers for each triangle, strip by strip: the triangle, its corners, the triangles beyond its sides
/// (RESTRIP_NONE at the boundary), a mask of the sides where its strip continues, and the strip, named by its lowest
/// triangle.
RESTRIP_JS_EXPORT(restrip_js_ribbon) restrip_status restrip_js_ribbon(const restrip_mesh* mesh, std::uint32_t* out) {
  std::size_t strips = 0;
  if (const restrip_status status = restrip_mesh_strip_count(mesh, &strips); status != RESTRIP_OK) return status;
  std::vector<std::uint32_t> triangles(restrip_mesh_triangle_count(mesh));
  std::vector<std::size_t> starts(strips + 1);
  std::vector<std::uint8_t> solid(restrip_mesh_triangle_bound(mesh));
  if (triangles.empty()) return RESTRIP_OK;
  restrip_status status = restrip_mesh_strips(mesh, triangles.data(), triangles.size(), starts.data(), starts.size());
  if (status == RESTRIP_OK) status = restrip_mesh_get_colors(mesh, solid.data(), solid.size());
  for (std::size_t s = 0; status == RESTRIP_OK && s < strips; ++s) {
    const auto* const begin = triangles.data() + starts[s];
    const auto* const end = triangles.data() + starts[s + 1];
    const std::uint32_t lowest = *std::min_element(begin, end);
    for (const auto* t = begin; t != end; ++t) {
      *out++ = *t;
      for (std::uint32_t side = 0; side < 3; ++side) *out++ = restrip_mesh_from(mesh, 4 * *t + side);
      for (std::uint32_t side = 0; side < 3; ++side)
        *out++ = restrip_mesh_triangle(mesh, restrip_mesh_opposite(mesh, 4 * *t + side));
      *out++ = solid[*t];
      *out++ = lowest;
    }
  }
  return status;
}
