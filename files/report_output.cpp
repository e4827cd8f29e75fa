#include "files/report_output.hpp"

#include <fmt/format.h>

#include <utility>

namespace restrip::files {

ReportOutput::ReportOutput(const std::string& json, std::vector<std::filesystem::path> inputs)
    : to_stdout_(json == "-") {
  if (!json.empty() && !to_stdout_) file_.emplace(json, OutputRules{{".json"}, std::move(inputs)});
}

void ReportOutput::print(std::string_view text, std::string_view json) const {
  if (to_stdout_) {
    fmt::print("{}", json);
    return;
  }
  if (file_) file_->write(json);
  fmt::print("{}", text);
}

}  // namespace restrip::files
