#include "common/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "common/printable.hpp"
#include "common/reading.hpp"
#include "common/system_calls.hpp"

namespace restrip::files {
namespace fs = std::filesystem;
namespace {

thread_local std::vector<const Claim*> claims;

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

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
  std::error_code error;
  return descriptor_ < 0 && other.descriptor_ < 0 && file_.filename() == other.file_.filename() &&
         fs::equivalent(folder_of(file_), folder_of(other.file_), error) && !error &&
         !fs::is_character_file(file_, error);
}

namespace {

/// Throws FileError: `shown` cannot be written because of `error`, and what to do.
[[noreturn]] void fail_to_write(const std::string& shown, int error) {
  const char* remedy = "name a file in a folder that you may write to";
  if (error == ENOSPC || error == EDQUOT) remedy = "make room there, or name a file on another disk";
  if (error == EFBIG) remedy = "raise the limit on the size of files (ulimit -f)";
  throw FileError(fmt::format("{}: cannot be written: {}; {}", shown, std::strerror(error), remedy));
}

/// Keeps the signals that end a program by request (interrupt, hang-up, quit, terminate) waiting while it lives, so
/// that none of them leaves a draft.
class SignalPause {
 public:
  SignalPause() noexcept {
    sigset_t paused;
    sigemptyset(&paused);
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGTERM}) sigaddset(&paused, signal);
    pthread_sigmask(SIG_BLOCK, &paused, &before_);
  }
  ~SignalPause() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

 private:
  sigset_t before_{};
};

/// A temporary file in the folder of its target: written and synced there, then renamed. Removed with its owner unless
/// it was published.
class Draft {
 public:
  /// A new file in the folder of `target`, which is not a link. Its name is new. Throws FileError about `shown`, the
  /// name by which the user knows the target.
  Draft(fs::path target, std::string shown) : target_(std::move(target)), shown_(std::move(shown)) {
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
      if (errno != EEXIST && errno != EINTR) fail_to_write(shown_, errno);
    }
    fail_to_write(shown_, EEXIST);
  }
  ~Draft() {
    if (!name_.empty()) system_calls().unlink(name_.c_str());
  }
  Draft(Draft&& other) noexcept
      : target_(std::move(other.target_)),
        shown_(std::move(other.shown_)),
        name_(std::exchange(other.name_, {})),
        file_(std::move(other.file_)) {}
  Draft& operator=(Draft&&) = delete;

  /// Writes all bytes and makes sure that they are on the disk, with the owner and permissions of the target if that
  /// is there, otherwise as the umask says. Throws FileError.
  void fill(std::string_view bytes) {
    struct stat replaced {};
    if (::lstat(target_.c_str(), &replaced) == 0) {
      struct stat own {};
      // Not every user may change owners; then the permissions are kept for the present owner.
      if (fstat(file_.get(), &own) == 0 && (own.st_uid != replaced.st_uid || own.st_gid != replaced.st_gid))
        (void)!fchown(file_.get(), replaced.st_uid, replaced.st_gid);
      if (system_calls().fchmod(file_.get(), replaced.st_mode & 0777U) != 0) fail_to_write(shown_, errno);
    }
    if (!write_fully(file_.get(), bytes.data(), bytes.size()) || system_calls().fsync(file_.get()) != 0 ||
        !file_.close())
      fail_to_write(shown_, errno);
  }

  /// Takes the target's name. Throws FileError; then the target is as it was.
  void publish() {
    if (system_calls().rename(name_.c_str(), target_.c_str()) != 0) fail_to_write(shown_, errno);
    name_.clear();
  }
  /// Removes the target, if it exists. Throws FileError.
  void remove_target() const {
    if (system_calls().unlink(target_.c_str()) != 0 && errno != ENOENT) fail_to_write(shown_, errno);
  }

 private:
  fs::path target_;
  std::string shown_;
  std::string name_;  ///< empty when there is nothing to remove
  Descriptor file_;
};

