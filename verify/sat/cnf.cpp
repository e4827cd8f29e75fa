#include "sat/cnf.hpp"

#include <fmt/format.h>

#include <charconv>
#include <iterator>

#include "sat/number_reader.hpp"

namespace restrip::verify::sat {
namespace {

constexpr std::string_view header = "p cnf ";

Cnf sizes_of(const NumberReader& reader, std::string_view line, std::size_t& clauses) {
  Cnf cnf;
  const char* const end = line.data() + line.size();
  const auto variables = std::from_chars(line.data() + header.size(), end, cnf.variables);
  const bool goes_on = variables.ec == std::errc() && variables.ptr != end && *variables.ptr == ' ';
  if (!goes_on || cnf.variables < 0) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  const auto count = std::from_chars(variables.ptr + 1, end, clauses);
  if (count.ec != std::errc() || count.ptr != end) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  return cnf;
}

}  // namespace

std::string dimacs_of(const Cnf& cnf, const std::string& comment) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "c {}\np cnf {} {}\n", comment, cnf.variables, cnf.clauses.size());
  for (const Clause& clause : cnf.clauses) {
    for (const Literal literal : clause) fmt::format_to(std::back_inserter(text), "{} ", literal);
    fmt::format_to(std::back_inserter(text), "0\n");
  }
  return fmt::to_string(text);
}

Cnf parse_dimacs(const std::string& file, const std::string& text) {
  NumberReader reader(file, text);
  std::string_view line = reader.next_line();
  while (line.starts_with("c")) line = reader.next_line();
  if (!line.starts_with(header)) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  std::size_t announced = 0;
  Cnf cnf = sizes_of(reader, line, announced);
  while (!reader.at_end()) {
    line = reader.next_line();
    if (!line.starts_with("c")) cnf.clauses.push_back(reader.clause(line, cnf.variables));
  }
  if (cnf.clauses.size() != announced)
    reader.fail(fmt::format("{} clauses announced, {} found", announced, cnf.clauses.size()));
  return cnf;
}

}  // namespace restrip::verify::sat
