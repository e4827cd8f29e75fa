#include "meshes/write_glb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t most_glb_bytes = std::numeric_limits<std::int32_t>::max();

/// A run of the index buffer.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The strips between the restarts.
std::vector<Run> strips_of(std::span<const std::uint32_t> indices) {
  std::vector<Run> runs;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= indices.size(); ++i) {
    if (i < indices.size() && indices[i] != restart_index) continue;
    runs.push_back({first, i - first});
    first = i + 1;
  }
  return runs;
}

/// The least or the greatest coordinates, as glTF wants them said.
std::string bound(std::span<const Point> points, const float& (*of)(const float&, const float&)) {
  Point p = points.front();
  for (const Point& q : points) p = {of(p.x, q.x), of(p.y, q.y), of(p.z, q.z)};
  return fmt::format("[{},{},{}]", p.x, p.y, p.z);
}

/// One chunk of a GLB, filled up to a multiple of four bytes.
void put_chunk(std::string& glb, std::string bytes, std::uint32_t kind, char filling) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filling);
  put(glb, static_cast<std::uint32_t>(bytes.size()));
  put(glb, kind);
  glb += bytes;
}

/// The data of vertices begins at multiples of four bytes.
std::size_t stride_of(const Attribute& attribute) { return (attribute.value_bytes() + 3) / 4 * 4; }

/// The parts of the JSON that belong together by their numbers, written side by side.
class GlbWriter {
 public:
  GlbWriter(const StripFile& file, GltfPrimitives primitives, const GlbExtension& extension)
      : file_(file), primitives_(primitives), extension_(extension) {
    if (file.triangles.empty()) throw BadInput("glTF has no mesh without triangles");
    if (primitives == GltfPrimitives::list)
      for (const Corners& t : file.triangles) list_.insert(list_.end(), t.begin(), t.end());
    indices_ = primitives == GltfPrimitives::list ? std::span<const std::uint32_t>(list_) : file.indices;
    // The largest value of its width is the restart, or forbidden.
    width_ = file.points.size() < 0xFFFF ? 2 : 4;
    std::size_t bytes = 12 * file.points.size() + width_ * indices_.size() + extension.bytes.size();
    for (const Attribute& attribute : file.attributes) bytes += file.points.size() * stride_of(attribute);
    if (bytes > most_glb_bytes)
      throw BadInput(fmt::format("a GLB holds {} bytes at most; write .ply or .bin", most_glb_bytes));
    binary_.reserve(bytes);
  }

  std::string run() && {
    put_positions();
    for (const Attribute& attribute : file_.attributes) put_attribute(attribute);
    put_indices();
    put_extension();
    std::string json = R"({"asset":{"version":"2.0","generator":"restrip"},"scene":0,"scenes":[{"nodes":[0]}],)"
                       R"("nodes":[{"mesh":0}],)";
    const bool restarts = std::find(indices_.begin(), indices_.end(), restart_index) != indices_.end();
    std::vector<std::string_view> used;
    if (primitives_ == GltfPrimitives::restart && restarts) {
      used.push_back(restart_extension);
      json += fmt::format(R"("extensionsRequired":["{}"],)", restart_extension);
    }
    if (!extension_.name.empty()) used.push_back(extension_.name);
    if (!used.empty()) json += fmt::format(R"("extensionsUsed":["{}"],)", fmt::join(used, R"(",")"));
    fmt::format_to(
        std::back_inserter(json),
        R"("meshes":[{{"primitives":[{}]{}}}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
        meshes_, extensions_, accessors_, views_, binary_.size());
    std::string chunks;
    put_chunk(chunks, std::move(json), 0x4E4F534A, ' ');      // JSON
    put_chunk(chunks, std::move(binary_), 0x004E4942, '\0');  // BIN
    std::string glb = "glTF";
    put(glb, 2);
    put(glb, static_cast<std::uint32_t>(12 + chunks.size()));
    return glb + chunks;
  }

