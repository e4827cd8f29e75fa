#include "sat/solver.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <sstream>
#include <stdexcept>

#include "model/input.hpp"

namespace restrip::verify::sat {
namespace {

constexpr int exit_satisfiable = 10;  // of every solver since the competitions of 2002
constexpr int exit_unsatisfiable = 20;

/// The exit status; what the program prints goes to the file.
int run(std::vector<std::string> words, const std::string& output, const std::string& remedy) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error(fmt::format("{}: cannot be run: {}; {}", words.front(), std::strerror(error), remedy));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error(fmt::format("{}: {}", words.front(), std::strerror(errno)));
  if (!WIFEXITED(status))
    throw std::runtime_error(fmt::format("{}: ended by signal {}", words.front(), WTERMSIG(status)));
  return WEXITSTATUS(status);
}

std::vector<bool> model_in(const std::string& answer, const std::string& solver, int variables) {
  std::vector<bool> model(static_cast<std::size_t>(variables) + 1, false);
  std::istringstream lines(read_file(answer));
  bool complete = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("v ")) continue;
    std::istringstream numbers(line.substr(2));
    for (Literal literal = 0; numbers >> literal;) {
      complete = complete || literal == 0;
      if (literal > 0 && literal <= variables) model[static_cast<std::size_t>(literal)] = true;
    }
  }
  if (!complete) throw std::runtime_error(fmt::format("{}: said \"satisfiable\" and printed no assignment", solver));
  return model;
}

}  // namespace

Model solve(const std::string& solver, const std::string& formula, const std::string& proof, const std::string& answer,
            int variables) {
  const int status = run({solver, "-q", "--no-binary", formula, proof}, answer,
                         "install the package cadical, or name a solver with --solver");
  if (status == exit_unsatisfiable) return {};
  if (status == exit_satisfiable) return model_in(answer, solver, variables);
  throw std::runtime_error(fmt::format("{}: no answer for {} (exit status {}, expected {} or {})", solver, formula,
                                       status, exit_satisfiable, exit_unsatisfiable));
}

bool foreign_checker_agrees(const std::string& checker, const std::string& formula, const std::string& proof,
                            const std::string& answer) {
  const int status = run({checker, formula, proof}, answer, "name another with --checker, or leave it out to use ours");
  return status == 0 && read_file(answer).find("s VERIFIED") != std::string::npos;
}

}  // namespace restrip::verify::sat
