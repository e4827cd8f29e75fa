// The whole verification: files, certificates, operations, compiled tables.
#pragma once

#include <string>
#include <vector>

#include "judge/report.hpp"
#include "model/description.hpp"

namespace restrip::verify {

struct Options {
  std::string tables_dir = "tables";
  std::string dump_command;  ///< prints the compiled tables; empty: not compared
  /// Programs that print digests of look-ups in other languages, which are compared with the tables.
  std::vector<std::string> digest_commands;
  bool headers_only = false;          ///< no certificates are read: the dumps are judged alone
  std::vector<std::string> families;  ///< of certificates; empty: all
  unsigned threads = 2;
  unsigned max_k = largest_fan;  ///< tests use smaller tables

  // For a custom operation or family; also used: the dump command and the options after the families.
  std::string operation;       ///< its description
  std::string operation_text;  ///< the content of that file
  std::string certificate;     ///< the file with its rules; empty: not checked
  std::string header;          ///< the table as written by the generator; empty: not read
};

/// Checks everything and reports each claim to the listener. Throws files::FileError if a certificate or the manifest
/// is malformed.
Totals verify_tables(const Options& options, const ClaimListener& listener);

/// Verifies the family or operation described by the file, and the answers of its dump command, whose header is checked
/// before it is run. Throws files::FileError if the description or a certificate is malformed. Memory grows with 2 to
/// the number of inner edges and ports of a side: docs/reference/operation-file.md has figures.
Totals verify_operation(const Options& options, const ClaimListener& listener);

/// Whether the operation file describes a family. Throws files::FileError as above.
bool has_family(const Options& options);

/// "verified: split-face.json: 20 rules, …", or "NOT verified: …".
std::string last_line_of(const Options& options, const Totals& totals);

}  // namespace restrip::verify
