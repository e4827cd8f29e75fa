// The readers and the simplifier of the program `restrip` for JavaScript (bindings/js/formats.mjs): one module for each
// file that is read, and for each mesh that is simplified. The caller writes the bytes into memory taken by
// readers_take, and reads the ReadResult that readers_read or readers_simplified returns.
//
// The readers throw, but this module cannot catch. The sentence of an exception goes to JavaScript, which throws it and
// drops the module with all of its memory.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lod/coloring_check.hpp"
#include "lod/mesh_formats.hpp"
#include "lod/simplifier.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup.hpp"

#ifdef __wasm__
#define READERS_EXPORT(name) extern "C" __attribute__((export_name(#name)))

extern "C" [[noreturn]] __attribute__((import_module("readers"), import_name("refuse"))) void readers_refuse(
    const char*);

// The functions that the compiler calls for `throw`.
extern "C" void* __cxa_allocate_exception(std::size_t bytes) noexcept { return std::malloc(bytes); }
extern "C" void __cxa_free_exception(void* memory) noexcept { std::free(memory); }
extern "C" [[noreturn]] void __cxa_throw(void* thrown, void* /*type*/, void (* /*destroy*/)(void*)) {
  readers_refuse(static_cast<std::exception*>(thrown)->what());
}
#else  // compiled only as a check
#define READERS_EXPORT(name) extern "C"
#endif

namespace {

using namespace restrip::tools;

/// Addresses, and counts of numbers or characters; lists that the kind lacks are empty.
struct ReadResult {
  enum class Kind : std::uint32_t { mesh, progressive, baked } kind = Kind::mesh;
  const void* points = nullptr;  // three floats each
  std::uint32_t point_numbers = 0;
  const void* triangles = nullptr;  // of a mesh, or of the base of a progressive one: three vertices each
  std::uint32_t triangle_numbers = 0;
  const void* splits = nullptr;  // of a progressive mesh: v_s, v_t, v_l, v_r each
  std::uint32_t split_numbers = 0;
  const void* baked = nullptr;  // the bytes of a baked mesh
  std::uint32_t baked_bytes = 0;
  const void* left_out = nullptr;  // the rest of the file: the end of a sentence
  std::uint32_t left_out_bytes = 0;
};

ReadMesh mesh;
std::string left_out;
std::vector<float> points;
ReadResult found;
std::optional<Simplifier> simplifier;
std::vector<Corners> base;
std::vector<restrip::SplitRecord> splits;

template <class List>
void give(const List& list, std::size_t numbers, const void*& address, std::uint32_t& count) {
  address = list.data();
  count = static_cast<std::uint32_t>(list.size() * numbers);
}

void give_points(const std::vector<Point>& list) {
  points.clear();
  for (const Point& p : list)
    for (const double coordinate : {p.x, p.y, p.z}) points.push_back(static_cast<float>(coordinate));
  give(points, 1, found.points, found.point_numbers);
}

std::string extension_of(std::string_view name) {
  std::string extension(name.substr(std::min(name.rfind('.'), name.size())));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

}  // namespace

READERS_EXPORT(readers_take)
void* readers_take(std::uint32_t bytes) { return std::malloc(bytes); }

/// The extension of `name` decides.
READERS_EXPORT(readers_read)
const ReadResult* readers_read(const char* bytes, std::uint32_t count, const char* name, std::uint32_t name_bytes) {
  const std::string file(name, name_bytes);
  const ReadSibling no_sibling = [&](const std::string& other) -> std::string {
    throw BadInput(file + ": keeps part of itself in '" + other +
                   "', which is not at hand; save it as one file (.glb)");
  };
  const std::string extension = extension_of(file);
  mesh = parse_mesh({bytes, count}, extension, file, no_sibling);
  if (auto* soup = std::get_if<Soup>(&mesh)) {
    // glTF repeats a vertex wherever a normal or a texture breaks; a strip crosses it.
    if (Mended mended; extension == ".glb" || extension == ".gltf") weld(*soup, mended);
    give_points(soup->points);
    give(soup->triangles, 3, found.triangles, found.triangle_numbers);
  } else if (const auto* progressive = std::get_if<ProgressiveMesh>(&mesh)) {
    found.kind = ReadResult::Kind::progressive;
    give_points(progressive->points);
    give(progressive->base, 3, found.triangles, found.triangle_numbers);
    give(progressive->splits, 4, found.splits, found.split_numbers);
  } else if (const auto* baked = std::get_if<BakedBytes>(&mesh)) {
    found.kind = ReadResult::Kind::baked;
    give(baked->bytes, 1, found.baked, found.baked_bytes);
  }
  left_out = left_out_in_words(left_out_of(mesh));
  give(left_out, 1, found.left_out, found.left_out_bytes);
  return &found;
}

/// Begins to simplify a mesh of finite points, three numbers each, and triangles of them, three vertices each.
READERS_EXPORT(readers_simplify)
void readers_simplify(const float* coordinates, std::uint32_t point_numbers, const std::uint32_t* corners,
                      std::uint32_t corner_numbers) {
  std::vector<Simplifier::Point> places(point_numbers / 3);
  for (std::uint32_t i = 0; i < point_numbers; ++i) places[i / 3][i % 3] = static_cast<double>(coordinates[i]);
  simplifier.emplace(restrip::StripMesh::build(std::span(corners, corner_numbers), places.size()), places);
}

/// Does at most `most` collapses. The number of triangles above `wanted`, or 0 if no further one can or need be done.
READERS_EXPORT(readers_simplify_on)
std::uint32_t readers_simplify_on(std::uint32_t wanted, std::uint32_t most) {
  return simplifier->run(wanted, most) ? 0 : static_cast<std::uint32_t>(simplifier->mesh().triangle_count() - wanted);
}

/// The levels, without the points, which are those given.
READERS_EXPORT(readers_simplified)
const ReadResult* readers_simplified() {
  base = corners_of(simplifier->mesh());
  splits.assign(simplifier->collapses().rbegin(), simplifier->collapses().rend());
  found.kind = ReadResult::Kind::progressive;
  give(base, 3, found.triangles, found.triangle_numbers);
  give(splits, 4, found.splits, found.split_numbers);
  return &found;
}
