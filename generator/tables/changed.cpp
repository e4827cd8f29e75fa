#include "tables/changed.hpp"

#include <fstream>
#include <iterator>
#include <string>

namespace restrip::generator {

std::vector<files::NamedBytes> changed(const std::filesystem::path& folder, std::vector<files::NamedBytes> files) {
  std::erase_if(files, [&](const files::NamedBytes& file) {
    std::ifstream old(folder / file.name, std::ios::binary);  // not read_whole(), which refuses outputs
    return old && std::string(std::istreambuf_iterator<char>(old), {}) == file.bytes;
  });
  return files;
}

}  // namespace restrip::generator
