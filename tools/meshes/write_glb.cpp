#include "meshes/write_glb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <variant>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t most_glb_bytes = std::numeric_limits<std::int32_t>::max();

/// Appends one chunk of a GLB, padded to a multiple of four bytes.
void put_chunk(std::string& glb, std::string bytes, std::uint32_t kind, char filling) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filling);
  put(glb, static_cast<std::uint32_t>(bytes.size()));
  put(glb, kind);
  glb += bytes;
}

/// Vertex data begins at multiples of four bytes.
std::size_t stride_of(const Attribute& attribute) { return (attribute.value_bytes() + 3) / 4 * 4; }

/// Writes the parts of the JSON that refer to each other by number.
class GlbWriter {
 public:
  GlbWriter(const StripFile& file, const GlbExtension& extension) : file_(file), extension_(extension) {
    if (file.buffer.empty()) throw BadInput("glTF has no mesh without triangles");
    std::size_t bytes = 12 * file.points.size() + file.buffer.bytes().size() + extension.bytes.size();
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
    std::vector<std::string_view> used;
    if (restarts(file_.buffer)) {
      used.push_back(restart_extension);
      json += fmt::format(R"("extensionsRequired":["{}"],)", restart_extension);
    }
    if (!extension_.name.empty()) used.push_back(extension_.name);
    if (!used.empty()) json += fmt::format(R"("extensionsUsed":["{}"],)", fmt::join(used, R"(",")"));
    fmt::format_to(
        std::back_inserter(json),
        R"("meshes":[{{"primitives":[{}]{}}}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
        meshes_, extensions_, accessors_, views_, binary_.size());
    return glb_of_chunks(std::move(json), std::move(binary_));
  }

 private:
  enum class ViewOf { vertices, indices, other };

  /// Adds the view of the bytes written since `begin`.
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
                   R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",{}}})", file_.points.size(),
                   bounds_of(file_.points));
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
    const IndexBuffer& buffer = file_.buffer;
    put(binary_, buffer);
    std::vector<IndexRange> primitives = buffer.batches;
    if (buffer.form == StripForm::lengths) {
      primitives.clear();
      std::size_t first = 0;
      for (const std::uint32_t length : buffer.lengths)
        primitives.push_back({std::exchange(first, first + length), length});
    }
    for (const IndexRange& range : primitives) {
      fmt::format_to(std::back_inserter(accessors_),
                     R"(,{{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                     view_count_, buffer.index_bytes() * range.first, buffer.index_bytes() == 2 ? 5123 : 5125,
                     range.count);
      fmt::format_to(std::back_inserter(meshes_), R"({}{{"attributes":{{{}}},"indices":{},"mode":{}}})",
                     meshes_.empty() ? "" : ",", attributes_, accessor_count_++,
                     buffer.form == StripForm::list ? 4 : 5);
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
  GlbExtension extension_;
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

bool restarts(const IndexBuffer& buffer) {
  const auto has_restart = []<class Index>(const std::vector<Index>& all) {
    return std::find(all.begin(), all.end(), std::numeric_limits<Index>::max()) != all.end();
  };
  return buffer.form == StripForm::restart && std::visit(has_restart, buffer.indices);
}

std::string bounds_of(std::span<const Point> points) {
  Point low = points.front();
  Point high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto list = [](const Point& p) {
    return fmt::format("[{},{},{}]", static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  };
  return fmt::format(R"("min":{},"max":{})", list(low), list(high));
}

std::string glb_of_chunks(std::string json, std::string binary) {
  if (json.size() + binary.size() > most_glb_bytes)
    throw BadInput(fmt::format("a GLB holds {} bytes at most; write .ply or .bin", most_glb_bytes));
  std::string chunks;
  put_chunk(chunks, std::move(json), 0x4E4F534A, ' ');     // JSON
  put_chunk(chunks, std::move(binary), 0x004E4942, '\0');  // BIN
  std::string glb = "glTF";
  put(glb, 2);
  put(glb, static_cast<std::uint32_t>(12 + chunks.size()));
  return glb + chunks;
}

std::string glb_bytes(const StripFile& file, const GlbExtension& extension) { return GlbWriter(file, extension).run(); }

}  // namespace restrip::tools
