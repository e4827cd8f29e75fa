#include "work_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT: mkdtemp is POSIX

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace restrip::verify::sat {
namespace fs = std::filesystem;

WorkFolder::WorkFolder(const std::string& kept) : kept_(kept) {
  std::error_code error;
  if (!kept_.empty()) fs::create_directories(kept_, error);
  const fs::path parent = kept_.empty() ? fs::temp_directory_path() : kept_;
  std::string name = (parent / "restrip-sat.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(fmt::format("{}: no folder can be made here", parent.string()));
  temporary_ = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void WorkFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream file(temporary_ / name, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be written", path(name)));
}

void WorkFolder::finish(const std::string& name) const {
  if (kept_.empty())
    fs::remove(temporary_ / name);
  else
    fs::rename(temporary_ / name, kept_ / name);
}

}  // namespace restrip::verify::sat
