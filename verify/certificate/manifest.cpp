#include "certificate/manifest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

namespace fs = std::filesystem;

bool is_sha256(std::string_view word) {
  return word.size() == 64 && word.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::size_t natural(const LineReader& reader, std::size_t index) {
  const std::int64_t value = reader.number(index);
  if (value < 0) reader.fail("expected a number that is not negative");
  return static_cast<std::size_t>(value);
}

/// What lies among the tables without being made with them: the build's own file, the families, the explanations of the
/// layout, and operations with tables of their own, which `restrip-verify --operation` judges.
bool made_otherwise(const std::string& path) {
  return path == "CMakeLists.txt" || path == "families.json" || path == "include/restrip/tables/format.hpp" ||
         path == "include/restrip/tables/automaton_format.hpp" ||
         path == "include/restrip/tables/operation_format.hpp" || path == "include/restrip/tables/operation_dump.hpp" ||
         path.starts_with("operations/") || path.starts_with("certificates/operations/") ||
         path.starts_with("include/restrip/tables/operations/");
}

bool stays_inside(const fs::path& path) {
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

}  // namespace

std::vector<ManifestLine> parse_manifest(const std::string& file, const std::string& text) {
  LineReader reader(file, text);
  reader.next("\"restrip-manifest 1\"");
  reader.expect_line("restrip-manifest 1");
  std::vector<ManifestLine> lines;
  while (!reader.at_end()) {
    reader.next("SHA256 BYTES ROWS PATH");
    reader.expect_words(4, "SHA256 BYTES ROWS PATH");
    if (!is_sha256(reader.words()[0])) reader.fail("expected 64 lower-case hexadecimal digits");
    lines.push_back({std::string(reader.words()[0]), natural(reader, 1), natural(reader, 2),
                     std::string(reader.words()[3]), reader.line()});
    if (!stays_inside(lines.back().path)) reader.fail("expected a path below the folder of the tables");
    if (lines.size() > 1 && !(lines[lines.size() - 2].path < lines.back().path))
      reader.fail("expected lines in ascending order of path");
  }
  return lines;
}

std::vector<ManifestLine> read_manifest(const std::string& tables_dir) {
  const std::string file = tables_dir + "/MANIFEST";
  return parse_manifest(file, read_file(file));
}

std::string sha256_of(const std::string& bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available");
  std::string text;
  for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::vector<std::string> manifest_faults(const std::string& tables_dir, const std::vector<ManifestLine>& lines) {
  std::vector<std::string> faults;
  std::set<std::string> listed;
  for (const ManifestLine& line : lines) {
    listed.insert(line.path);
    const auto fault = [&](const std::string& what) {
      faults.push_back(fmt::format("{}/MANIFEST:{}: {}: {}", tables_dir, line.line, line.path, what));
    };
    const std::string path = tables_dir + "/" + line.path;
    if (!fs::is_regular_file(path)) {
      fault("missing file");
      continue;
    }
    const std::string bytes = read_file(path);
    if (bytes.size() != line.bytes)
      fault(fmt::format("wrong size: {} bytes listed, {} found", line.bytes, bytes.size()));
    if (const std::string found = sha256_of(bytes); found != line.sha256)
      fault(fmt::format("wrong checksum: {} listed, {} found", line.sha256, found));
  }
  std::set<std::string> unlisted;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tables_dir)) {
    if (entry.is_directory()) continue;
    const std::string path = fs::relative(entry.path(), tables_dir).generic_string();
    if (path != "MANIFEST" && !made_otherwise(path) && !listed.contains(path)) unlisted.insert(path);
  }
  for (const std::string& path : unlisted) faults.push_back(fmt::format("{}/{}: unlisted file", tables_dir, path));
  return faults;
}

}  // namespace restrip::verify
