#pragma once
// The whole verification: files, certificates, operations, compiled tables.

#include <string>
#include <vector>

#include "judge/report.hpp"
#include "model/family.hpp"

namespace restrip::verify {

struct Options {
  std::string tables_dir = "tables";
  std::string dump_command;  ///< prints the compiled tables; empty: not compared
  /// Each prints digests of the answers of a look-up in another language, which are compared with those of the tables.
  std::vector<std::string> digest_commands;
  std::string linked_dump_command;    ///< prints what the linked look-up picks; empty: not judged
  bool headers_only = false;          ///< no certificates are read: the dumps are judged by themselves
  std::vector<std::string> families;  ///< of certificates; empty: all
  unsigned threads = 2;
  unsigned max_k = largest_fan;  ///< tests use smaller tables
  bool show_progress = false;    ///< on standard error

  // Of an operation, or family, of a user's own, beside the dump command and what follows the families.
  std::string operation;           ///< the file that describes it
  std::string operation_text;      ///< and what is in it
  std::string certificate;         ///< the file with its rules; empty: none is checked
  std::string linked_certificate;  ///< the file with its linked rules, which are compared with the others; or empty
  std::string header;              ///< the table as the generator wrote it; empty: it is not read
};

/// Checks everything and hands each claim to the listener. InputError when a certificate or the manifest is not well
/// formed.
Totals verify_tables(const Options& options, const ClaimListener& listener);

/// Verifies the one family, or operation, that the file describes, and the answers of its dump command, whose header is
/// read before it is run. InputError when the description or a certificate is not well formed. Memory grows with 2 to
/// the number of inner edges and ports of a side: docs/reference/operation-file.md has figures.
Totals verify_operation(const Options& options, const ClaimListener& listener);

/// Whether the operation file describes a family. InputError as above.
bool has_family(const Options& options);

/// "verified: split-face.json: 20 rules, …", or "NOT verified: …".
std::string last_line_of(const Options& options, const Totals& totals);

}  // namespace restrip::verify
