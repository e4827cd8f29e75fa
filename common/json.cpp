#include "common/json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/printable.hpp"

namespace restrip {

/// A value. Texts, names and tokens are ranges of JsonFile::text, elements and members one range of JsonFile::nodes.
struct JsonNode {
  enum class Kind : std::uint8_t { word, integer, real, text, list, object };
  struct Range {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
  };

  double number = 0;         ///< of a number; an integer is at most 2^53
  std::uint32_t offset = 0;  ///< of its token
  Range content;             ///< of a text; the elements or members; otherwise the token
  Range name;                ///< of a member
  Kind kind = Kind::word;
};

struct JsonFile {
  std::string name;
  JsonLimits limits;
  std::size_t size = 0;  ///< in bytes
  std::string text;      ///< the file, then the content of texts with escapes
  std::vector<JsonNode> nodes;

  [[nodiscard]] std::string_view of(JsonNode::Range range) const {
    return std::string_view(text).substr(range.begin, range.size);
  }
  /// The place of a member: of its name, unless that has escapes.
  [[nodiscard]] std::size_t place_of(const JsonNode& member) const {
    return member.name.begin < size ? member.name.begin - 1 : member.offset;
  }
};

namespace {

using Kind = JsonNode::Kind;

constexpr double exact_integers = 9007199254740992;  // 2^53

struct LineAndColumn {
  std::size_t line = 1;
  std::size_t column = 1;
};

LineAndColumn line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.rfind('\n') + 1;  // also if there is none
  return {static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1, offset - line_begin + 1};
}

/// The beginning of errors about an offset.
std::string location(const JsonFile& file, std::size_t offset) {
  if (!file.limits.has_lines) return fmt::format("{}: byte {} of its JSON: ", file.name, offset);
  const LineAndColumn place = line_and_column(file.text, offset);
  return fmt::format("{}:{}:{}: ", file.name, place.line, place.column);
}

[[noreturn]] void refuse_at(const JsonFile& file, std::size_t offset, const std::string& what) {
  throw files::FileError(location(file, offset) + files::printable_ascii(what));
}

/// Builds the tree from the events of nlohmann's parser. The parser reports tokens without places, but it has read
/// everything before them. So the next token is the first character that is not a space, comma or colon. The elements
/// of an open list or object wait in `pending_`, so that they become one range when it is closed.
class JsonBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// `text`: the text of the file before any is appended.
  JsonBuilder(JsonFile& file, std::string_view text) : file_(file), text_(text) {
    if (text.starts_with(byte_order_mark)) end_ = byte_order_mark.size();  // the parser skips it
    if (file.limits.strict && end_ != 0)
      refuse(0, "expected no byte order mark before the file; save it as UTF-8 without one");
  }

