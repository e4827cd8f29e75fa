// Prints a table dump as Coq files, one Tables_FAMILY.v for each family.
//
//   print_tables DIRECTORY < dump
//
// The dump is text (docs/certificate.md, "Table dump"): `restrip-table-dump 4`, then for each table its header and one
// line `before ports after kept strips isolated` for each configuration, ascending by (before, ports), masks
// hexadecimal, changes decimal, `before ports -` for no answer; at last `end N`, N the number of configuration lines.
// Only the flip keeps other ports than there were; the mask of its answer is after | kept << 1. A table of linked rules
// has a line `ports (recolouring partners)+` for each port mask.
//
// A table becomes the list of the nodes of a binary trie, equal subtrees once; Table.v says how they are read, and
// Linked.v how the lists of linked rules are. What the answers tell becomes a trie as well, in Told_FAMILY.v, which
// Told.v reads. At the end of a file stands the function from positions, lists of numbers such as [8; 3], to the
// family's tables. Printed to the standard output: each family, how many positions it
// has, and how many answers (of linked rules: lists). Anything unexpected ends the program with a message and exit
// code 1.
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "print_tables: " << what << '\n';
  std::exit(1);
}

// What a header says: the family, the position, and how many bits each mask has.
struct Header {
  std::string family;
  std::vector<unsigned> position;
  unsigned ports = 0;
  unsigned before = 0;
  unsigned after = 0;

  bool linked() const { return family.rfind("linked_", 0) == 0; }
  std::string joined_by(const std::string& separator) const {
    std::string text;
    for (const unsigned n : position) text += (text.empty() ? "" : separator) + std::to_string(n);
    return text;
  }
};

Header read_header(const std::string& line) {
  std::istringstream words(line);
  std::string table, family, word;
  words >> table >> family;
  Header header;
  header.family = family;
  for (char& c : header.family) c = c == '-' ? '_' : c;
  if (line == "table flip") {
    header.ports = 4;
    header.before = 1;
    header.after = 5;
    return header;
  }
  while (words >> word)
    if (word != "k" && word != "a" && word != "gap" && word != "gaps")
      header.position.push_back(static_cast<unsigned>(std::stoul(word)));
  if (table != "table" || header.position.empty()) fail("no header: " + line);
  const unsigned k = header.ports = header.position[0];
  if (k < 1 || k > 12) fail("valence out of range: " + line);
  const std::map<std::string, std::array<unsigned, 2>> bits = {
      {"split", {k, k + 3}},          {"collapse", {k + 3, k}},
      {"open-split", {k - 1, k + 2}}, {"open-collapse", {k + 2, k - 1}},
      {"boundary-split", {k - 1, k}}, {"boundary-collapse", {k, k - 1}},
      {"linked-split", {0, k + 3}},   {"linked-collapse", {0, k}},
  };
  const auto found = bits.find(family);
  if (found == bits.end()) fail("unknown family: " + line);
  header.before = found->second[0];
  header.after = found->second[1];
  return header;
}

constexpr long no_leaf = -1;

// A fork of two nodes, by number; or a leaf: no_leaf and the mask.
using Node = std::array<long, 2>;

std::string hexadecimal(std::size_t number, int digits) {
  std::string text;
  for (int shift = 4 * digits - 4; shift >= 0; shift -= 4) text += "0123456789abcdef"[number >> shift & 15];
  return text;
}

// The words of a line of masks.
class Masks {
 public:
  explicit Masks(const std::string& line) : line_(line) {}

  std::size_t next() {
    begin_word();
    const char* const begin = line_.data() + at_;
    std::size_t mask = 0;
    const auto [stop, error] = std::from_chars(begin, line_.data() + line_.size(), mask, 16);
    if (error != std::errc{}) fail("bad line: " + line_);
    at_ += static_cast<std::size_t>(stop - begin);
    return mask;
  }
  // A decimal number, perhaps negative.
  int change() {
    begin_word();
    const char* const begin = line_.data() + at_;
    int number = 0;
    const auto [stop, error] = std::from_chars(begin, line_.data() + line_.size(), number);
    if (error != std::errc{} || number < -128 || number > 127) fail("bad line: " + line_);
    at_ += static_cast<std::size_t>(stop - begin);
    return number;
  }
  // Is all that remains a -?
  bool none() const { return line_.compare(at_, std::string::npos, " -") == 0; }
  bool done() const { return at_ == line_.size(); }
  void end() const {
    if (!done()) fail("bad line: " + line_);
  }