std::optional<struct stat> status_of(const fs::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

/// The target of links, and the descriptor if it is one of this process (/dev/stdout, /dev/fd/3).
struct Destination {
  fs::path file;
  int descriptor = -1;
};

Destination follow_links(const fs::path& file) {
  constexpr unsigned most_links = 40;  // as in the kernel
  Destination end{file};
  for (unsigned links = 0; links <= most_links; ++links) {
    std::error_code error;
    const std::string last = end.file.filename().string();
    int number = -1;
    const auto [stop, bad] = std::from_chars(last.data(), last.data() + last.size(), number);
    if (bad == std::errc{} && stop == last.data() + last.size() &&
        fs::equivalent(folder_of(end.file), "/proc/self/fd", error) && !error) {
      end.descriptor = number;
      return end;
    }
    if (!fs::is_symlink(end.file, error)) return end;
    const fs::path to = fs::read_symlink(end.file, error);
    if (error) break;
    end.file = to.is_absolute() ? to : folder_of(end.file) / to;
  }
  throw FileError(fmt::format("{}: cannot be written: its links lead nowhere; name a file", file.string()));
}

void check_extension(const fs::path& file, const fs::path& target, const std::vector<std::string>& wanted) {
  const auto expect_wanted = [&](const fs::path& named, const std::string& which) {
    const std::string extension = extension_of(named);
    if (std::find(wanted.begin(), wanted.end(), extension) == wanted.end())
      throw FileError(fmt::format("{}: has the extension '{}', but what is written is {}; name a file that ends so",
                                  which, extension, fmt::join(wanted, " or ")));
  };
  if (wanted.empty()) return;
  expect_wanted(file, file.string());
  // A link may lead to a store of files without extensions, but not to a file of another format.
  if (!extension_of(target).empty())
    expect_wanted(target, fmt::format("{}: leads to {}", file.string(), target.string()));
}

/// Tries it, because permissions, read-only disks and quotas are not all visible in advance.
void check_folder(const fs::path& file, const fs::path& target) {
  const fs::path folder = folder_of(target);
  if (!status_of(folder))
    throw FileError(fmt::format("{}: cannot be written: the folder {} does not exist; make it first", file.string(),
                                folder.string()));
  const SignalPause pause;
  const Draft probe(target, file.string());
}

void check_protection(const fs::path& file, const fs::path& target) {
  if (::access(target.c_str(), W_OK) != 0 && errno != ENOENT) fail_to_write(file.string(), errno);
}

/// Writes to an existing file that is not a regular file.
void write_through(const std::string& shown, int descriptor, std::string_view bytes) {
  Descriptor out(descriptor >= 0 ? ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)
                                 : system_calls().open(shown.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC, 0));
  if (!out.is_open() || !write_fully(out.get(), bytes.data(), bytes.size()) || !out.close())
    fail_to_write(shown, errno);
}

}  // namespace

Output::Output(const fs::path& file, const OutputRules& rules) : file_(file) {
  const std::string shown = file.string();
  if (file.empty()) throw FileError("the name of an output is empty; name a file");
  const Destination end = file == "-" ? Destination{file, STDOUT_FILENO} : follow_links(file);
  const auto status = status_of(file);
  if (status && !S_ISCHR(status->st_mode))  // a terminal may be both
    for (const fs::path& input : rules.inputs)
      if (const auto other = status_of(input);
          other && other->st_dev == status->st_dev && other->st_ino == status->st_ino)
        throw FileError(
            fmt::format("{}: is the input {} itself, which would be lost; name another file", shown, input.string()));
  claim_ = std::make_shared<Claim>(shown, end.file, end.descriptor);
  if (end.descriptor >= 0) {
    const int flags = ::fcntl(end.descriptor, F_GETFL);
    if (flags < 0 && end.descriptor == STDOUT_FILENO)
      throw FileError(fmt::format("{}: cannot be written: standard output is closed; name a file", shown));
    if (flags < 0) fail_to_write(shown, errno);
    if ((flags & O_ACCMODE) == O_RDONLY) fail_to_write(shown, EBADF);
    descriptor_ = end.descriptor;
    return;
  }
  if (!status && errno != ENOENT) fail_to_write(shown, errno);
  if (status && S_ISDIR(status->st_mode))
    throw FileError(fmt::format("{}: cannot be written: it is a folder; name a file inside it", shown));
  if (status && (S_ISBLK(status->st_mode) || S_ISSOCK(status->st_mode)))
    throw FileError(fmt::format("{}: cannot be written: it is a {}; name a file", shown,
                                S_ISBLK(status->st_mode) ? "disk" : "socket"));
  if (status && !S_ISREG(status->st_mode)) {
    check_protection(file, file);
    return;
  }
  if (file.filename().empty()) fail_to_write(shown, EISDIR);
  check_extension(file, end.file, rules.extensions);
  check_folder(file, end.file);
  check_protection(file, end.file);
  target_ = end.file;
}

