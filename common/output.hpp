// All programs of the project write files through this. An output is tested before the work that makes it, and appears
// whole or not at all: drafted in the folder of its target (through links), synced, renamed. While an output lives, no
// other output may name its file, and read_whole() refuses to read it.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::files {

/// The files that a thread is about to write, whatever their names: none may be written twice, and none may be read,
/// because it would be lost. Outputs claim their files before anything is read, so files found later (the buffers of a
/// glTF) are protected as well.
class Claim {
 public:
  /// `shown`: its name as the user wrote it. `file`: the target of its links. `descriptor`: -1, or the open file.
  /// Throws FileError when this thread has claimed the file already.
  Claim(std::string shown, std::filesystem::path file, int descriptor);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  [[nodiscard]] const std::string& shown() const noexcept { return shown_; }

  /// The claim on this file, or null. Terminals and the like are never claimed: several may use them.
  [[nodiscard]] static const Claim* on(const struct stat& file);
  /// Whether standard output carries a file, so that text has to go elsewhere.
  [[nodiscard]] static bool on_standard_output();

 private:
  [[nodiscard]] std::optional<struct stat> status() const;
  [[nodiscard]] bool same_place(const Claim& other) const;

  std::string shown_;
  std::filesystem::path file_;
  int descriptor_;
};

/// Conditions on an output.
struct OutputRules {
  std::vector<std::string> extensions;  ///< one of these (".pm"), in upper or lower case; empty: any
  /// Must not be one of these, under any name. For inputs that are not read by read_whole().
  std::vector<std::filesystem::path> inputs = {};
};

/// A file to be written. If a file exists that is not a regular file (a terminal, a pipe, /dev/null, /dev/stdout), it
/// is written to and not replaced, because other programs use it. `-` is standard output.
class Output {
 public:
  /// Throws FileError unless the file can be written: its folder exists and is writable, it is not a folder and not
  /// protected, the rules hold, and no other output of this thread is the same file.
  explicit Output(const std::filesystem::path& file, const OutputRules& rules = {});

  /// Writes the whole file, with the permissions of the file that it replaces, or as the umask says. Throws FileError;
  /// then a regular file is unchanged and nothing else is left.
  void write(std::string_view bytes) const;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return file_; }

 private:
  friend class OutputSet;

  std::filesystem::path file_;    ///< as the user named it
  std::filesystem::path target_;  ///< the regular file that it leads to; empty for everything else
  int descriptor_ = -1;           ///< for /dev/stdout and the like: one that is open already
  std::shared_ptr<const Claim> claim_;
};

struct NamedBytes {
  std::filesystem::path name;  ///< below the folder of the set
  std::string bytes;
};

/// Several files of one folder. The last one describes the others (a manifest, a report). It never appears next to
/// files that it does not describe, even after failures.
class OutputSet {
 public:
  /// Makes the folders of these files; those that stay empty are removed in the end. Throws FileError unless each file
  /// can be written, is a regular file if it exists, and no two are the same.
  OutputSet(std::filesystem::path folder, const std::vector<std::filesystem::path>& names,
            const OutputRules& rules = {});

  /// Drafts all files; after a failure so far (a full disk) everything is as before. Then removes the last of the old
  /// files and gives the new ones their names, in order. Throws FileError; then each file is old or new, and the last
  /// one does not exist unless all are old. Names must be among the names of the constructor.
  void write(const std::vector<NamedBytes>& files) const;

 private:
  struct MadeFolders {
    MadeFolders() = default;
    ~MadeFolders();
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    /// Makes the folder and its parents, if they do not exist. Throws FileError.
    void make(const std::filesystem::path& folder);

    std::vector<std::string> made;
  };

  std::filesystem::path folder_;
  MadeFolders folders_;
  std::vector<Output> tested_;
};

/// The destination of the report of a command, the same for every command: text on standard output, or on standard
/// error if another output of the command is standard output; with `--json FILE` also JSON to the file; with `--json -`
/// JSON on standard output instead of the text.
class ReportOutput {
 public:
  /// `json`: the argument of the option, empty if it was not given. Tests the file before the work; it must end in
  /// .json and not be an input. Throws what files::Output throws.
  explicit ReportOutput(const std::string& json, std::vector<std::filesystem::path> inputs = {});

  /// Whether standard output is only for JSON, so that intermediate lines are not printed.
  [[nodiscard]] bool replaces_text() const noexcept { return to_stdout_; }

  /// Both end with a line feed, or are empty.
  void print(std::string_view text, std::string_view json) const;

 private:
  bool to_stdout_;
  std::optional<Output> file_;
  std::shared_ptr<const Claim> claim_;  // on standard output
};

/// The exit code of a program: `code`, or 2 with a message if standard output could not be written, which a buffer or a
/// full disk may hide until the end. For the end of every main(), also after --help.
[[nodiscard]] int exit_code(std::string_view program, int code);

}  // namespace restrip::files
