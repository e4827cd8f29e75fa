// The files of a module: what the page gives, and what the program writes. They replace the file system below
// common/reading.hpp and common/output.hpp, so that the commands run as they are.
#pragma once
#include <map>
#include <string>

namespace restrip::maker {

/// By name.
std::map<std::string, std::string>& memory_files();
/// The report of the last command: its text and its JSON.
struct Report {
  std::string text;
  std::string json;
};
Report& last_report();

}  // namespace restrip::maker