void Output::write(std::string_view bytes) const {
  if (target_.empty()) return write_through(file_.string(), descriptor_, bytes);
  const SignalPause pause;
  Draft draft(target_, file_.string());
  draft.fill(bytes);
  draft.publish();
}

OutputSet::MadeFolders::~MadeFolders() {
  for (auto folder = made.rbegin(); folder != made.rend(); ++folder) ::rmdir(folder->c_str());
}

void OutputSet::MadeFolders::make(const fs::path& folder) {
  if (folder.empty() || status_of(folder)) return;
  make(folder.parent_path());
  made.reserve(made.size() + 1);
  std::string name = folder.string();
  if (system_calls().mkdir(name.c_str(), 0777) == 0)
    made.push_back(std::move(name));
  else if (errno != EEXIST)
    throw FileError(fmt::format("{}: cannot be made: {}; name a folder that you may write to", folder.string(),
                                std::strerror(errno)));
}

OutputSet::OutputSet(fs::path folder, const std::vector<fs::path>& names, const OutputRules& rules)
    : folder_(std::move(folder)) {
  if (folder_.empty()) throw FileError("the name of the folder for the output is empty; name one");
  for (const fs::path& name : names) {
    const fs::path file = folder_ / name;
    folders_.make(folder_of(file));
    if (tested_.emplace_back(file, rules).target_.empty())
      throw FileError(fmt::format("{}: cannot be written: it is not a regular file; remove it", file.string()));
  }
}

void OutputSet::write(const std::vector<NamedBytes>& files) const {
  const SignalPause pause;
  std::vector<Draft> drafts;
  for (const NamedBytes& file : files) {
    const fs::path path = folder_ / file.name;
    drafts.emplace_back(follow_links(path).file, path.string()).fill(file.bytes);
  }
  if (drafts.size() > 1) drafts.back().remove_target();
  for (Draft& draft : drafts) draft.publish();
}

ReportOutput::ReportOutput(const std::string& json, std::vector<std::filesystem::path> inputs)
    : to_stdout_(json == "-") {
  if (to_stdout_ && ::fcntl(STDOUT_FILENO, F_GETFD) < 0)
    throw FileError("standard output: cannot be written: it is closed; name a file for --json");
  if (to_stdout_)
    claim_ = std::make_shared<Claim>("standard output", "-", STDOUT_FILENO);
  else if (!json.empty())
    file_.emplace(json, OutputRules{{".json"}, std::move(inputs)});
}

void ReportOutput::print(std::string_view text, std::string_view json) const {
  if (to_stdout_) {
    fmt::print("{}", json);
    return;
  }
  if (file_) file_->write(json);
  fmt::print(Claim::on_standard_output() ? stderr : stdout, "{}", printable(text));
}

int exit_code(std::string_view program, int code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "{}: standard output could not be written: {}\n", program,
             errno == EBADF ? "it is closed"
             : errno != 0   ? std::strerror(errno)
                            : "its device refused it");
  return 2;
}

}  // namespace restrip::files
