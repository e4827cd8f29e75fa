#include "common/json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/file_error.hpp"
#include "common/printable.hpp"

namespace restrip {

struct JsonNode {
  enum class Kind { word, integer, text, list, object };
  struct Place {
    unsigned line = 1;
    unsigned column = 1;
  };

  Kind kind = Kind::word;  ///< or a number that is not an integer
  Place place;
  std::int64_t integer = 0;
  std::string text;             ///< the content of a text; otherwise as in the file
  std::vector<JsonNode> items;  ///< of a list or an object
  std::string name;             ///< of a member
  Place name_place;
};

struct JsonFile {
  std::string name;
  JsonNode whole;
};

namespace {

// Limits of docs/reference/operation-file.md. Without them the paths of a small file would take gigabytes.
constexpr std::size_t deepest = 8;
constexpr std::size_t most_members = 64;
constexpr std::size_t longest_member = 60;

[[noreturn]] void refuse_at(const std::string& file, JsonNode::Place place, const std::string& what) {
  throw files::FileError(fmt::format("{}:{}:{}: {}", file, place.line, place.column, files::printable_ascii(what)));
}

/// Builds the tree from the events of nlohmann's parser. The parser reports tokens without places, but it has read
/// everything before them. So the next token is the first character that is not a space, comma or colon.
class JsonBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonBuilder(JsonFile& file, std::string_view text) : file_(file), text_(text) {}

