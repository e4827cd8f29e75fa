// Wavefront OBJ: `v x y z` and `f c c c …`, a corner being v, v/vt, v//vn or v/vt/vn, counted from 1, or from the
// end when negative. What vt and vn say is
// left out and told; all other lines are no business of ours.
#include <fmt/format.h>

#include <vector>

#include "common/bad_input.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {

Soup read_obj(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  SoupBuilder soup(name);
  std::vector<std::uint32_t> corners;
  const auto coordinate = [&](TextCursor& cursor) {
    const std::string_view word = cursor.word();
    const auto number = parse<double>(word);
    if (!number)
      throw BadInput(
          fmt::format("{}:{}: a vertex needs three numbers, found '{}'", name, cursor.line(), word.substr(0, 40)));
    return *number;
  };
  for (TextCursor cursor(bytes); !cursor.at_end(); cursor.next_line()) {
    const std::string_view keyword = cursor.word();
    if (keyword == "v") {
      const double x = coordinate(cursor);
      const double y = coordinate(cursor);
      const double z = coordinate(cursor);
      soup.add_point(x, y, z);
    } else if (keyword == "vt" || keyword == "vn") {
      soup.leave_out(keyword == "vt" ? "TEXCOORD_0" : "NORMAL");
    } else if (keyword == "f" || keyword == "fo") {
      corners.clear();
      for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
        const auto index = parse<long long>(word.substr(0, word.find('/')));
        const long long vertex = !index       ? -1
                                 : *index > 0 ? *index - 1
                                              : static_cast<long long>(soup.point_count()) + *index;
        if (!index || *index == 0 || vertex < 0 || vertex > static_cast<long long>(max_vertices))
          throw BadInput(fmt::format("{}:{}: '{}' is no vertex of the {} before this face; corners are counted from 1",
                                     name, cursor.line(), word.substr(0, 40), soup.point_count()));
        corners.push_back(static_cast<std::uint32_t>(vertex));
      }
      soup.add_face(corners);
    }
  }
  return std::move(soup).finish();
}

}  // namespace restrip::tools
