#include "certificate/sums.hpp"

#include <algorithm>
#include <sstream>
#include <string>

namespace restrip::verify {

ByteSums sums_of(std::string_view bytes) {
  ByteSums sums;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    sums.plain += byte;
    sums.weighted += (i + 1) * byte;
  }
  return sums;
}

std::optional<BytePosition> altered_byte(std::string_view certificate) {
  if (certificate.size() < 2) return {};
  const std::size_t end = certificate.rfind('\n', certificate.size() - 2) + 1;
  const std::string_view body = certificate.substr(0, end);
  std::istringstream words{std::string(certificate.substr(end))};
  std::string word;
  std::uint64_t rows = 0;
  ByteSums stated;
  if (!(words >> word >> rows >> stated.plain >> stated.weighted) || word != "end") return {};

  // One byte that grew by d at number n adds d to one sum and n d to the other.
  const ByteSums found = sums_of(body);
  const auto grown = static_cast<std::int64_t>(found.plain - stated.plain);
  const auto weighted = static_cast<std::int64_t>(found.weighted - stated.weighted);
  const auto most = static_cast<std::int64_t>(255 * body.size());
  if (grown == 0 || grown < -255 || grown > 255 || weighted < -most || weighted > most || weighted % grown != 0)
    return {};
  const std::int64_t number = weighted / grown;
  if (number < 1 || number > static_cast<std::int64_t>(body.size())) return {};
  const std::string_view before = body.substr(0, static_cast<std::size_t>(number - 1));
  const std::size_t line_start = before.rfind('\n') + 1;
  return BytePosition{static_cast<unsigned>(std::count(before.begin(), before.end(), '\n') + 1),
                      static_cast<unsigned>(before.size() - line_start + 1)};
}

}  // namespace restrip::verify
