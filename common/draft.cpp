#include "common/draft.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

#include "common/file_error.hpp"

namespace restrip::files {

SignalPause::SignalPause() noexcept {
  sigset_t paused;
  sigemptyset(&paused);
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGTERM}) sigaddset(&paused, signal);
  pthread_sigmask(SIG_BLOCK, &paused, &before_);
}

SignalPause::~SignalPause() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void fail_to_write(const std::string& shown, int error) {
  const char* remedy = "name a file in a folder that you may write to";
  if (error == ENOSPC || error == EDQUOT) remedy = "make room there, or name a file on another disk";
  if (error == EFBIG) remedy = "raise the limit on the size of files (ulimit -f)";
  throw FileError(fmt::format("{}: cannot be written: {}; {}", shown, std::strerror(error), remedy));
}

void Draft::fail(int error) const { fail_to_write(shown_, error); }

Draft::Draft(std::filesystem::path target, std::string shown) : target_(std::move(target)), shown_(std::move(shown)) {
  // Not derived from the target's name, which may have the greatest possible length. Another program may use the same
  // process number in a folder shared by machines; then the next name is tried.
  constexpr unsigned attempts = 1000;
  for (unsigned attempt = 0; attempt < attempts; ++attempt) {
    std::string name = (target_.parent_path() / fmt::format(".restrip-{}-{}", getpid(), attempt)).string();
    file_ = Descriptor(system_calls().open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file_.is_open()) {
      name_ = std::move(name);
      return;
    }
    if (errno != EEXIST && errno != EINTR) fail(errno);
  }
  fail(EEXIST);
}

Draft::Draft(Draft&& other) noexcept
    : target_(std::move(other.target_)),
      shown_(std::move(other.shown_)),
      name_(std::move(other.name_)),
      file_(std::move(other.file_)) {
  other.name_.clear();
}

Draft::~Draft() {
  if (!name_.empty()) system_calls().unlink(name_.c_str());
}

void Draft::fill(std::string_view bytes) {
  struct stat replaced {};
  if (::lstat(target_.c_str(), &replaced) == 0) {
    struct stat own {};
    // Not every user may change owners; then the permissions are kept for the present owner.
    if (fstat(file_.get(), &own) == 0 && (own.st_uid != replaced.st_uid || own.st_gid != replaced.st_gid))
      (void)!fchown(file_.get(), replaced.st_uid, replaced.st_gid);
    if (system_calls().fchmod(file_.get(), replaced.st_mode & 0777U) != 0) fail(errno);
  }
  if (!write_fully(file_.get(), bytes.data(), bytes.size())) fail(errno);
  if (system_calls().fsync(file_.get()) != 0) fail(errno);
  if (!file_.close()) fail(errno);
}

void Draft::publish() {
  if (!try_publish()) fail(errno);
}

bool Draft::try_publish() noexcept {
  if (system_calls().rename(name_.c_str(), target_.c_str()) != 0) return false;
  name_.clear();
  return true;
}

bool Draft::take_target_aside() noexcept { return system_calls().rename(target_.c_str(), name_.c_str()) == 0; }

bool Draft::remove_published() const noexcept { return system_calls().unlink(target_.c_str()) == 0; }

}  // namespace restrip::files
