#include "model/json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

// Limits of docs/reference/operation-file.md.
constexpr std::size_t deepest = 8;
constexpr std::size_t most_members = 64;
constexpr std::size_t longest_member = 60;

/// Builds values from the events of nlohmann's parser. The parser reports tokens without positions, but it has consumed
/// everything before them. So the next token is the first character that is not a space, comma or colon.
class PlacedValues final : public nlohmann::json_sax<nlohmann::json> {
 public:
  PlacedValues(const std::string& file, std::string_view text) : file_(file), text_(text) {}
  Json whole() && { return std::move(whole_); }

  bool null() override { return add(Json::Kind::null, word()); }
  bool boolean(bool /*value*/) override { return add(Json::Kind::boolean, word()); }
  bool number_integer(number_integer_t value) override { return add(Json::Kind::integer, word(), value); }
  bool number_unsigned(number_unsigned_t value) override {
    const auto number = static_cast<std::int64_t>(value);
    return add(number < 0 ? Json::Kind::other_number : Json::Kind::integer, word(), number);
  }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override {
    return add(Json::Kind::other_number, word());
  }
  bool string(string_t& value) override {
    begin_token();
    end_string();
    return add(Json::Kind::string, value);
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(Json::Kind::object); }
  bool start_array(std::size_t /*size*/) override { return open(Json::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    begin_token();
    end_string();
    Json& object = *open_.back();
    for (const Json::Name& other : object.names)
      if (other.text == value)
        fail_at(file_, place_of(token_),
                fmt::format("expected each member once, \"{}\" is in line {} already", value, other.place.line));
    if (value.size() > longest_member)
      fail_at(file_, place_of(token_),
              fmt::format("expected names of members of at most {} bytes, found \"{}\"", longest_member, value));
    if (object.names.size() == most_members)
      fail_at(file_, place_of(token_), fmt::format("expected at most {} members of an object", most_members));
    object.names.push_back({value, place_of(token_)});
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*last*/,
                   const nlohmann::detail::exception& error) override {
    std::string_view what = error.what();
    for (const std::string_view before : {"column ", ": "})
      if (const std::size_t at = what.find(before); at != std::string_view::npos)
        what.remove_prefix(at + before.size());
    fail_at(file_, place_of(std::min(position == 0 ? 0 : position - 1, text_.size())),
            fmt::format("not JSON: {}", what));
  }

 private:
  /// Continues from the previous position, so that a file takes linear time.
  TextPlace place_of(std::size_t offset) {
    if (offset < placed_) placed_ = 0, place_ = {};
    for (const char c : text_.substr(placed_, offset - placed_)) {
      place_.column = c == '\n' ? 1 : place_.column + 1;
      place_.line += c == '\n' ? 1 : 0;
    }
    placed_ = offset;
    return place_;
  }

  void begin_token() {
    end_ = token_ = std::min(text_.find_first_not_of(" \t\r\n,:", end_), text_.size());
    ++end_;
  }
  void end_string() {
    while (text_.at(end_) != '"') end_ += text_[end_] == '\\' ? 2U : 1U;
    ++end_;
  }
  /// A number or a literal name.
  std::string word() {
    begin_token();
    end_ = std::min(text_.find_first_of(" \t\r\n,:]}", token_), text_.size());
    return std::string(text_.substr(token_, end_ - token_));
  }

  Json& next_value() { return open_.empty() ? whole_ : open_.back()->items.emplace_back(); }
  bool add(Json::Kind kind, std::string text, std::int64_t integer = 0) {
    Json& value = next_value();
    value.kind = kind;
    value.place = place_of(token_);
    value.integer = integer;
    value.text = std::move(text);
    return true;
  }
  /// Values are appended only to the innermost open one, so addresses stay valid.
  bool open(Json::Kind kind) {
    begin_token();
    if (open_.size() == deepest)
      fail_at(file_, place_of(token_),
              fmt::format("expected lists and objects at most {} deep inside one another", deepest));
    Json& value = next_value();
    value.kind = kind;
    value.place = place_of(token_);
    open_.push_back(&value);
    return true;
  }
  bool close() {
    begin_token();
    open_.pop_back();
    return true;
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t token_ = 0;   ///< start of the last token
  std::size_t end_ = 0;     ///< end of the last token
  std::size_t placed_ = 0;  ///< the offset of `place_`
  TextPlace place_;
  Json whole_;
  std::vector<Json*> open_;
};

}  // namespace

std::string Json::described() const {
  switch (kind) {
    case Kind::array:
      return "a list";
    case Kind::object:
      return "an object";
    case Kind::string:
      return fmt::format("\"{}\"", text);
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::other_number:
      break;
  }
  return text;
}

bool Json::same_as(const Json& other) const {
  const auto same_name = [](const Name& one, const Name& two) { return one.text == two.text; };
  const auto same = [](const Json& one, const Json& two) { return one.same_as(two); };
  return kind == other.kind && text == other.text && integer == other.integer &&
         std::equal(names.begin(), names.end(), other.names.begin(), other.names.end(), same_name) &&
         std::equal(items.begin(), items.end(), other.items.begin(), other.items.end(), same);
}

Json parse_json(const std::string& file, std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf"))  // the parser would skip it
    fail_at(file, {}, "expected no byte order mark before the file; save it as UTF-8 without one");
  PlacedValues values(file, text);
  if (!nlohmann::json::sax_parse(text, &values)) throw InputError(file, 0, "not JSON");
  return std::move(values).whole();
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 400;
  std::string shown;
  for (const char c : text.substr(0, longest))
    shown += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  if (text.size() > longest) shown += "...";
  return shown;
}

void fail_at(const std::string& file, TextPlace place, const std::string& what) {
  throw InputError(fmt::format("{}:{}", file, place.line), place.column, shown(what));
}

}  // namespace restrip::verify
