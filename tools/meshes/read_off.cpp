// Reads Object File Format (Geomview), as text: the keyword OFF, three counts, then vertices and faces. Letters before
// OFF give attributes and coordinates: C, N, ST: colours, normals, texture coordinates, which are left out; 4: a fourth
// coordinate, which must be 1; n: the dimension follows, which must be 3.
#include <fmt/format.h>

#include <vector>

#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

/// Most writers put each vertex or face on a separate line; further numbers on it, such as colours, are ignored. In
/// other files line breaks have no meaning, and every number is needed.
enum class Lines { one_each, free };

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& name) : name_(name), cursor_(bytes), soup_(name) {}

  Soup read() {
    read_keyword();
    const std::size_t vertices =
        glued_.empty() ? number<std::uint32_t>(counted_vertices) : read_number<std::uint32_t>(glued_, counted_vertices);
    const std::size_t faces = number<std::uint32_t>("the number of faces");
    if (!fits(vertices, faces, Lines::one_each) && fits(vertices, faces, Lines::free)) lines_ = Lines::free;
    // The number of edges may be missing.
    if (skip_rest_of_line() == 0 && lines_ == Lines::free) number<std::uint32_t>("the number of edges");
    // A number takes at least two bytes: refuses counts that the file cannot hold.
    if (vertices > cursor_.rest().size() / 6 + 1 || faces > cursor_.rest().size() / 2 + 1)
      throw BadInput(
          fmt::format("{}: announces {} vertices and {} faces, more than its {} bytes can hold; is the file complete?",
                      name_, vertices, faces, cursor_.rest().size()));
    for (std::size_t i = 0; i < vertices; ++i) read_vertex(i);
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < faces; ++i) {
      corners.clear();
      const auto size = number<std::uint32_t>("a number of corners");
      for (std::uint32_t corner = 0; corner < size; ++corner) corners.push_back(next_number<std::uint32_t>("a corner"));
      soup_.add_face(corners);
      if (skip_rest_of_line() != 0) soup_.leave_out("colours of faces");
    }
    if (!cursor_.word_on_any_line().empty()) soup_.leave_out("text after the last face");
    return std::move(soup_).finish();
  }

 private:
  static constexpr const char* counted_vertices = "the number of vertices";

  [[noreturn]] void refuse(const std::string& why) const {
    throw BadInput(fmt::format("{}:{}: {}", name_, cursor_.line(), why));
  }

  /// Reads the letters, the keyword and text joined to it. Without a keyword the file begins with its counts.
  void read_keyword() {
    glued_ = cursor_.word_on_any_line();
    if (parse<std::uint32_t>(glued_)) return;
    std::string_view word = glued_;
    bool has_dimension = false;
    const auto take = [&word](std::string_view letters) {
      const bool found = word.starts_with(letters);
      if (found) word.remove_prefix(letters.size());
      return found;
    };
    while (!take("OFF")) {
      if (take("ST"))
        left_out_.emplace_back("TEXCOORD_0");
      else if (take("C"))
        left_out_.emplace_back("COLOR_0");
      else if (take("N"))
        left_out_.emplace_back("NORMAL");
      else if (take("4"))
        has_weight_ = true;
      else if (take("n"))
        has_dimension = true;
      else
        throw BadInput(fmt::format(
            "{}: does not begin with OFF (before it C, N, ST, 4 or n) or with the number of its vertices", name_));
    }
    glued_ = word;
    if (cursor_.rest().starts_with(" BINARY"))
      throw BadInput(fmt::format("{}: binary OFF is not read; save it as text or as PLY", name_));
    if (!has_dimension) return;
    if (const auto dimension = number<std::uint32_t>("the dimension"); dimension != 3)
      refuse(fmt::format("points of {} dimensions; only 3 are read", dimension));
  }

  /// Whether the file has enough words from the counts to the end; for free lines, exactly enough.
  [[nodiscard]] bool fits(std::size_t vertices, std::size_t faces, Lines lines) const {
    TextCursor cursor = cursor_;
    const auto skip = [&](std::size_t words) {
      if (cursor.word_on_any_line().empty()) return false;
      for (; words > 1; --words)
        if ((lines == Lines::free ? cursor.word_on_any_line() : cursor.word()).empty()) return false;
      if (lines == Lines::one_each) cursor.next_line();
      return true;
    };
    std::size_t each = has_weight_ ? 4 : 3;
    for (const std::string& name : left_out_) each += lines == Lines::free ? values_of(name) : 0;
    if (lines == Lines::one_each)
      cursor.next_line();
    else if (!skip(1))
      return false;
    for (; vertices > 0; --vertices)
      if (!skip(each)) return false;
    for (; faces > 0; --faces) {
      TextCursor ahead = cursor;
      const auto corners = parse<std::uint32_t>(ahead.word_on_any_line());
      if (!corners || !skip(std::size_t{1} + *corners)) return false;
    }
    return lines == Lines::one_each || cursor.word_on_any_line().empty();
  }
  static std::size_t values_of(std::string_view attribute) {
    return attribute == "TEXCOORD_0" ? 2 : attribute == "NORMAL" ? 3 : 4;
  }

  void read_vertex(std::size_t i) {
    const auto x = number<double>("a coordinate");
    const std::size_t line = cursor_.line();
    const auto y = next_number<double>("a coordinate");
    const auto z = next_number<double>("a coordinate");
    soup_.add_point(x, y, z, line);
    if (has_weight_)
      if (const auto w = next_number<double>("a fourth coordinate"); w != 1)
        refuse(fmt::format("vertex {} has the fourth coordinate {}; only 1 is read", i, w));
    for (const std::string& name : left_out_)
      for (std::size_t n = lines_ == Lines::free ? values_of(name) : 0; n > 0; --n)
        number<double>("a value of a vertex");
    const std::size_t more = skip_rest_of_line();
    for (const std::string& name : left_out_) soup_.leave_out(name);
    if (more != 0 && left_out_.empty()) soup_.leave_out("COLOR_0");
  }

  /// The number of words left on the line, if lines have meaning.
  std::size_t skip_rest_of_line() {
    if (lines_ == Lines::free) return 0;
    std::size_t words = 0;
    while (!cursor_.word().empty()) ++words;
    cursor_.next_line();
    return words;
  }

  template <class Number>
  Number number(const char* what) {
    return read_number<Number>(cursor_.word_on_any_line(), what);
  }
  /// The next number of the same vertex or face.
  template <class Number>
  Number next_number(const char* what) {
    return read_number<Number>(lines_ == Lines::free ? cursor_.word_on_any_line() : cursor_.word(), what);
  }
  template <class Number>
  Number read_number(std::string_view word, const char* what) {
    if (word.empty() && cursor_.at_end())
      refuse(fmt::format("the file ends where {} should be; is it complete?", what));
    const auto parsed = parse<Number>(word);
    if (!parsed) refuse(fmt::format("expected {}, found '{}'", what, word.substr(0, 40)));
    return *parsed;
  }

  const std::string& name_;
  TextCursor cursor_;
  SoupBuilder soup_;
  Lines lines_ = Lines::one_each;
  std::string_view glued_;  // to the keyword
  std::vector<std::string> left_out_;
  bool has_weight_ = false;
};

}  // namespace

Soup read_off(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  return OffReader(bytes, name).read();
}

}  // namespace restrip::tools