  bool null() override { return add_word(Kind::word, 0); }
  bool boolean(bool /*value*/) override { return add_word(Kind::word, 0); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add_word(Kind::real, value); }
  bool number_integer(number_integer_t value) override { return add_integer(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_integer(static_cast<double>(value)); }
  bool string(string_t& value) override {
    const JsonNode::Range content = text_token(value);
    add(Kind::text, token_, content);
    return true;
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(Kind::object); }
  bool start_array(std::size_t /*size*/) override { return open(Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    next_name_ = text_token(name);
    if (name.size() > file_.limits.longest_member)
      refuse(token_, fmt::format("expected names of members of at most {} bytes, found \"{}\"",
                                 file_.limits.longest_member, name));
    const std::span<const JsonNode> members = std::span(pending_).subspan(open_.back().first);
    if (members.size() == file_.limits.most_members)
      refuse(token_, fmt::format("expected at most {} members of an object", file_.limits.most_members));
    if (!file_.limits.strict) return true;
    // Otherwise the last of two members of one name would silently win.
    for (const JsonNode& other : members)
      if (file_.of(other.name) == name)
        refuse(token_, fmt::format("expected each member once, \"{}\" is in line {} already", name,
                                   line_and_column(text_, file_.place_of(other)).line));
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

  /// Ends the tree; the last node is the whole.
  void finish() { file_.nodes.push_back(pending_.at(0)); }

 private:
  struct Open {
    Kind kind;
    std::size_t offset;
    std::size_t first;  ///< of its elements in `pending_`
    JsonNode::Range name;
  };
  static constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

  [[noreturn]] void refuse(std::size_t offset, const std::string& what) const { refuse_at(file_, offset, what); }

  void begin_token() {
    const auto is_between = [](char c) {
      return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == ':';
    };
    while (end_ < text_.size() && is_between(text_[end_])) ++end_;
    token_ = end_++;
  }
  /// Passes a text; returns its content.
  JsonNode::Range text_token(std::string_view value) {
    begin_token();
    while (text_.at(end_) != '"') end_ += text_[end_] == '\\' ? 2U : 1U;
    const std::size_t begin = token_ + 1;
    const bool has_escapes = end_++ - begin != value.size();  // each makes it shorter
    const std::size_t kept = has_escapes ? file_.text.size() : begin;
    if (has_escapes) file_.text += value;
    return {static_cast<std::uint32_t>(kept), static_cast<std::uint32_t>(value.size())};
  }

  void add(Kind kind, std::size_t offset, JsonNode::Range content, double number = 0) {
    if (++count_ > file_.limits.most_values)
      refuse(offset, fmt::format("more than {} values, the limit; keep numbers in a buffer", file_.limits.most_values));
    pending_.push_back(
        {number, static_cast<std::uint32_t>(offset), content, std::exchange(next_name_, JsonNode::Range{}), kind});
  }
  bool add_word(Kind kind, double number) {
    begin_token();
    const auto ends = [](char c) {
      return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == ']' || c == '}';
    };
    while (end_ < text_.size() && !ends(text_[end_])) ++end_;
    add(kind, token_, {static_cast<std::uint32_t>(token_), static_cast<std::uint32_t>(end_ - token_)}, number);
    return true;
  }
  bool add_integer(double number) {
    return add_word(std::abs(number) <= exact_integers ? Kind::integer : Kind::real, number);
  }
  bool open(Kind kind) {
    begin_token();
    if (open_.size() == file_.limits.deepest)
      refuse(token_, fmt::format("expected lists and objects at most {} deep inside one another", open_.size()));
    open_.push_back({kind, token_, pending_.size(), std::exchange(next_name_, JsonNode::Range{})});
    return true;
  }
  bool close() {
    begin_token();
    const Open whole = open_.back();
    open_.pop_back();
    const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(whole.first);
    if (whole.kind == Kind::object && !file_.limits.strict)
      std::stable_sort(first, pending_.end(),
                       [this](const JsonNode& a, const JsonNode& b) { return file_.of(a.name) < file_.of(b.name); });
    const JsonNode::Range items{static_cast<std::uint32_t>(file_.nodes.size()),
                                static_cast<std::uint32_t>(pending_.end() - first)};
    file_.nodes.insert(file_.nodes.end(), first, pending_.end());
    pending_.erase(first, pending_.end());
    if (pending_.size() < pending_.capacity() / 4) pending_.shrink_to_fit();
    next_name_ = whole.name;
    add(whole.kind, whole.offset, items);
    return true;
  }

  JsonFile& file_;
  std::string_view text_;
  std::size_t token_ = 0;  ///< start of the last token
  std::size_t end_ = 0;    ///< end of the last token
  std::size_t count_ = 0;
  JsonNode::Range next_name_;
  std::vector<JsonNode> pending_;
  std::vector<Open> open_;
};

std::span<const JsonNode> items_of(const JsonFile& file, const JsonNode& node) {
  if (node.kind != Kind::list && node.kind != Kind::object) return {};
  return std::span(file.nodes).subspan(node.content.begin, node.content.size);
}

bool same(const JsonFile& one_file, const JsonNode& one, const JsonFile& other_file, const JsonNode& other) {
  if (one.kind != other.kind) return false;
  if (one.kind != Kind::list && one.kind != Kind::object)
    return one_file.of(one.content) == other_file.of(other.content);
  const auto some = items_of(one_file, one);
  const auto others = items_of(other_file, other);
  return std::equal(some.begin(), some.end(), others.begin(), others.end(), [&](const JsonNode& a, const JsonNode& b) {
    return one_file.of(a.name) == other_file.of(b.name) && same(one_file, a, other_file, b);
  });
}

std::string described(const JsonFile& file, const JsonNode& node) {
  if (node.kind == Kind::list) return fmt::format("a list of {}", node.content.size);
  if (node.kind == Kind::object) return "an object";
  const std::string_view content = file.of(node.content).substr(0, 400);
  return node.kind == Kind::text ? fmt::format("\"{}\"", content) : std::string(content);
}

std::string path_to(const std::string& path, std::string_view member) {
  return path.empty() ? std::string(member) : fmt::format("{}.{}", path, member);
}

}  // namespace

JsonValue parse_json(const std::string& file, std::string_view text, const JsonLimits& limits) {
  const auto parsed = std::make_shared<JsonFile>();
  parsed->name = file;
  parsed->limits = limits;
  // Escapes make texts shorter, so all of them together have at most the size of the file.
  if (text.size() > std::numeric_limits<std::uint32_t>::max() / 2)
    refuse_at(*parsed, 0, "expected at most 2 GiB of JSON; keep numbers in a buffer");
  parsed->text = text;
  // The parser would take a zero byte for the end.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    if (limits.has_lines || text.find_first_not_of('\0', zero) != std::string_view::npos)
      refuse_at(*parsed, zero, "not JSON: a zero byte");
    text = text.substr(0, zero);
  }
  parsed->size = text.size();
  JsonBuilder builder(*parsed, text);
  if (!nlohmann::json::sax_parse(text, &builder)) refuse_at(*parsed, 0, "not JSON");
  builder.finish();
  return {parsed, parsed->nodes.back(), {}};
}

std::string JsonValue::where() const {
  return location(*file_, node_->offset) + files::printable_ascii(path_) + (path_.empty() ? "" : ": ");
}

const std::string& JsonValue::file() const { return file_->name; }

void JsonValue::refuse(const std::string& what) const {
  refuse_at(*file_, node().offset, path_.empty() ? what : fmt::format("{}: {}", path_, what));
}

void JsonValue::expected(const std::string& what) const {
  refuse(fmt::format("expected {}, found {}", what, described(*file_, node())));
}

const JsonNode& JsonValue::node() const {
  if (!there_)
    refuse_at(*file_, node_->offset,
              fmt::format("{}{}expected a member \"{}\"", path_, path_.empty() ? "" : ": ", missing_));
  return *node_;
}

std::span<const JsonNode> JsonValue::items() const { return items_of(*file_, node()); }
bool JsonValue::operator==(const JsonValue& other) const { return same(*file_, node(), *other.file_, other.node()); }
bool JsonValue::is_text() const { return node().kind == Kind::text; }
bool JsonValue::is_list() const { return node().kind == Kind::list; }

const JsonNode* JsonValue::find(std::string_view name) const {
  if (node().kind != Kind::object) return nullptr;
  const std::span<const JsonNode> all = items();
  if (file_->limits.strict) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const JsonNode& item) { return file_->of(item.name) == name; });
    return found == all.end() ? nullptr : &*found;
  }
  const auto after =
      std::upper_bound(all.begin(), all.end(), name,
                       [this](std::string_view wanted, const JsonNode& item) { return wanted < file_->of(item.name); });
  return after == all.begin() || file_->of(after[-1].name) != name ? nullptr : &after[-1];
}

