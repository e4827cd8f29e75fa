#pragma once
// The corpus on disk: tests/corpus/accept/small is a folder of tables for small fans; reject.txt and malformed.txt list
// damages to it and what the checker has to say of each. Format, one instruction a line:
//
//   case NAME                 a damage begins
//   why WORDS                 what is wrong
//   expect CODE               the exit code
//   message WORDS             part of the text that the checker prints
//   file PATH                 the file that the following instructions change
//   section POSITION          the following lines are searched for after this section's head
//   - LINE                    the line is taken out; it must be there (the last line's sums may be left away)
//   + LINE                    the line is put in, where the last line was taken out or put in
//   cut N                     the last N bytes go
//   create PATH               a file that is not listed
//   delete                    the file goes
//   keep-sums                 do not bring the sums in last lines up to date afterwards
//   keep-manifest             do not bring the MANIFEST up to date afterwards

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// A copy of the small tables with the damage done to it; removed with the object.
class DamagedTables {
 public:
  explicit DamagedTables(const Damage& damage);
  ~DamagedTables();
  DamagedTables(const DamagedTables&) = delete;
  DamagedTables& operator=(const DamagedTables&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A text that is altered in one place, and what has to be said of it: a case of a file of tests/corpus/altered. Lines
/// of one kind that follow each other are lines of one text, and "#" begins a comment:
///
///   of NAME       the text that the following cases alter
///   - TEXT        what goes, at the beginning of a line if it stands at one; without `+` the end of the line goes as
///   well
///   + TEXT        what comes in its place
///   = TEXT        part of what is said; nothing where the text is right
struct Alteration {
  std::string of;
  std::string what;
  std::optional<std::string> by;
  std::string says;

  /// The text with the alteration; throws std::runtime_error where it cannot be made.
  std::string in(std::string text) const;
};
std::vector<Alteration> alterations(const std::string& file);
/// What an `of` names: the text below "=== NAME" in texts.txt.
std::string text_to_alter(const std::string& name);

/// Writes a MANIFEST that lists what is in the folder, with its present bytes and rows.
void write_manifest(const std::filesystem::path& tables_dir);

}  // namespace restrip::verify::test
