// The corpus on disk: tests/corpus/accept/small is a folder of tables for small fans; reject.txt and malformed.txt list
// damages to it and the expected messages of the checker. Format, one instruction a line:
//
//   case NAME                 a damage begins
//   why WORDS                 what is wrong
//   expect CODE               the exit code
//   message WORDS             part of the text that the checker prints
//   file PATH                 the file that the following instructions change
//   section POSITION          the following lines are searched for after this section's head
//   - LINE                    the line is removed; it must exist (the last line's sums may be omitted)
//   + LINE                    the line is inserted where the last line was removed or inserted
//   cut N                     the last N bytes are removed
//   create PATH               a file that is not listed
//   delete                    the file is deleted
//   keep-sums                 do not update the sums in last lines afterwards
//   keep-manifest             do not update the MANIFEST afterwards
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "../support/alterations.hpp"

namespace restrip::verify::test {

struct Damage {
  std::string name;
  int exit_code = 0;
  std::string message;
  std::vector<std::string> instructions;  ///< from the first `file` on
};

/// The intact small tables.
std::filesystem::path small_tables();

/// All damages.
std::vector<Damage> damages();

/// Makes this folder a damaged copy of the small tables.
void make_damaged_tables(const Damage& damage, const std::filesystem::path& folder);

using corpus::Alteration;
using corpus::alterations;
using corpus::text_to_alter;

/// Writes a MANIFEST that lists the files in the folder, with their present bytes and rows.
void write_manifest(const std::filesystem::path& tables_dir);

}  // namespace restrip::verify::test