JsonValue JsonValue::operator[](std::string_view name) const {
  const JsonNode* const found = there_ ? find(name) : nullptr;
  if (found != nullptr) return {file_, *found, path_to(path_, name)};
  JsonValue missing = *this;
  missing.there_ = false;
  missing.missing_ = path_to(missing_, name);
  return missing;
}

bool JsonValue::has(std::string_view name) const { return find(name) != nullptr; }

std::optional<JsonValue> JsonValue::member(std::string_view name) const {
  return has(name) ? std::optional((*this)[name]) : std::nullopt;
}

std::vector<std::string> JsonValue::members() const {
  std::vector<std::string> names;
  if (!there_) return names;
  if (node_->kind != Kind::object) expected("an object");
  for (const JsonNode& item : items()) names.emplace_back(file_->of(item.name));
  return names;
}

void JsonValue::expect_members(std::initializer_list<std::string_view> known) const {
  if (node().kind != Kind::object) expected("an object");
  for (const JsonNode& item : items())
    if (const std::string_view name = file_->of(item.name); std::find(known.begin(), known.end(), name) == known.end())
      refuse_at(*file_, file_->place_of(item),
                fmt::format("{}: unknown member, expected {}", path_to(path_, name), fmt::join(known, ", ")));
}

std::size_t JsonValue::size() const {
  if (!there_) return 0;
  if (!is_list()) expected("a list");
  return items().size();
}

