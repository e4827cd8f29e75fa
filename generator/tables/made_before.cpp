#include "tables/made_before.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <sstream>
#include <utility>

#include "common/digest.hpp"
#include "common/reading.hpp"

namespace restrip::generator {
namespace {

namespace fs = std::filesystem;

constexpr const char* first_line = "restrip-digests 1";

/// Builds of the same version may make different files, so the program's bytes count, if they can be read.
std::string program_digest() {
  try {
    return sha256(files::read_whole("/proc/self/exe"));
  } catch (const std::exception&) {
    return RESTRIP_VERSION;
  }
}

/// The two digests of each line, by path.
std::map<std::string, std::string> lines_of(const fs::path& record) {
  std::map<std::string, std::string> lines;
  try {
    std::istringstream text(files::read_whole(record, {1 << 20, 1 << 20}));
    std::string line;
    if (!std::getline(text, line) || line != first_line) return {};
    constexpr std::size_t digests = 64 + 1 + 64;
    while (std::getline(text, line)) {
      if (line.size() < digests + 2 || line[digests] != ' ') return {};
      lines[line.substr(digests + 1)] = line.substr(0, digests);
    }
  } catch (const std::exception&) {
    return {};
  }
  return lines;
}

}  // namespace

MadeBefore::MadeBefore(fs::path folder, const std::vector<std::string>& inputs)
    : folder_(std::move(folder)), lines_(lines_of(folder_ / file_name)) {
  std::string all = program_digest();
  for (const std::string& input : inputs) all += ' ' + sha256(input);
  inputs_ = sha256(all);
}

bool MadeBefore::has(const std::vector<fs::path>& files) const {
  const fs::path record = folder_ / file_name;
  const bool all = std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
    const auto line = lines_.find(file.generic_string());
    try {
      return line != lines_.end() && line->second == inputs_ + ' ' + sha256(files::read_whole(folder_ / file));
    } catch (const std::exception&) {
      return false;
    }
  });
  if (all) fs::last_write_time(record, fs::file_time_type::clock::now());
  return all;
}

files::NamedBytes MadeBefore::with(const std::vector<files::NamedBytes>& made) const {
  std::map<std::string, std::string> lines = lines_;
  for (const files::NamedBytes& file : made) lines[file.name.generic_string()] = inputs_ + ' ' + sha256(file.bytes);
  std::string text = fmt::format("{}\n", first_line);
  for (const auto& [path, digests] : lines) text += fmt::format("{} {}\n", digests, path);
  return {file_name, text};
}

std::string MadeBefore::sentence() const {
  return fmt::format(
      "{}: made by this program from the same inputs and options; nothing to do (--force makes it again)\n",
      folder_.string());
}

}  // namespace restrip::generator
