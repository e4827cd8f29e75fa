// The report of a command: text for people and the members of a JSON object, printed together at the end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/report_output.hpp"
#include "meshes/mend.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

struct Report {
  /// `file`: the argument of --json. Throws BadInput before the work if it cannot be written.
  explicit Report(const std::string& file) : out(file) {}

  void add(const Mended& mended) {
    text += as_text(mended);
    add_to(json, mended);
  }
  /// `name`: of the file that was written.
  void add(const WrittenStrips& written, const std::string& name) {
    text += as_text(written, name);
    add_to(json, written);
  }
  /// Names may contain bytes that are not UTF-8.
  [[nodiscard]] std::string json_text() const {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }
  void print() const { out.print(text, json_text()); }

  files::ReportOutput out;
  std::string text;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
};

}  // namespace restrip::tools