 private:
  void begin_word() {
    if (at_ == 0) return;
    if (at_ >= line_.size() || line_[at_] != ' ') fail("bad line: " + line_);
    ++at_;
  }

  const std::string& line_;
  std::size_t at_ = 0;
};

// A leaf for each index whose value is not no_leaf; the lowest bit of an index decides first.
class Trie {
 public:
  Trie(const Header& header, const std::vector<long>& leaves) : depth_(header.ports + header.before), leaves_(leaves) {
    node(0, 0);
    if (nodes_.size() >= leaf) fail(header.family + ": too many nodes for four digits");
  }

  // The nodes, eight digits each.
  std::string digits() const {
    std::string text;
    for (const auto [dashed, solid] : nodes_)
      text += hexadecimal(dashed == no_leaf ? leaf : static_cast<std::size_t>(dashed), 4) +
              hexadecimal(static_cast<std::size_t>(solid), 4);
    return text;
  }

 private:
  static constexpr std::size_t leaf = 0xffff;

  // The number of the subtrie in which the first `depth` bits are `bits`.
  long node(unsigned depth, std::size_t bits) {
    Node found;
    if (depth == depth_) {
      if (leaves_[bits] == no_leaf) return 0;
      found = {no_leaf, leaves_[bits]};
    } else {
      found = {node(depth + 1, bits), node(depth + 1, bits | std::size_t{1} << depth)};
      if (found == Node{0, 0}) return 0;
    }
    const auto [place, fresh] = numbers_.try_emplace(found, nodes_.size() + 1);
    if (fresh) nodes_.push_back(found);
    return place->second;
  }

  unsigned depth_;
  const std::vector<long>& leaves_;
  std::vector<Node> nodes_;  // node n is nodes_[n - 1]; node 0 has no leaf
  std::map<Node, long> numbers_;
};

class Table {
 public:
  explicit Table(const Header& header)
      : header_(header), answers_(std::size_t{1} << (header.ports + header.before), no_leaf), told_(answers_) {}

  std::size_t configurations() const { return answers_.size(); }

  // The number-th line of the table: hexadecimal masks with one space between them, or a - for no answer.
  void read_line(std::size_t number, const std::string& line) {
    Masks masks(line);
    const std::size_t before = masks.next();
    const std::size_t ports = masks.next();
    if (before != number >> header_.ports || ports != (number & ((std::size_t{1} << header_.ports) - 1)))
      fail(header_.family + ": line out of order: " + line);
    if (masks.none()) return;
    std::size_t answer = masks.next();
    const std::size_t kept = masks.next();
    if (header_.family == "flip")
      answer |= kept << 1;
    else if (kept != ports)
      fail(header_.family + ": a port changes: " + line);
    const int strips = masks.change();
    const int isolated = masks.change();
    masks.end();
    if (answer >> header_.after != 0) fail(header_.family + ": answer too wide: " + line);
    answers_[number] = static_cast<long>(answer);
    told_[number] = 256 * (strips + 128) + isolated + 128;
  }

  // Ports first, then the inner edges before.
  std::string answers() const { return Trie(header_, answers_).digits(); }
  std::string told() const { return Trie(header_, told_).digits(); }

 private:
  Header header_;
  std::vector<long> answers_;  // index before << number of ports | ports
  std::vector<long> told_;     // by the same index
};

// Prints digits as texts of that name, cut into pieces; their names, for a list.
std::string print_texts(std::ostream& out, const std::string& name, const std::string& digits) {
  constexpr std::size_t piece = 2000;
  std::string texts;
  for (std::size_t at = 0; at < digits.size(); at += piece) {
    const std::string text = name + "_" + std::to_string(at / piece);
    out << "Definition " << text << " : Number.uint := 0x1" << digits.substr(at, piece) << ".\n";
    texts += (at == 0 ? "" : "; ") + text;
  }
  return texts;
}

