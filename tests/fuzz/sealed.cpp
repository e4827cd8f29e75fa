#include "sealed.hpp"

#include <fmt/format.h>

#include "certificate/certificate_form.hpp"

namespace restrip::fuzz {

std::string sealed(std::string_view text) {
  const std::size_t end = text.rfind("end ");
  if (end == std::string_view::npos) return std::string(text);
  const std::string_view above = text.substr(0, end);
  const std::string_view rows = text.substr(end + 4, text.find(' ', end + 4) - end - 4);
  const verify::ByteSums sums = verify::sums_of(above);
  return fmt::format("{}end {} {} {}\n", above, rows, sums.plain, sums.weighted);
}

std::vector<std::string> lines_of(std::string_view text) {  // a stream would take a shortage of memory for the end
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at += lines.back().size() + 1)
    lines.emplace_back(text.substr(at, text.find('\n', at) - at));
  return lines;
}

}  // namespace restrip::fuzz
