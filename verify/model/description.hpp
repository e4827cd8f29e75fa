// The content of an operation file (docs/reference/operation-file.md): one operation, or a family with one operation
// per position; and its reader.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/json.hpp"
#include "model/side_reader.hpp"

namespace restrip::verify {

inline constexpr unsigned longest_name = 60;
inline constexpr std::size_t most_numbers = 3;

class Description {
 public:
  /// Parts that depend on the numbers are read when they are known; the constructor reads them once to find faults.
  Description(const JsonValue& value, Author author);

  std::string name;
  std::string about;        ///< a sentence; may be empty
  std::string certificate;  ///< the name of the certificate with its rules
  bool has_table = true;    ///< among the shipped tables; the automaton answers the other families
  std::vector<std::string> numbers;
  Conditions where;
  Conditions listed;
  std::string position;  ///< with the numbers' names in braces
  std::string section;   ///< the section of the certificate, in the same form; empty if it is the name

  /// All its positions, including unlisted ones, in ascending order, whose first number is at most `max_k`. Without
  /// numbers there is one position.
  std::vector<Numbers> positions(unsigned max_k) const;
  /// Throws files::FileError if the description is impossible at this position.
  Operation at(const Numbers& values) const;
  /// The side after of a fan, which may depend on fewer numbers.
  Side side_after(const Numbers& values) const;
  /// Replaces the names in braces by the numbers.
  std::string filled(std::string text, const Numbers& values) const;
  /// True if the section omits some number of the position: one rule for all of these positions.
  bool serves_every_position() const;
  const std::string& file() const;

 private:
  JsonValue value_;
  Author author_;
};

/// Throws files::FileError "file:line:column: member: expected …" if anything differs from
/// docs/reference/operation-file.md.
std::vector<Description> parse_descriptions(const std::string& file, std::string_view text,
                                            Author author = Author::user);
/// Reads a file with one operation at one position.
Operation parse_operation(const std::string& file, std::string_view text);
/// The descriptions of the shipped file, in its order.
const std::vector<Description>& shipped_descriptions();

}  // namespace restrip::verify
