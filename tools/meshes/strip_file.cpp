#include "meshes/strip_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "meshes/little_endian.hpp"

namespace restrip::tools {

IndexBuffer format_as(const StripOptions& options, StripForm usual, std::span<const std::uint32_t> indices,
                      WrittenStrips& written) try {
  const StripForm form = options.form.value_or(usual);
  IndexBuffer buffer = format_strips(indices, {.form = form,
                                               .width = options.width,
                                               .list_if_shorter = !options.keep_strips,
                                               .most_vertices = options.most_vertices,
                                               .most_indices = options.most_indices});
  written.form = buffer.form;
  if (buffer.form != form) written.wanted = form;
  written.index_bits = 8 * buffer.index_bytes();
  written.indices = buffer.size();
  written.batches = buffer.batches.size();
  if (buffer.form != StripForm::list) written.strips = buffer.strips;
  return buffer;
} catch (const std::length_error&) {
  throw BadInput(
      fmt::format("{}the mesh has vertices above 65,534, which 16 bits cannot name; write --index auto or 32, or split "
                  "the mesh",
                  options.file.empty() ? "" : options.file + ": "));
}

std::string_view name_of(StripForm form) noexcept {
  switch (form) {
    case StripForm::restart:
      return "restart";
    case StripForm::stitched:
      return "stitched";
    case StripForm::lengths:
      return "lengths";
    case StripForm::list:
      break;
  }
  return "list";
}

std::string bin_bytes(const IndexBuffer& buffer, bool in_batches) {
  std::string bytes;
  if (in_batches) {
    put(bytes, static_cast<std::uint32_t>(buffer.batches.size()));
    for (const IndexRange& batch : buffer.batches) put(bytes, static_cast<std::uint32_t>(batch.count));
  }
  if (buffer.form == StripForm::lengths) {
    put(bytes, static_cast<std::uint32_t>(buffer.lengths.size()));
    for (const std::uint32_t length : buffer.lengths) put(bytes, length);
  }
  put(bytes, buffer);
  return bytes;
}

FileStrips color_as_in_file(StripMesh& mesh, const Soup& soup, std::span<const std::uint32_t> origin) {
  std::vector<Triangle> handle(soup.triangles.size(), none);
  for (std::size_t t = 0; t < origin.size(); ++t) handle[origin[t]] = static_cast<Triangle>(t);
  FileStrips done;
  std::size_t triangle = 0;  // of the soup, the next one that the strips draw
  Triangle before = none;
  std::size_t first = 0;
  bool begins = true;
  std::size_t degenerate_ones = 0;  // in a row: one repeats an index within a strip, more stitch two strips together
  for (std::size_t i = 0; i < soup.strips.size(); ++i) {
    if (soup.strips[i] == strip_end) {
      first = i + 1;
      begins = true;
      degenerate_ones = 0;
      continue;
    }
    if (i < first + 2) continue;
    if (degenerate({soup.strips[i - 2], soup.strips[i - 1], soup.strips[i]})) {
      ++degenerate_ones;
      continue;
    }
    while (degenerate(soup.triangles[triangle])) ++triangle;  // listed, but in no strip
    const Triangle now = handle[triangle++];
    if (!begins && degenerate_ones <= 1) {
      StripMesh::Halfedge shared;  // the dual edge to the triangle before
      for (unsigned side = 0; side < 3 && now != none && before != none && shared.id == none; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(before, side);
        const StripMesh::Halfedge back = mesh.opposite(h);
        if (!StripMesh::on_boundary(back) && StripMesh::triangle(back) == now) shared = h;
      }
      if (shared.id == none) {
        ++done.cut;
      } else {
        mesh.set_solid(shared, true);
        ++done.solid;
      }
    }
    begins = false;
    degenerate_ones = 0;
    before = now;
  }
  return done;
}

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

std::string glb_bytes(const StripFile& file, const GlbExtension& extension) {
  const IndexBuffer& buffer = file.buffer;
  if (buffer.empty()) throw BadInput("glTF has no mesh without triangles");
  std::size_t bytes = 12 * file.points.size() + buffer.bytes().size() + extension.bytes.size();
  for (const Attribute& attribute : file.attributes) bytes += file.points.size() * stride_of(attribute);
  if (bytes > most_glb_bytes)
    throw BadInput(fmt::format("a GLB holds {} bytes at most; write .ply or .bin", most_glb_bytes));
  std::string binary;
  binary.reserve(bytes);

  // The parts of the JSON refer to each other by number.
  std::string views;
  std::string accessors;
  std::size_t view_count = 0;
  std::size_t accessor_count = 0;
  enum class ViewOf { vertices, indices, other };
  // Adds the view of the bytes written since `begin`.
  const auto end_view = [&](std::size_t begin, ViewOf content, std::size_t stride) {
    views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{})", view_count == 0 ? "" : ",", begin,
                         binary.size() - begin);
    if (stride != 0) views += fmt::format(R"(,"byteStride":{})", stride);
    if (content != ViewOf::other) views += fmt::format(R"(,"target":{})", content == ViewOf::vertices ? 34962 : 34963);
    views += '}';
    ++view_count;
  };

  for (const Point& p : file.points) put(binary, p);
  end_view(0, ViewOf::vertices, 12);
  accessors += fmt::format(R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",{}}})", file.points.size(),
                           bounds_of(file.points));
  std::string attributes = fmt::format(R"("POSITION":{})", accessor_count++);  // of every primitive
  for (const Attribute& attribute : file.attributes) {
    const std::size_t begin = binary.size();
    const std::size_t size = attribute.value_bytes();
    for (std::size_t v = 0; v < file.points.size(); ++v) {
      binary.append(attribute.bytes, v * size, size);
      binary.append(stride_of(attribute) - size, '\0');
    }
    accessors += fmt::format(R"(,{{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", view_count,
                             static_cast<unsigned>(attribute.type), file.points.size(),
                             attribute.components == 1 ? "SCALAR" : fmt::format("VEC{}", attribute.components),
                             attribute.normalized ? R"(,"normalized":true)" : "");
    end_view(begin, ViewOf::vertices, stride_of(attribute));
    attributes += fmt::format(R"(,"{}":{})", attribute.name, accessor_count++);
  }

  const std::size_t first_index = binary.size();
  put(binary, buffer);
  std::vector<IndexRange> ranges = buffer.batches;
  if (buffer.form == StripForm::lengths) {
    ranges.clear();
    std::size_t first = 0;
    for (const std::uint32_t length : buffer.lengths) ranges.push_back({std::exchange(first, first + length), length});
  }
  std::string primitives;
  for (const IndexRange& range : ranges) {
    accessors +=
        fmt::format(R"(,{{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"SCALAR"}})", view_count,
                    buffer.index_bytes() * range.first, buffer.index_bytes() == 2 ? 5123 : 5125, range.count);
    primitives += fmt::format(R"({}{{"attributes":{{{}}},"indices":{},"mode":{}}})", primitives.empty() ? "" : ",",
                              attributes, accessor_count++, buffer.form == StripForm::list ? 4 : 5);
  }
  end_view(first_index, ViewOf::indices, 0);

  std::string json = R"({"asset":{"version":"2.0","generator":"restrip"},"scene":0,"scenes":[{"nodes":[0]}],)"
                     R"("nodes":[{"mesh":0}],)";
  std::vector<std::string_view> used;
  std::string extensions;  // of the mesh
  if (restarts(buffer)) {
    used.push_back(restart_extension);
    json += fmt::format(R"("extensionsRequired":["{}"],)", restart_extension);
  }
  if (!extension.name.empty()) {
    used.push_back(extension.name);
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t begin = binary.size();
    binary += extension.bytes;
    extensions = fmt::format(R"(,"extensions":{{"{}":{{"bufferView":{}}}}})", extension.name, view_count);
    end_view(begin, ViewOf::other, 0);
  }
  if (!used.empty()) json += fmt::format(R"("extensionsUsed":["{}"],)", fmt::join(used, R"(",")"));
  json += fmt::format(
      R"("meshes":[{{"primitives":[{}]{}}}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      primitives, extensions, accessors, views, binary.size());
  return glb_of_chunks(std::move(json), std::move(binary));
}

}  // namespace restrip::tools
