// A glTF 2.0 file taken apart: its JSON, and what its accessors say. What it draws is read_gltf.cpp's to know.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/attributes.hpp"
#include "meshes/json_tree.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

/// What is read of one file: values (vertices, attributes and indices, those of each node counted, and 16 for each
/// primitive) for each byte of the file and its buffers, or so many.
inline constexpr std::uint64_t most_gltf_values_per_byte = 16;
inline constexpr std::uint64_t most_gltf_values = std::uint64_t{1} << 23U;

/// The extension of a mesh that holds its levels of detail with their strips (lod/baked_gltf.hpp).
inline constexpr std::string_view baked_strips_extension = "RESTRIP_baked_strips";

class GltfFile {
 public:
  /// Text, or binary (GLB), whichever the bytes are. They, the name and `beside` must outlive it. Throws BadInput when
  /// the file is damaged, is not a glTF 2.0 or requires an extension that changes what it draws and is not known here.
  GltfFile(std::string_view bytes, const std::string& name, const ReadBeside& beside);

  [[nodiscard]] JsonPlace root() const { return {json_, name_}; }
  /// The bytes of a buffer view. Throws BadInput when it reaches beyond its buffer.
  [[nodiscard]] std::string_view view(std::uint64_t number);
  [[nodiscard]] JsonPlace accessor(std::uint64_t number) const { return root()["accessors"].at(number); }
  /// The values of an accessor; sparse ones and strides are seen to. Throws BadInput when it is of another kind or
  /// reaches beyond its buffer.
  [[nodiscard]] std::vector<Point> positions(std::uint64_t accessor);
  /// What an accessor says of an attribute with this name: as it is encoded where glTF allows that without extensions,
  /// else as floats. Nothing where it is of a kind that is not carried: skins, matrices, names of no meaning.
  [[nodiscard]] std::optional<Attribute> attribute(std::uint64_t accessor, const std::string& name);
  /// Three numbers that are indices, for each element.
  [[nodiscard]] std::vector<Corners> triples(std::uint64_t accessor);
  /// Counts values that are about to be read. Throws BadInput when they are more than the file may have.
  void charge(std::uint64_t values);
  /// The largest value of the type of an index is the restart of primitives: strip_end.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::uint64_t accessor);

 private:
  /// Elements of one type in a buffer.
  struct Elements {
    std::string_view bytes;  // from the first to the end of the last
    std::size_t stride = 0;
    unsigned type = 0;  // as glTF numbers the types of components

    /// The number as it is stored, not normalised.
    [[nodiscard]] double value(std::size_t element, std::size_t component) const;
  };

  void read_container(std::string_view bytes);
  void check_extensions() const;
  [[nodiscard]] std::string_view buffer(std::uint64_t number);
  [[nodiscard]] std::string load(const JsonPlace& uri) const;
  /// `count` elements of so many components at the place that `from` says: bufferView, byteOffset, componentType.
  [[nodiscard]] Elements elements(const JsonPlace& from, unsigned type, std::size_t components, std::size_t count);
  /// Fills `values` with read(elements, number) for each element of the accessor; those that no buffer has are zero.
  template <class Value, class Read>
  void fill(const JsonPlace& accessor, unsigned type, std::size_t components, std::vector<Value>& values, Read&& read);
  /// Its count; refuses what a file of this size cannot mean.
  [[nodiscard]] std::size_t count_of(const JsonPlace& accessor) const;

  const std::string& name_;
  const ReadBeside& beside_;
  std::size_t file_bytes_;
  std::uint64_t charged_ = 0;
  std::uint64_t limit_ = most_gltf_values;
  bool all_loaded_ = false;
  JsonValue json_;
  std::string_view binary_;  // the BIN chunk of a GLB
  bool has_binary_ = false;
  std::vector<std::string> loaded_;  // buffers that are not in the file, by number
};

}  // namespace restrip::tools
