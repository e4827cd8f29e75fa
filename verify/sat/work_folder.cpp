#include "sat/work_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT: mkdtemp is POSIX

#include <stdexcept>
#include <system_error>

namespace restrip::verify::sat {
namespace fs = std::filesystem;

WorkFolder::WorkFolder(const std::string& kept) : kept_(kept) {
  made_.make(kept_);
  const fs::path parent = kept_.empty() ? fs::temp_directory_path() : kept_;
  std::string name = (parent / "restrip-sat.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(
        fmt::format("{}: no folder can be made here; name one that you may write to with --out", parent.string()));
  temporary_ = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void WorkFolder::write(const std::string& name, const std::string& bytes) const {
  files::write_scratch(temporary_ / name, bytes);
}

void WorkFolder::finish(const std::string& name) const {
  if (kept_.empty())
    fs::remove(temporary_ / name);
  else
    files::move_into_place(temporary_ / name, kept_ / name);
}

}  // namespace restrip::verify::sat
