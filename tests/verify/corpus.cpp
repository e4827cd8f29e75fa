#include "corpus.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "common/digest.hpp"
#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

namespace fs = std::filesystem;
using corpus::bytes_of;
using corpus::lines_of;

void write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string argument(const std::string& line) {
  const std::size_t space = line.find(' ');
  return space == std::string::npos ? std::string{} : line.substr(space + 1);
}

}  // namespace

fs::path small_tables() { return fs::path(RESTRIP_CORPUS_DIR) / "accept" / "small"; }

std::vector<Damage> damages() {
  std::vector<Damage> all;
  for (const char* kind : {"reject.txt", "malformed.txt"})
    for (const std::string& line : lines_of(bytes_of(fs::path(RESTRIP_CORPUS_DIR) / kind))) {
      if (line.empty() || line.starts_with("why ")) continue;
      if (line.starts_with("case ")) {
        all.push_back({argument(line), 0, "", {}});
        continue;
      }
      Damage& damage = all.at(all.size() - 1);
      if (line.starts_with("expect "))
        damage.exit_code = std::stoi(argument(line));
      else if (line.starts_with("message "))
        damage.message = argument(line);
      else
        damage.instructions.push_back(line);
    }
  for (const Damage& damage : all)
    if (damage.message.empty() || damage.exit_code == 0 || damage.instructions.empty())
      throw std::runtime_error(damage.name + ": incomplete");
  return all;
}

void write_manifest(const fs::path& tables_dir) {
  std::set<std::string> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tables_dir))
    if (entry.is_regular_file() && entry.path().filename() != "MANIFEST")
      paths.insert(fs::relative(entry.path(), tables_dir).generic_string());
  std::string text = "restrip-manifest 1\n";
  for (const std::string& path : paths) {
    const std::string bytes = bytes_of(tables_dir / path);
    const std::vector<std::string> lines = lines_of(bytes);
    const auto rows = std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.starts_with("rule ") || line.starts_with("copy ") || line.starts_with("alternative ");
    });
    text += fmt::format("{} {} {} {}\n", sha256(bytes), bytes.size(), rows, path);
  }
  write(tables_dir / "MANIFEST", text);
}

void make_damaged_tables(const Damage& damage, const fs::path& folder) {
  fs::remove_all(folder);
  fs::copy(small_tables(), folder, fs::copy_options::recursive);
  bool refresh = true;
  bool sums = true;
  fs::path file;
  std::ptrdiff_t place = 0;  // of a line in it
  for (const std::string& instruction : damage.instructions) {
    const std::string verb = instruction.substr(0, instruction.find(' '));
    const std::string what = argument(instruction);
    std::vector<std::string> lines = lines_of(bytes_of(file));
    const auto go_to = [&](const std::string& line) {
      const auto found = std::find_if(lines.begin() + place, lines.end(), [&](const std::string& other) {
        return other == line || (line.starts_with("end ") && other.starts_with(line + ' '));
      });
      if (found == lines.end()) throw std::runtime_error(fmt::format("{}: no line \"{}\"", file.string(), line));
      place = found - lines.begin();
    };
    if (verb == "keep-manifest") {
      refresh = false;
    } else if (verb == "keep-sums") {
      sums = false;
    } else if (verb == "file") {
      file = folder / what;
      place = 0;
    } else if (verb == "section") {
      go_to(instruction);
      ++place;
    } else if (verb == "-") {
      go_to(what);
      lines.erase(lines.begin() + place);
      write(file, fmt::format("{}\n", fmt::join(lines, "\n")));
    } else if (verb == "+") {
      lines.insert(lines.begin() + place++, what);
      write(file, fmt::format("{}\n", fmt::join(lines, "\n")));
    } else if (verb == "cut") {
      fs::resize_file(file, fs::file_size(file) - std::stoul(what));
    } else if (verb == "create") {
      write(folder / what, "not listed\n");
    } else if (verb == "link") {
      fs::create_directory_symlink("certificates", folder / what);
    } else if (verb == "delete") {
      fs::remove(file);
    } else {
      throw std::runtime_error("unknown instruction: " + instruction);
    }
  }
  if (sums)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "certificates"))
      write(entry.path(), with_sums(bytes_of(entry.path())));
  if (refresh) write_manifest(folder);
}

}  // namespace restrip::verify::test
