#include "module.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "common/reading.hpp"

std::map<std::string, std::string>& restrip::maker::memory_files() {
  static std::map<std::string, std::string> files;
  return files;
}

std::string restrip::files::read_whole(const std::filesystem::path& file, const ReadLimits& limits) {
  const auto found = maker::memory_files().find(file.string());
  if (found == maker::memory_files().end()) throw FileError(file.string() + ": no such file; check the path");
  if (found->second.size() > limits.regular)
    throw FileError(file.string() + ": is larger than the limit for a file; cut it into pieces");
  return found->second;
}

// No process can be started.
extern "C" FILE* popen(const char* /*command*/, const char* /*mode*/) { return nullptr; }
extern "C" int pclose(FILE* /*stream*/) { return -1; }

#define MAKER_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace {

std::string answer;

/// The member `files` of a request has the files that the command reads, by name. If the command throws, the answer has
/// its sentence as `error`.
template <class Command>
void run(char* request, std::uint32_t bytes, const Command& command) {
  nlohmann::ordered_json out;
  try {
    const nlohmann::json asked = nlohmann::json::parse(std::string_view(request, bytes));
    std::free(request);
    auto& files = restrip::maker::memory_files();
    files.clear();
    for (const auto& [name, text] : asked.at("files").items()) files[name] = text.get<std::string>();
    out = command(asked);
  } catch (const std::exception& error) {
    out = {{"error", error.what()}};
  }
  answer = out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

MAKER_EXPORT(maker_take)
void* maker_take(std::uint32_t bytes) { return std::malloc(bytes); }

MAKER_EXPORT(maker_generate)
void maker_generate(char* request, std::uint32_t bytes) { run(request, bytes, restrip::maker::generated); }
MAKER_EXPORT(maker_judge)
void maker_judge(char* request, std::uint32_t bytes) { run(request, bytes, restrip::maker::judged); }

MAKER_EXPORT(maker_text)
const char* maker_text() { return answer.data(); }
MAKER_EXPORT(maker_size)
std::uint32_t maker_size() { return static_cast<std::uint32_t>(answer.size()); }
