#pragma once
// The subcommands `explain` and `rules` of restrip-verify.

#include <CLI/CLI.hpp>
#include <string>

#include "model/formula.hpp"

namespace restrip::verify {

class ExplainCommand {
 public:
  explicit ExplainCommand(CLI::App& app);
  bool chosen() const { return command_->parsed(); }
  /// The exit code. Throws files::FileError and std::invalid_argument.
  int run() const;

 private:
  CLI::App* command_;
  std::string family_, operation_, before_, ports_, after_, ports_after_, svg_, json_;
  unsigned k_ = 0;
  Numbers at_;
};

class RulesCommand {
 public:
  explicit RulesCommand(CLI::App& app);
  bool chosen() const { return command_->parsed(); }
  /// As above.
  int run() const;

 private:
  CLI::App* command_;
  std::string file_, operation_, json_;
  std::size_t worst_ = 10;
  unsigned threads_ = 2;
};

}  // namespace restrip::verify