JsonValue JsonValue::at(std::uint64_t index) const {
  if (index >= size()) refuse(fmt::format("has no element {}, only {}", index, size()));
  return {file_, items()[static_cast<std::size_t>(index)], fmt::format("{}[{}]", path_, index)};
}

std::vector<JsonValue> JsonValue::elements(std::string_view what, std::size_t least, std::size_t most) const {
  const std::size_t size = items().size();
  if (!is_list() || size < least || size > most) {
    const std::string sizes = least == 0      ? fmt::format("at most {}", most)
                              : least == most ? fmt::format("{}", most)
                                              : fmt::format("{} to {}", least, most);
    expected(fmt::format("a list of {} {}", sizes, what));
  }
  std::vector<JsonValue> values;
  values.reserve(size);
  while (values.size() < size) values.push_back(at(values.size()));
  return values;
}

std::string_view JsonValue::view(const std::string& what) const {
  if (!is_text()) expected(what);
  return file_->of(node_->content);
}

bool JsonValue::truth() const {
  const std::string_view word = node().kind == Kind::word ? file_->of(node_->content) : "";
  if (word != "true" && word != "false") expected("true or false");
  return word == "true";
}

std::size_t JsonValue::one_of(std::span<const std::string_view> texts) const {
  const auto found = is_text() ? std::find(texts.begin(), texts.end(), view()) : texts.end();
  if (found == texts.end())
    expected(fmt::format("\"{}\" or \"{}\"", fmt::join(texts.first(texts.size() - 1), "\", \""), texts.back()));
  return static_cast<std::size_t>(found - texts.begin());
}

std::int64_t JsonValue::number(std::int64_t least, std::int64_t most, std::string_view what) const {
  if (node().kind != Kind::integer || node_->number < static_cast<double>(least) ||
      node_->number > static_cast<double>(most))
    expected(least == most ? fmt::format("{}, {}", least, what) : fmt::format("{} from {} to {}", what, least, most));
  return static_cast<std::int64_t>(node_->number);
}

double JsonValue::real() const {
  if (node().kind != Kind::integer && node_->kind != Kind::real) expected("a number");
  return node_->number;
}

std::uint64_t JsonValue::whole() const {
  const double value = real();
  if (!(value >= 0) || value >= exact_integers || value != std::floor(value))
    expected("a whole number that is not too large");
  return static_cast<std::uint64_t>(value);
}

unsigned JsonValue::place(std::size_t count, std::string_view what) const {
  if (node().kind != Kind::integer || node_->number < 0 || node_->number >= static_cast<double>(count))
    expected(fmt::format("one of the {}s 0 to {}", what, count - 1));
  return static_cast<unsigned>(node_->number);
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
