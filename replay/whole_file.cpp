#include "whole_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "bad_input.hpp"

namespace restrip::replay {

std::string read_whole_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw BadInput(fmt::format("{}: no such file; check the path", file.string()));
  if (std::filesystem::is_directory(file, error))
    throw BadInput(fmt::format("{}: is a directory; name a mesh file inside it", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadInput(fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno)));
  // Read to the end rather than by size, so that pipes work too.
  std::string bytes;
  const auto size = std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
  if (!error) bytes.reserve(size);
  std::string block(std::size_t{1} << 20, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw BadInput(fmt::format("{}: reading failed: {}", file.string(), std::strerror(errno)));
  return bytes;
}

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
  std::error_code error;
  const auto kind = std::filesystem::symlink_status(file, error).type();
  const bool replace = kind == std::filesystem::file_type::regular || kind == std::filesystem::file_type::not_found;
  std::filesystem::path half = file;
  if (replace) half += ".part";
  std::ofstream out(half, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!replace) {
    if (!out) throw BadInput(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
    return;
  }
  if (!out) {
    const std::string reason = std::strerror(errno);
    std::filesystem::remove(half, error);
    throw BadInput(fmt::format("{}: cannot be written: {}", file.string(), reason));
  }
  std::filesystem::rename(half, file, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(half, error);
    throw BadInput(fmt::format("{}: cannot be written: {}", file.string(), reason));
  }
}

}  // namespace restrip::replay
