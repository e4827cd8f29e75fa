#pragma once
// What an operation file says (docs/reference/operation-file.md): one operation, or one for each position of a family,
// and the reader of such files.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/operation.hpp"

namespace restrip::verify {

inline constexpr unsigned longest_name = 60;
inline constexpr std::size_t most_numbers = 3;

/// Who wrote a file. Names that restrip's own tables have are for restrip's own families alone.
enum class Author { user, restrip };

struct DescriptionSource;  ///< the file as it was read: what depends on the position is read from it for each again

class Description {
 public:
  /// The one at this place in the list of a file. What depends on the numbers is read when they are known; here once,
  /// so that faults are found.
  Description(std::shared_ptr<const DescriptionSource> source, std::size_t place, Author author);

  std::string name;
  std::string about;        ///< a sentence; empty where none exists
  std::string certificate;  ///< the name of the certificate that has its rules
  std::vector<std::string> numbers;
  Conditions where;
  Conditions listed;
  std::string position;  ///< with the numbers' names in braces
  std::string section;   ///< the same of the section of the certificate; empty where it is the name
  bool linked = false;

  /// All its positions, those that are not listed included, in ascending order; those whose first number is at most
  /// `max_k`. Without numbers there is one.
  std::vector<Numbers> positions(unsigned max_k) const;
  /// InputError when the description says something impossible of this position.
  Operation at(const Numbers& values) const;
  /// Its patch after, which may depend on less than all the numbers.
  Side side_after(const Numbers& values) const;
  /// The numbers put in place of their names in braces.
  std::string filled(std::string text, const Numbers& values) const;
  /// True when the section does not name some number of the position: one rule for all of these positions.
  bool serves_every_position() const;
  const std::string& file() const;

 private:
  std::shared_ptr<const DescriptionSource> source_;
  std::size_t place_ = 0;  ///< in the list of the file
};

/// InputError "file:line:column: member: expected …" when anything is not as docs/reference/operation-file.md says.
std::vector<Description> parse_descriptions(const std::string& file, std::string_view text,
                                            Author author = Author::user);
/// Reads a file with one operation at one position.
Operation parse_operation(const std::string& file, std::string_view text);
/// The descriptions of the shipped file, in its order.
const std::vector<Description>& shipped_descriptions();

}  // namespace restrip::verify
