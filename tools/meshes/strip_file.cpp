#include "meshes/strip_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/bad_input.hpp"
#include "common/counted.hpp"
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

std::string as_text(const WrittenStrips& written, const std::string& name) {
  if (written.index_bits == 0) return {};
  std::string text = fmt::format("{}: {} of {} bits, {}", name, counted(written.indices, "index", "indices"),
                                 written.index_bits, name_of(written.form));
  if (written.batches > 1) text += fmt::format(", in {}", counted(written.batches, "batch", "batches"));
  if (written.wanted)
    text += fmt::format("; a list, because the form {} has more (--keep-strips writes it)", name_of(*written.wanted));
  text += '\n';
  if (!written.required_extensions.empty())
    text += fmt::format("{}: requires {}, a proposal that few viewers know; the others refuse the file\n", name,
                        fmt::join(written.required_extensions, ", "));
  return text;
}

void add_to(nlohmann::ordered_json& json, const WrittenStrips& written) {
  if (written.index_bits == 0) return;
  json["file"] = {{"form", name_of(written.form)},
                  {"index_bits", written.index_bits},
                  {"indices", written.indices},
                  {"batches", written.batches}};
  if (written.wanted) json["file"]["list_in_place_of"] = name_of(*written.wanted);
  if (!written.required_extensions.empty()) json["required_extensions"] = written.required_extensions;
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

}  // namespace restrip::tools
