#include "common/report_output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "common/file_error.hpp"
#include "common/printable.hpp"

namespace restrip::files {

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
