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

// tables/families.json and a list of the files of tables/operations, embedded at build time (cmake/Embed.cmake).

extern const std::string_view families_text;
extern const std::string_view operations_text;

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

// The operations of a list of descriptions, each at one position, and the sections of certificates that serve them.

/// One section of a certificate and the operations that its rows serve, which share the patch after.
struct Section {
  std::string position;  ///< as the certificate writes it: "k 8"
  unsigned ports = 0;
  bool serves_every_position = false;  ///< it omits some number of the position: one rule for all values of it
  std::vector<Operation> operations;
};

/// The content of one certificate.
struct Family {
  std::string name;  ///< of the certificate
  std::vector<Section> sections;
  std::vector<Operation> unlisted;  ///< in positions that are images of positions in the sections
  bool has_table = true;            ///< of a shipped family: the shipped tables have its rules, not the automaton
};

/// The largest fan that the shipped tables cover.
inline constexpr unsigned largest_fan = 8;
/// The largest fan that can be judged.
inline constexpr unsigned largest_judged_fan = 10;

/// One for each certificate named in the descriptions, at the index of the last of its descriptions; positions whose
/// first number is at most `max_k`. Throws files::FileError if a description has no such position.
std::vector<Family> families_of(const std::vector<Description>& descriptions, unsigned max_k);
/// The families of the shipped descriptions, 3 <= max_k <= 10; and only those that have a table.
std::vector<Family> all_families(unsigned max_k = largest_fan);
std::vector<Family> tabled_families(unsigned max_k = largest_fan);

/// The patch after an operation of this shipped certificate; only the numbers on which it depends are needed.
Side patch_after(const std::string& certificate, const Numbers& numbers);

}  // namespace restrip::verify
