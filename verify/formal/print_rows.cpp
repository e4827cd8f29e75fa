// Prints a certificate (docs/certificate.md) as a Coq file Rows_FAMILY.v.
//
//   print_rows DIRECTORY < FAMILY.cert
//
// Of a copy the recolouring is left out: Rows.v works it out again from the symmetry. Reasons and sums are left out,
// too: the proof searches. At the end of the file stands the function from positions, lists of numbers such as [8; 3],
// to the rows of their sections.
// Anything unexpected ends the program with a message and exit code 1.
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "print_rows: " << what << '\n';
  std::exit(1);
}

struct Section {
  std::vector<std::string> position;
  std::vector<std::string> rows;

  std::string joined_by(const std::string& separator) const {
    std::string text;
    for (const std::string& n : position) text += (text.empty() ? "" : separator) + n;
    return text;
  }

  void print(std::ostream& out) const {
    constexpr std::size_t chunk = 500;
    const std::string name = joined_by("_");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i % chunk == 0) out << "Definition rows_" << name << "_part_" << i / chunk << " : list row := [\n";
      out << rows[i] << (i % chunk + 1 == chunk || i + 1 == rows.size() ? "].\n" : i % 6 == 5 ? ";\n" : "; ");
    }
    out << "Definition rows_" << name << " : list row := ";
    for (std::size_t c = 0; c * chunk < rows.size(); ++c) out << "rows_" << name << "_part_" << c << " ++ ";
    out << "[].\n";
  }
};

// `rule P J R because …` or `copy P J R by s n`, as a row of Rows.v.
std::string read_row(const std::string& line) {
  std::istringstream words(line);
  std::string kind, ports, joined, after, by, symmetry, n, rest;
  words >> kind >> ports >> joined >> after >> by >> symmetry >> n >> rest;
  const std::string key = " 0x" + ports + " 0x" + joined;
  if (kind == "rule" && by == "because") return "Rule" + key + " 0x" + after;
  if (kind == "copy" && by == "by" && !n.empty() && rest.empty()) {
    if (symmetry == "turn") return "Copy" + key + " (Turn " + n + ")";
    if (symmetry == "mirror") return "Copy" + key + " (Mirror " + n + ")";
  }
  fail("bad row: " + line);
}

Section read_section(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  Section section;
  while (words >> word)
    if (word.find_first_not_of("0123456789") == std::string::npos) section.position.push_back(word);
  return section;
}

void print_all(std::istream& in, const std::string& directory) {
  std::string line;
  if (!std::getline(in, line) || line != "restrip-certificate 2") fail("not a certificate");
  if (!std::getline(in, line) || line.rfind("family ", 0) != 0) fail("no family");
  std::string family = line.substr(7);
  for (char& c : family) c = c == '-' ? '_' : c;
  std::vector<Section> sections;
  std::size_t rows = 0;
  while (std::getline(in, line) && line.rfind("end ", 0) != 0) {
    if (line.rfind("section ", 0) == 0) {
      sections.push_back(read_section(line));
    } else if (line.rfind("claim ", 0) != 0) {
      if (sections.empty()) fail("a row before the first section: " + line);
      sections.back().rows.push_back(read_row(line));
      ++rows;
    }
  }
  if (line.rfind("end " + std::to_string(rows) + " ", 0) != 0)
    fail("the certificate does not end with `end " + std::to_string(rows) + "` and two sums");

  const std::string path = directory + "/Rows_" + family + ".v";
  std::ofstream out(path);
  out << "(* Printed by print_rows from a certificate. *)\n"
         "Require Import NArith List.\nImport ListNotations.\nRequire Import Rows.\n";
  for (const Section& section : sections) section.print(out);
  out << "Definition rows (position : list nat) : list row :=\n  match position with\n";
  for (const Section& section : sections)
    out << "  | [" << section.joined_by("; ") << "] => rows_" << section.joined_by("_") << "\n";
  out << "  | _ => []\n  end.\n";
  out.close();
  if (!out) fail("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) fail("usage: print_rows DIRECTORY < certificate");
  print_all(std::cin, argv[1]);
} catch (const std::exception& error) {
  fail(error.what());
}