 private:
  enum class ViewOf { vertices, indices, other };

  /// The view of what was put since `begin`.
  void end_view(std::size_t begin, ViewOf content, std::size_t stride = 0) {
    auto out = std::back_inserter(views_);
    fmt::format_to(out, R"({}{{"buffer":0,"byteOffset":{},"byteLength":{})", view_count_ == 0 ? "" : ",", begin,
                   binary_.size() - begin);
    if (stride != 0) fmt::format_to(out, R"(,"byteStride":{})", stride);
    if (content != ViewOf::other) fmt::format_to(out, R"(,"target":{})", content == ViewOf::vertices ? 34962 : 34963);
    views_ += '}';
    ++view_count_;
  }

  void put_positions() {
    for (const Point& p : file_.points) put(binary_, p);
    end_view(0, ViewOf::vertices, 12);
    fmt::format_to(std::back_inserter(accessors_),
                   R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":{},"max":{}}})",
                   file_.points.size(), bound(file_.points, std::min<float>), bound(file_.points, std::max<float>));
    attributes_ = R"("POSITION":0)";
    accessor_count_ = 1;
  }

  void put_attribute(const Attribute& attribute) {
    const std::size_t begin = binary_.size();
    const std::size_t size = attribute.value_bytes();
    for (std::size_t v = 0; v < file_.points.size(); ++v) {
      binary_.append(attribute.bytes, v * size, size);
      binary_.append(stride_of(attribute) - size, '\0');
    }
    fmt::format_to(std::back_inserter(accessors_),
                   R"(,{{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", view_count_,
                   static_cast<unsigned>(attribute.type), file_.points.size(),
                   attribute.components == 1 ? "SCALAR" : fmt::format("VEC{}", attribute.components),
                   attribute.normalized ? R"(,"normalized":true)" : "");
    end_view(begin, ViewOf::vertices, stride_of(attribute));
    fmt::format_to(std::back_inserter(attributes_), R"(,"{}":{})", attribute.name, accessor_count_++);
  }

  void put_indices() {
    const std::size_t begin = binary_.size();
    for (const std::uint32_t index : indices_) put(binary_, index, width_);
    const std::vector<Run> runs =
        primitives_ == GltfPrimitives::strips ? strips_of(indices_) : std::vector<Run>{{0, indices_.size()}};
    for (const Run& run : runs) {
      fmt::format_to(std::back_inserter(accessors_),
                     R"(,{{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                     view_count_, width_ * run.first, width_ == 2 ? 5123 : 5125, run.count);
      fmt::format_to(std::back_inserter(meshes_), R"({}{{"attributes":{{{}}},"indices":{},"mode":{}}})",
                     meshes_.empty() ? "" : ",", attributes_, accessor_count_++,
                     primitives_ == GltfPrimitives::list ? 4 : 5);
    }
    end_view(begin, ViewOf::indices);
  }

  void put_extension() {
    if (extension_.name.empty()) return;
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    const std::size_t begin = binary_.size();
    binary_ += extension_.bytes;
    extensions_ = fmt::format(R"(,"extensions":{{"{}":{{"bufferView":{}}}}})", extension_.name, view_count_);
    end_view(begin, ViewOf::other);
  }

  const StripFile& file_;
  GltfPrimitives primitives_;
  GlbExtension extension_;
  std::vector<std::uint32_t> list_;
  std::span<const std::uint32_t> indices_;
  unsigned width_ = 2;
  std::string binary_;
  std::string attributes_;  // of every primitive
  std::string meshes_;      // the primitives
  std::string extensions_;  // of the mesh
  std::string accessors_;
  std::string views_;
  std::size_t accessor_count_ = 0;
  std::size_t view_count_ = 0;
};

}  // namespace

std::string glb_bytes(const StripFile& file, GltfPrimitives primitives, const GlbExtension& extension) {
  return GlbWriter(file, primitives, extension).run();
}

}  // namespace restrip::tools
