// Writes tests/corpus/accept/small: tables for small fans made by the naive search of this folder.

#include <fmt/format.h>

#include <fstream>

#include "corpus.hpp"
#include "verdict.hpp"

int main(int argc, char** argv) {
  using namespace restrip::verify::test;
  if (argc != 2) {
    fmt::print(stderr, "usage: restrip-make-small-tables FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder / "certificates");
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  for (const NaiveFamily& family : families) {
    if (family.name != "split" && family.name != "collapse" && family.name != "flip")
      continue;  // the others have no table
    std::vector<NaiveTable> tables;
    for (const NaiveSection& section : family.sections)
      tables.push_back(naive_table(family.name, section, true).value());
    std::ofstream(folder / "certificates" / (family.name + ".cert"), std::ios::binary)
        << certificate_text(family.name, tables);
  }
  write_manifest(folder);
}
