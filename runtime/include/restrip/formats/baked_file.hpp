// Reads baked meshes, the files that `restrip bake` writes (docs/reference/file-formats.md has the format), from
// memory.
//
//   BakedFile file;
//   if (const std::string fault = read_baked(bytes, file); !fault.empty()) return report(fault);
//   split_baked(file.mesh, spokes_of(file.mesh, file.splits[i]), file.records[i], file.splits[i].v_t);
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "restrip/mesh/split_record.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/baked.hpp"

namespace restrip {

/// User data for each record, the same number of bytes for all: a texture coordinate, an error bound, a priority.
struct BakedPayload {
  std::size_t bytes = 0;  ///< for each record; 0: none
  std::vector<std::byte> all;

  [[nodiscard]] std::span<const std::byte> operator[](std::size_t record) const noexcept {
    return std::span(all).subspan(record * bytes, bytes);
  }
};

struct BakedFile {
  std::vector<std::array<float, 3>> points;  ///< of all vertices: the base first, then one for each split
  std::vector<std::array<Vertex, 3>> base;   ///< triangle t of the base has handle t in `mesh`
  std::vector<SplitRecord> splits;           ///< from coarse to fine
  StripMesh mesh;                            ///< the base, in its colours
  BakedRecords records;
  BakedPayload payload{};
};

/// Fills `file` and returns an empty string, or returns what is wrong with the bytes, phrased to follow the file name
/// and a colon; then `file` is unchanged. Refuses bytes that are truncated, altered (the checksum covers all of them),
/// of another version, or that describe splits or colours that no mesh can have. Plays all records once: the time is
/// linear in the bytes and the finest mesh. Memory is proportional to the bytes. Throws only std::bad_alloc, and
/// std::length_error for more triangles than a StripMesh can hold.
[[nodiscard]] std::string read_baked(std::span<const std::byte> bytes, BakedFile& file);

/// Replaces the payload of a baked mesh: the same number of bytes for each record, in the order of the records. An
/// empty payload removes it. Returns an empty string, or what is wrong, as read_baked() does; then `file` is unchanged.
/// Reads only the checksum and the header. Linear time. Throws only std::bad_alloc.
[[nodiscard]] std::string set_payload(std::vector<std::byte>& file, std::span<const std::byte> payload);

}  // namespace restrip