  bool null() override { return add_word(JsonNode::Kind::word); }
  bool boolean(bool /*value*/) override { return add_word(JsonNode::Kind::word); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override {
    return add_word(JsonNode::Kind::word);
  }
  bool number_integer(number_integer_t value) override { return add_word(JsonNode::Kind::integer, value); }
  bool number_unsigned(number_unsigned_t value) override {
    const auto number = static_cast<std::int64_t>(value);
    return add_word(number < 0 ? JsonNode::Kind::word : JsonNode::Kind::integer, number);
  }
  bool string(string_t& value) override {
    begin_token();
    end_string();
    add(JsonNode::Kind::text).text = std::move(value);
    return true;
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(JsonNode::Kind::object); }
  bool start_array(std::size_t /*size*/) override { return open(JsonNode::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    begin_token();
    end_string();
    std::vector<JsonNode>& members = open_.back()->items;
    // Otherwise the last of two members of one name would silently win.
    for (const JsonNode& other : members)
      if (other.name == name)
        refuse(token_,
               fmt::format("expected each member once, \"{}\" is in line {} already", name, other.name_place.line));
    if (name.size() > longest_member)
      refuse(token_, fmt::format("expected names of members of at most {} bytes, found \"{}\"", longest_member, name));
    if (members.size() == most_members)
      refuse(token_, fmt::format("expected at most {} members of an object", most_members));
    JsonNode& member = members.emplace_back();
    member.name = std::move(name);
    member.name_place = place_of(token_);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*last*/,
                   const nlohmann::detail::exception& error) override {
    std::string_view what = error.what();
    for (const std::string_view before : {"column ", ": "})
      if (const std::size_t at = what.find(before); at != std::string_view::npos)
        what.remove_prefix(at + before.size());
    refuse(std::min(position == 0 ? 0 : position - 1, text_.size()), fmt::format("not JSON: {}", what));
  }

 private:
  [[noreturn]] void refuse(std::size_t offset, const std::string& what) {
    refuse_at(file_.name, place_of(offset), what);
  }

  /// Continues from the previous offset, so that a file takes linear time.
  JsonNode::Place place_of(std::size_t offset) {
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

  /// A new element of the innermost open list, or the last member of the innermost open object. Only the innermost one
  /// grows, so addresses stay valid.
  JsonNode& add(JsonNode::Kind kind) {
    JsonNode* outer = open_.empty() ? nullptr : open_.back();
    if (outer != nullptr && outer->kind == JsonNode::Kind::list) outer->items.emplace_back();
    JsonNode& node = outer == nullptr ? file_.whole : outer->items.back();
    node.kind = kind;
    node.place = place_of(token_);
    return node;
  }
  bool add_word(JsonNode::Kind kind, std::int64_t integer = 0) {
    begin_token();
    end_ = std::min(text_.find_first_of(" \t\r\n,:]}", token_), text_.size());
    JsonNode& node = add(kind);
    node.integer = integer;
    node.text = text_.substr(token_, end_ - token_);
    return true;
  }
  bool open(JsonNode::Kind kind) {
    begin_token();
    if (open_.size() == deepest)
      refuse(token_, fmt::format("expected lists and objects at most {} deep inside one another", deepest));
    open_.push_back(&add(kind));
    return true;
  }
  bool close() {
    begin_token();
    open_.pop_back();
    return true;
  }

  JsonFile& file_;
  std::string_view text_;
  std::size_t token_ = 0;   ///< start of the last token
  std::size_t end_ = 0;     ///< end of the last token
  std::size_t placed_ = 0;  ///< the offset of `place_`
  JsonNode::Place place_;
  std::vector<JsonNode*> open_;
};

bool same(const JsonNode& one, const JsonNode& other) {
  return one.kind == other.kind && one.text == other.text &&
         std::equal(one.items.begin(), one.items.end(), other.items.begin(), other.items.end(),
                    [](const JsonNode& a, const JsonNode& b) { return a.name == b.name && same(a, b); });
}

std::string described(const JsonNode& node) {
  if (node.kind == JsonNode::Kind::list) return fmt::format("a list of {}", node.items.size());
  if (node.kind == JsonNode::Kind::object) return "an object";
  return node.kind == JsonNode::Kind::text ? fmt::format("\"{}\"", node.text) : node.text;
}

}  // namespace

JsonValue parse_json(const std::string& file, std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf"))  // the parser would skip it
    refuse_at(file, {}, "expected no byte order mark before the file; save it as UTF-8 without one");
  const auto parsed = std::make_shared<JsonFile>(JsonFile{file, {}});
  JsonBuilder builder(*parsed, text);
  if (!nlohmann::json::sax_parse(text, &builder)) refuse_at(file, {}, "not JSON");
  return {parsed, parsed->whole, {}};
}

JsonValue::JsonValue(std::shared_ptr<const JsonFile> file, const JsonNode& node, std::string path)
    : file_(std::move(file)), node_(&node), path_(std::move(path)) {}

std::string JsonValue::path_to(std::string_view member) const {
  return path_.empty() ? std::string(member) : fmt::format("{}.{}", path_, member);
}

std::string JsonValue::where() const {
  return fmt::format("{}:{}:{}: {}{}", file_->name, node_->place.line, node_->place.column,
                     files::printable_ascii(path_), path_.empty() ? "" : ": ");
}

const std::string& JsonValue::file() const { return file_->name; }

void JsonValue::refuse(const std::string& what) const {
  refuse_at(file_->name, node_->place, path_.empty() ? what : fmt::format("{}: {}", path_, what));
}

void JsonValue::expected(const std::string& what) const {
  refuse(fmt::format("expected {}, found {}", what, described(*node_)));
}

bool JsonValue::operator==(const JsonValue& other) const { return same(*node_, *other.node_); }
bool JsonValue::is_text() const { return node_->kind == JsonNode::Kind::text; }
bool JsonValue::is_list() const { return node_->kind == JsonNode::Kind::list; }

std::optional<JsonValue> JsonValue::member(std::string_view name) const {
  if (node_->kind == JsonNode::Kind::object)
    for (const JsonNode& item : node_->items)
      if (item.name == name) return JsonValue(file_, item, path_to(name));
  return {};
}

bool JsonValue::has(std::string_view name) const { return member(name).has_value(); }

JsonValue JsonValue::operator[](std::string_view name) const {
  if (std::optional<JsonValue> found = member(name)) return *std::move(found);
  refuse(fmt::format("expected a member \"{}\"", name));
}

std::vector<std::string> JsonValue::members() const {
  std::vector<std::string> names;
  for (const JsonNode& item : node_->items) names.push_back(item.name);
  return names;
}

void JsonValue::expect_members(std::initializer_list<std::string_view> known) const {
  if (node_->kind != JsonNode::Kind::object) expected("an object");
  for (const JsonNode& item : node_->items)
    if (std::find(known.begin(), known.end(), item.name) == known.end())
      refuse_at(file_->name, item.name_place,
                fmt::format("{}: unknown member, expected {}", path_to(item.name), fmt::join(known, ", ")));
}

std::vector<JsonValue> JsonValue::elements(std::string_view what, std::size_t least, std::size_t most) const {
  const std::size_t size = node_->items.size();
  if (!is_list() || size < least || size > most) {
    const std::string sizes = least == 0      ? fmt::format("at most {}", most)
                              : least == most ? fmt::format("{}", most)
                                              : fmt::format("{} to {}", least, most);
    expected(fmt::format("a list of {} {}", sizes, what));
  }
  std::vector<JsonValue> values;
  values.reserve(size);
  for (const JsonNode& item : node_->items)
    values.push_back({file_, item, fmt::format("{}[{}]", path_, values.size())});
  return values;
}

std::string JsonValue::text(const std::string& what) const {
  if (!is_text()) expected(what);
  return node_->text;
}

bool JsonValue::truth() const {
  const bool is_true = node_->kind == JsonNode::Kind::word && node_->text == "true";
  if (!is_true && (node_->kind != JsonNode::Kind::word || node_->text != "false")) expected("true or false");
  return is_true;
}

std::size_t JsonValue::one_of(std::span<const std::string_view> texts) const {
  const auto found = is_text() ? std::find(texts.begin(), texts.end(), node_->text) : texts.end();
  if (found == texts.end())
    expected(fmt::format("\"{}\" or \"{}\"", fmt::join(texts.first(texts.size() - 1), "\", \""), texts.back()));
  return static_cast<std::size_t>(found - texts.begin());
}

std::int64_t JsonValue::number(std::int64_t least, std::int64_t most, std::string_view what) const {
  if (node_->kind != JsonNode::Kind::integer || node_->integer < least || node_->integer > most)
    expected(least == most ? fmt::format("{}, {}", least, what) : fmt::format("{} from {} to {}", what, least, most));
  return node_->integer;
}

unsigned JsonValue::place(std::size_t count, std::string_view what) const {
  const auto end = static_cast<std::int64_t>(count);
  if (node_->kind != JsonNode::Kind::integer || node_->integer < 0 || node_->integer >= end)
    expected(fmt::format("one of the {}s 0 to {}", what, end - 1));
  return static_cast<unsigned>(node_->integer);
}

std::vector<unsigned> JsonValue::places(std::size_t count, std::string_view what) const {
  std::vector<unsigned> all;
  for (const JsonValue& value : elements(fmt::format("{}s", what), 0, count)) {
    const unsigned place = value.place(count, what);
    if (std::find(all.begin(), all.end(), place) != all.end())
      value.refuse(fmt::format("expected each {} once, {} is listed above", what, place));
    all.push_back(place);
  }
  return all;
}

}  // namespace restrip
