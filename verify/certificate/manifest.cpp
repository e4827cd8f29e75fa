#include "certificate/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "common/counted.hpp"
#include "common/digest.hpp"
#include "common/printable.hpp"
#include "model/description.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

namespace fs = std::filesystem;

/// Files in the folder of the tables that need no line.
bool needs_no_line(const std::string& path) {
  return path == "MANIFEST" || path.ends_with("CMakeLists.txt") || path.ends_with(".cmake");
}

/// The number of rows of a certificate by its last line, "end NUMBER …", 0 if it has no such line; of a header by the
/// certificate from which it is made. Certificates and headers of operations are in separate folders.
std::size_t rows_of(const std::string& tables_dir, const std::string& path) {
  if (path.ends_with(".cert")) {
    std::size_t rows = 0;
    const std::string text = read_file(tables_dir + "/" + path);
    const std::size_t line = text.rfind("\nend ");
    if (line != std::string::npos) std::from_chars(text.data() + line + 5, text.data() + text.size(), rows);
    return rows;
  }
  constexpr std::string_view headers = "include/restrip/tables/";
  if (!path.starts_with(headers) || !path.ends_with(".hpp")) return 0;
  std::string name = path.substr(headers.size(), path.size() - headers.size() - 4);
  std::replace(name.begin(), name.end(), '_', '-');
  const std::string certificate = "certificates/" + name + ".cert";
  return fs::is_regular_file(fs::path(tables_dir) / certificate) ? rows_of(tables_dir, certificate) : 0;
}

}  // namespace

std::vector<ManifestLine> parse_manifest(const std::string& file, const std::string& text) {
  LineReader reader(file, text);
  reader.next("\"restrip-manifest 1\"");
  reader.expect_line("restrip-manifest 1");
  const auto natural = [&](std::size_t index) {
    const std::int64_t value = reader.number(index);
    if (value < 0) reader.fail("expected a number that is not negative");
    return static_cast<std::size_t>(value);
  };
  std::vector<ManifestLine> lines;
  while (!reader.at_end()) {
    reader.next("SHA256 BYTES ROWS PATH");
    reader.expect_words(4, "SHA256 BYTES ROWS PATH");
    const std::string digest(reader.words()[0]);
    if (digest.size() != 64 || digest.find_first_not_of("0123456789abcdef") != std::string::npos)
      reader.fail("expected 64 lower-case hexadecimal digits");
    lines.push_back({digest, natural(1), natural(2), std::string(reader.words()[3]), reader.line()});
    const fs::path path(lines.back().path);
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
      reader.fail("expected a path below the folder of the tables");
    if (lines.size() > 1 && !(lines[lines.size() - 2].path < lines.back().path))
      reader.fail("expected lines in ascending order of path");
  }
  return lines;
}

std::vector<std::string> manifest_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines) {
  std::vector<std::string> faults;
  std::set<std::string> listed;
  for (const ManifestLine& line : lines) {
    listed.insert(line.path);
    const auto fault = [&](const std::string& what) {
      faults.push_back(
          fmt::format("{}/MANIFEST:{}: {}: {}; generate the tables again", tables_dir, line.line, line.path, what));
    };
    const std::string path = tables_dir + "/" + line.path;
    if (!fs::is_regular_file(path)) {
      fault("missing file");
      continue;
    }
    const std::string bytes = read_file(path);
    if (bytes.size() != line.bytes)
      fault(fmt::format("wrong size: {} bytes listed, {} found", line.bytes, bytes.size()));
    if (const std::string found = sha256(bytes); found != line.sha256)
      fault(fmt::format("wrong checksum: {} listed, {} found", line.sha256, found));
  }
  if (const std::string families = tables_dir + "/families.json";
      fs::is_regular_file(families) && read_file(families) != families_text)
    faults.push_back(families + ": differs from the families that this program was built with; build it again");
  std::set<std::string> unlisted;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tables_dir)) {
    if (entry.is_directory() && !entry.is_symlink()) continue;
    const std::string path = entry.path().lexically_relative(tables_dir).generic_string();
    if (!needs_no_line(path) && !listed.contains(path)) unlisted.insert(path);
  }
  for (const std::string& path : unlisted)
    faults.push_back(fmt::format("{}/{}: unlisted file; remove it or generate the tables again", tables_dir,
                                 files::printable_ascii(path)));
  return faults;
}

std::vector<std::string> row_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines) {
  std::vector<std::string> faults;
  for (const ManifestLine& line : lines) {
    if (!fs::is_regular_file(tables_dir + "/" + line.path)) continue;
    if (const std::size_t found = rows_of(tables_dir, line.path); found != line.rows)
      faults.push_back(fmt::format("{}/MANIFEST:{}: {}: {} listed, {} found", tables_dir, line.line, line.path,
                                   counted(line.rows, "row"), found));
  }
  return faults;
}

}  // namespace restrip::verify
