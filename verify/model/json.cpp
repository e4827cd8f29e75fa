#include "model/json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

constexpr std::size_t deepest = 8;  // an operation file has lists of edges in terms in criteria in the cost: six

TextPlace place_of(std::string_view text, std::size_t offset) {
  TextPlace place;
  for (const char c : text.substr(0, offset)) {
    place.column = c == '\n' ? 1 : place.column + 1;
    place.line += c == '\n' ? 1 : 0;
  }
  return place;
}

/// Puts values together as nlohmann's parser tells of them. It tells tokens without their places; but it has read all
/// that came before, so the next token is the first thing that is neither space, comma nor colon.
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
        fail_at(file_, place_of(text_, token_),
                fmt::format("expected each member once, \"{}\" is in line {} already", value, other.place.line));
    object.names.push_back({value, place_of(text_, token_)});
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*last*/,
                   const nlohmann::detail::exception& error) override {
    std::string_view what = error.what();
    for (const std::string_view before : {"column ", ": "})
      if (const std::size_t at = what.find(before); at != std::string_view::npos)
        what.remove_prefix(at + before.size());
    fail_at(file_, place_of(text_, std::min(position == 0 ? 0 : position - 1, text_.size())),
            fmt::format("not JSON: {}", what));
  }

 private:
  void begin_token() {
    end_ = token_ = std::min(text_.find_first_not_of(" \t\r\n,:", end_), text_.size());
    ++end_;
  }
  void end_string() {
    while (text_.at(end_) != '"') end_ += text_[end_] == '\\' ? 2U : 1U;
    ++end_;
  }
  /// A number, or a name of a value.
  std::string word() {
    begin_token();
    end_ = std::min(text_.find_first_of(" \t\r\n,:]}", token_), text_.size());
    return std::string(text_.substr(token_, end_ - token_));
  }

  Json& next_value() { return open_.empty() ? whole_ : open_.back()->items.emplace_back(); }
  bool add(Json::Kind kind, std::string text, std::int64_t integer = 0) {
    Json& value = next_value();
    value.kind = kind;
    value.place = place_of(text_, token_);
    value.integer = integer;
    value.text = std::move(text);
    return true;
  }
  /// Values below an open one are added to it alone, so that its address stays.
  bool open(Json::Kind kind) {
    begin_token();
    if (open_.size() > deepest)
      fail_at(file_, place_of(text_, token_), "expected fewer lists and objects inside one another");
    Json& value = next_value();
    value.kind = kind;
    value.place = place_of(text_, token_);
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
  std::size_t token_ = 0;  ///< where the last token begins
  std::size_t end_ = 0;    ///< and ends
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

Json parse_json(const std::string& file, std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf"))  // which the parser would skip
    fail_at(file, {}, "expected no byte order mark before the file; save it as UTF-8 without one");
  PlacedValues values(file, text);
  if (!nlohmann::json::sax_parse(text, &values)) throw InputError(file, 0, "not JSON");
  return std::move(values).whole();
}

std::string shown(std::string_view text) {
  std::string shown;
  for (const char c : text)
    shown += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return shown;
}

void fail_at(const std::string& file, TextPlace place, const std::string& what) {
  throw InputError(fmt::format("{}:{}", file, place.line), place.column, shown(what));
}

}  // namespace restrip::verify
