#pragma once
// A temporary file in the folder of its target: written and synced there, then renamed.

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "common/descriptor.hpp"

namespace restrip::files {

/// Keeps the signals that end a program by request (interrupt, hang-up, quit, terminate) waiting while it lives, so
/// that none of them leaves a draft.
class SignalPause {
 public:
  SignalPause() noexcept;
  ~SignalPause();
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

 private:
  sigset_t before_{};
};

/// Removed with its owner unless it was published.
class Draft {
 public:
  /// A new file in the folder of `target`, which is not a link. Its name is new. Throws FileError about `shown`, the
  /// name by which the user knows the target.
  Draft(std::filesystem::path target, std::string shown);
  ~Draft();
  Draft(Draft&& other) noexcept;
  Draft& operator=(Draft&&) = delete;

  /// Writes all bytes and makes sure that they are on the disk, with the owner and permissions of the target if that
  /// is there, otherwise as the umask says. Throws FileError.
  void fill(std::string_view bytes);
  /// Takes the target's name. Throws FileError; then the target is as it was.
  void publish();

  // ---- for callers that may have to undo a change
  /// Instead of fill(): the target itself gets the draft's name. False when that failed, with errno.
  [[nodiscard]] bool take_target_aside() noexcept;
  /// publish(), but false when that failed, with errno.
  [[nodiscard]] bool try_publish() noexcept;
  /// Removes the target, which this draft was published as. False when that failed.
  [[nodiscard]] bool remove_published() const noexcept;
  /// Leaves the draft where it is, under its own name, which it returns.
  [[nodiscard]] std::string leave() noexcept { return std::exchange(name_, {}); }

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path target_;
  std::string shown_;
  std::string name_;  ///< empty when there is nothing to remove
  Descriptor file_;
};

/// Throws FileError: `shown` cannot be written because of `error`, and what to do.
[[noreturn]] void fail_to_write(const std::string& shown, int error);

}  // namespace restrip::files
