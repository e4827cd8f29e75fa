#include "common/claim.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "common/file_error.hpp"

namespace restrip::files {
namespace {

thread_local std::vector<const Claim*> claims;

}  // namespace

Claim::Claim(std::string shown, std::filesystem::path file, int descriptor)
    : shown_(std::move(shown)), file_(std::move(file)), descriptor_(descriptor) {
  const auto own = status();
  const auto found = std::find_if(claims.begin(), claims.end(), [this](const Claim* c) { return same_place(*c); });
  const Claim* const other = found != claims.end() ? *found : own ? on(*own) : nullptr;
  if (other != nullptr)
    throw FileError(
        fmt::format("{}: is the output {} as well, and one would be lost; name another file", shown_, other->shown_));
  claims.push_back(this);
}

Claim::~Claim() { claims.erase(std::remove(claims.begin(), claims.end(), this), claims.end()); }

const Claim* Claim::on(const struct stat& file) {
  if (S_ISCHR(file.st_mode)) return nullptr;
  for (const Claim* claim : claims)
    if (const auto other = claim->status(); other && other->st_dev == file.st_dev && other->st_ino == file.st_ino)
      return claim;
  return nullptr;
}

bool Claim::on_standard_output() {
  struct stat file {};
  return std::any_of(claims.begin(), claims.end(), [](const Claim* c) { return c->descriptor_ == STDOUT_FILENO; }) ||
         (::fstat(STDOUT_FILENO, &file) == 0 && on(file) != nullptr);
}

std::optional<struct stat> Claim::status() const {
  struct stat found {};
  const int result = descriptor_ >= 0 ? ::fstat(descriptor_, &found) : ::stat(file_.c_str(), &found);
  return result == 0 ? std::optional(found) : std::nullopt;
}

/// For files that do not exist yet.
bool Claim::same_place(const Claim& other) const {
  const auto folder = [](const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  };
  std::error_code error;
  return descriptor_ < 0 && other.descriptor_ < 0 && file_.filename() == other.file_.filename() &&
         std::filesystem::equivalent(folder(file_), folder(other.file_), error) && !error &&
         !std::filesystem::is_character_file(file_, error);
}

}  // namespace restrip::files
