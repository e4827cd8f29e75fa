// Parses a glTF 2.0 file: its JSON and its accessors. read_gltf.cpp interprets what the file draws.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/json.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

/// A limit for one file: values (vertices, attributes and indices, counted for each node, and 16 for each primitive)
/// per byte of the file and its buffers.
inline constexpr std::uint64_t most_gltf_values_per_byte = 16;
inline constexpr std::uint64_t most_gltf_values = std::uint64_t{1} << 23U;

/// The extension of a mesh that holds its levels of detail with their strips (lod/baked_file.hpp).
inline constexpr std::string_view baked_strips_extension = "RESTRIP_baked_strips";

/// The extension of a mesh or a primitive that holds its splits (lod/pm_file.hpp).
inline constexpr std::string_view progressive_extension = "MANYFOLD_mesh_progressive";

class GltfFile {
 public:
  /// Text or binary (GLB), detected from the bytes. The bytes, the name and `sibling` must outlive the object. Throws
  /// BadInput if the file is damaged, is not glTF 2.0, or requires an unknown extension that changes what it draws.
  GltfFile(std::string_view bytes, const std::string& name, const ReadSibling& sibling);

  [[nodiscard]] const JsonValue& root() const { return json_; }
  /// The bytes of a buffer view. Throws BadInput if it reaches beyond its buffer.
  [[nodiscard]] std::string_view view(std::uint64_t number);
  [[nodiscard]] JsonValue accessor(std::uint64_t number) const { return root()["accessors"].at(number); }
  /// The values of an accessor, which may be sparse or strided. Throws BadInput if it is of another kind or reaches
  /// beyond its buffer.
  [[nodiscard]] std::vector<Point> positions(std::uint64_t accessor);
  /// The attribute of this name in an accessor, in its encoding if glTF allows that without extensions, otherwise as
  /// floats. Empty if its kind is not supported: skins, matrices, unknown names.
  [[nodiscard]] std::optional<Attribute> attribute(std::uint64_t accessor, const std::string& name);
  /// Three indices for each element.
  [[nodiscard]] std::vector<Corners> triples(std::uint64_t accessor);
  /// Counts values before they are read. Throws BadInput if the file exceeds its limit.
  void charge(std::uint64_t values);
  /// `restarts`: the largest value of the index type restarts the primitive and becomes strip_end.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::uint64_t accessor, bool restarts);

 private:
  /// Elements of one type in a buffer.
  struct Elements {
    std::string_view bytes;  // from the first to the end of the last
    std::size_t stride = 0;
    ComponentType type = ComponentType::real;

    /// The stored number, not normalised.
    [[nodiscard]] double value(std::size_t element, std::size_t component) const;
  };

  void read_container(std::string_view bytes);
  void check_extensions() const;
  [[nodiscard]] std::string_view buffer(std::uint64_t number);
  [[nodiscard]] std::string load(const JsonValue& uri) const;
  /// `count` elements with this number of components at the place given by `from`: bufferView, byteOffset,
  /// componentType.
  [[nodiscard]] Elements elements(const JsonValue& from, ComponentType type, std::size_t components, std::size_t count);
  /// Fills `values` with read(elements, number) for each element of the accessor. Elements without a buffer are zero.
  template <class Value, class Read>
  void fill(const JsonValue& accessor, ComponentType type, std::size_t components, std::vector<Value>& values,
            Read&& read);

  const std::string& name_;
  const ReadSibling& sibling_;
  std::size_t file_bytes_;
  std::uint64_t charged_ = 0;
  std::uint64_t limit_ = most_gltf_values;
  bool all_loaded_ = false;
  JsonValue json_;
  std::string_view binary_;  // the BIN chunk of a GLB
  bool has_binary_ = false;
  std::vector<std::string> loaded_;  // buffers from other files or data URIs, by number
};

}  // namespace restrip::tools
