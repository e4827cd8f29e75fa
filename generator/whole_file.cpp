#include "whole_file.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace restrip::generator {

namespace fs = std::filesystem;

void write_all(const fs::path& directory, const std::map<std::string, std::string>& files) {
  std::vector<std::pair<fs::path, fs::path>> pending;
  const auto give_up = [&](const fs::path& file, const std::string& why) {
    std::error_code ignored;
    for (const auto& [temporary, final_name] : pending) fs::remove(temporary, ignored);
    throw std::runtime_error(fmt::format(
        "{}: cannot be written ({}); choose a directory you may write to and that has room", file.string(), why));
  };
  for (const auto& [name, contents] : files) {
    const fs::path file = directory / name;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) give_up(file, error.message());
    const fs::path temporary = file.string() + ".partial";
    pending.emplace_back(temporary, file);
    std::ofstream out(temporary, std::ios::binary);
    out << contents;
    out.close();
    if (!out) give_up(file, "writing failed");
  }
  for (const auto& [temporary, file] : pending) {
    std::error_code error;
    fs::rename(temporary, file, error);
    if (error) give_up(file, error.message());
  }
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
  std::string text;
  for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace restrip::generator
