// Object File Format (Geomview), as text: the keyword OFF (with C, N, ST: colours, normals and texture coordinates,
// which follow the position on its line and are skipped), three counts, then a line for each vertex and each face.
#include <fmt/format.h>

#include <vector>

#include "common/bad_input.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& name) : name_(name), cursor_(bytes), soup_(name) {}

  Soup read() {
    std::string_view keyword = cursor_.word_on_any_line();
    if (keyword.starts_with("ST")) keyword.remove_prefix(2);
    if (keyword.starts_with("C")) keyword.remove_prefix(1);
    if (keyword.starts_with("N")) keyword.remove_prefix(1);
    if (keyword != "OFF")
      throw BadInput(fmt::format(
          "{}: does not begin with OFF, COFF, NOFF or STOFF; only these (three coordinates a vertex) are read", name_));
    if (cursor_.rest().starts_with(" BINARY"))
      throw BadInput(fmt::format("{}: binary OFF is not read; save it as text or as PLY", name_));

    const std::size_t vertices = count("the number of vertices");
    const std::size_t faces = count("the number of faces");
    // Two bytes a number at least: what cannot be there is not waited for.
    if (vertices > cursor_.rest().size() / 6 + 1 || faces > cursor_.rest().size() / 2 + 1)
      throw BadInput(
          fmt::format("{}: announces {} vertices and {} faces, more than its {} bytes can hold; is the file complete?",
                      name_, vertices, faces, cursor_.rest().size()));
    cursor_.next_line();
    for (std::size_t i = 0; i < vertices; ++i, cursor_.next_line()) {
      const double x = number<double>("a coordinate");
      const double y = next_number<double>("a coordinate");
      const double z = next_number<double>("a coordinate");
      soup_.add_point(x, y, z);
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < faces; ++i, cursor_.next_line()) {
      corners.clear();
      const auto size = number<std::uint32_t>("a number of corners");
      for (std::uint32_t corner = 0; corner < size; ++corner) corners.push_back(next_number<std::uint32_t>("a corner"));
      soup_.add_face(corners);
    }
    return std::move(soup_).finish();
  }

 private:
  std::size_t count(const char* what) { return number<std::uint32_t>(what); }

  template <class Number>
  Number number(const char* what) {
    return read_number<Number>(cursor_.word_on_any_line(), what);
  }
  template <class Number>
  Number next_number(const char* what) {
    return read_number<Number>(cursor_.word(), what);
  }
  template <class Number>
  Number read_number(std::string_view word, const char* what) {
    if (word.empty() && cursor_.at_end())
      throw BadInput(
          fmt::format("{}:{}: the file ends where {} should be; is it complete?", name_, cursor_.line(), what));
    const auto parsed = parse<Number>(word);
    if (!parsed)
      throw BadInput(fmt::format("{}:{}: expected {}, found '{}'", name_, cursor_.line(), what, word.substr(0, 40)));
    return *parsed;
  }

  const std::string& name_;
  TextCursor cursor_;
  SoupBuilder soup_;
};

}  // namespace

Soup read_off(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  return OffReader(bytes, name).read();
}

}  // namespace restrip::tools
