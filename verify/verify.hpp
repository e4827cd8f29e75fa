#pragma once
// The whole verification: files, certificates, operations, compiled tables.

#include <string>
#include <vector>

#include "operation.hpp"
#include "report.hpp"

namespace restrip::verify {

struct Options {
  std::string tables_dir = "tables";
  std::string dump_command;           ///< prints the compiled tables; empty: not compared
  std::string linked_dump_command;    ///< prints what the linked look-up picks; empty: not judged
  bool headers_only = false;          ///< no certificates are read: the dumps are judged by themselves
  std::vector<std::string> families;  ///< of certificates; empty: all
  bool second_formulation = false;
  unsigned threads = 2;
  unsigned max_k = largest_fan;  ///< tests use smaller tables
  bool show_progress = false;    ///< on standard error
};

/// Checks everything and hands each claim to the listener. InputError when a certificate or the manifest is not well
/// formed.
Totals verify_tables(const Options& options, const ClaimListener& listener);

}  // namespace restrip::verify