// The file of one family. A table is a text of hexadecimal digits, cut into pieces, and what is made of it.
class File {
 public:
  File(const std::string& directory, const std::string& kind, const Header& header)
      : path_(directory + "/" + kind + "_" + header.family + ".v"),
        out_(path_),
        type_(header.linked() ? "list (list alternative)" : "trie"),
        nothing_(header.linked() ? "[]" : "Nothing") {
    out_ << "(* Printed by print_tables from a table dump. *)\n"
            "Require Import List Number.\nImport ListNotations.\nRequire Import "
         << (header.linked() ? "Linked" : "Table")
         << ".\n"

            "Local Open Scope hex_uint_scope.\n";
  }
  // `digits` becomes the list of texts that `reader` is given.
  void add(const Header& header, const std::string& digits, const std::string& reader) {
    const std::string name = header.joined_by("_");
    const std::string texts = print_texts(out_, "text_" + name, digits);
    out_ << "Definition table_" << name << " : " << type_ << " := " << reader << " [" << texts << "].\n";
    cases_ += "  | [" + header.joined_by("; ") + "]%nat => table_" + name + "\n";
    ++positions_;
    answers_ += std::size_t{1} << (header.ports + header.before);
  }
  void close() {
    out_ << "Definition table (position : list nat) : " << type_ << " :=\n  match position with\n"
         << cases_ << "  | _ => " << nothing_ << "\n  end.\n";
    out_.close();
    if (!out_) fail("cannot write " + path_);
  }
  std::string counts() const { return std::to_string(positions_) + ' ' + std::to_string(answers_); }

 private:
  std::string path_;
  std::ofstream out_;
  std::string type_;
  std::string nothing_;  // for positions without a table
  std::string cases_;
  std::size_t positions_ = 0;
  std::size_t answers_ = 0;
};

// All lists of a position, for ascending port masks, as numbers of four digits: the length of a list, then for each
// alternative its recolouring and its partners, high half first.
std::string read_lists(std::istream& in, const Header& header) {
  std::string digits;
  std::string line;
  for (std::size_t ports = 0; ports < std::size_t{1} << header.ports; ++ports) {
    if (!std::getline(in, line)) fail("the dump ends in the middle of a table");
    Masks masks(line);
    if (masks.next() != ports) fail(header.family + ": line out of order: " + line);
    std::string alternatives;
    std::size_t count = 0;
    for (; !masks.done(); ++count) {
      const std::size_t recoloring = masks.next();
      const std::size_t partners = masks.next();
      if (recoloring >> header.after != 0 || partners >> 32 != 0) fail(header.family + ": mask too wide: " + line);
      alternatives += hexadecimal(recoloring, 4) + hexadecimal(partners, 8);
    }
    digits += hexadecimal(count, 4) + alternatives;
  }
  return digits;
}

void print_all(std::istream& in, const std::string& directory) {
  std::string line;
  if (!std::getline(in, line) || line != "restrip-table-dump 4") fail("not a table dump");
  std::size_t lines = 0;
  std::map<std::string, File> files;
  std::map<std::string, File> told_files;
  std::vector<std::string> families;  // in the order of the dump
  while (std::getline(in, line) && line.rfind("table ", 0) == 0) {
    const Header header = read_header(line);
    const auto [place, fresh] = files.try_emplace(header.family, directory, "Tables", header);
    if (fresh) families.push_back(header.family);
    File& file = place->second;
    if (header.linked()) {
      file.add(header, read_lists(in, header), "lists_of " + std::to_string(header.after) + "%nat");
      lines += std::size_t{1} << header.ports;
      continue;
    }
    Table table(header);
    for (std::size_t i = 0; i < table.configurations(); ++i, ++lines) {
      if (!std::getline(in, line)) fail("the dump ends in the middle of a table");
      table.read_line(i, line);
    }
    file.add(header, table.answers(), "table_of " + std::to_string(header.after) + "%nat");
    told_files.try_emplace(header.family, directory, "Told", header)
        .first->second.add(header, table.told(), "table_of 16%nat");
  }
  if (line != "end " + std::to_string(lines)) fail("the dump does not end with `end " + std::to_string(lines) + "`");
  for (auto& [family, file] : files) file.close();
  for (auto& [family, file] : told_files) file.close();
  for (const std::string& family : families) std::cout << family << ' ' << files.at(family).counts() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) fail("usage: print_tables DIRECTORY < dump");
  print_all(std::cin, argv[1]);
} catch (const std::exception& error) {
  fail(error.what());
}
