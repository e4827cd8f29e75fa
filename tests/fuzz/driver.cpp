// The fuzzer of plain builds. It has the command line of libFuzzer (-runs=N, -seed=N, files and folders to try first)
// and makes random changes without feedback, the same on every machine. With --allocations, every allocation of reading
// each seed fails in turn.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "common/random.hpp"
#include "support/failing_new.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

using tools::Random;

std::string altered(std::string bytes, const std::string& other, Random& random) {
  const auto below = [&](std::size_t bound) { return random.below(static_cast<std::uint32_t>(bound)); };
  for (std::uint32_t change = 0, changes = 1 + random.below(4); change < changes && !bytes.empty(); ++change) {
    const std::size_t at = below(bytes.size());
    switch (random.below(9)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << random.below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + random.below(8));
        break;
      case 3:
        bytes.insert(at, std::string(1 + random.below(4), "0123456789abcdef-./\n eE\xFF\\"[random.below(26)]));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:  // a piece from another place in it
        bytes.insert(at, bytes.substr(below(bytes.size()), random.below(40)));
        break;
      case 6:  // a piece of another seed
        if (!other.empty()) bytes.replace(at, random.below(40), other.substr(below(other.size()), random.below(40)));
        break;
      case 7: {  // a line repeated or removed
        const std::size_t start = bytes.rfind('\n', at) + 1;
        const std::size_t size = std::min(bytes.find('\n', at), bytes.size() - 1) + 1 - start;
        const std::string line = bytes.substr(start, size);
        bytes.replace(start, size, random.below(2) == 0 ? "" : line + line);
        break;
      }
      default:  // an extreme number
        for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
          bytes[at + i] = static_cast<char>(random.below(2) == 0 ? 0xFF : 0x7F);
    }
  }
  return bytes;
}

struct Counts {
  unsigned accepted = 0;
  unsigned refused = 0;
};

/// False if the reader broke its promise; the bytes are then saved.
bool run(const std::string& bytes, Counts& counts) {
  const std::string kept = "fuzz-" + chosen_target().name + ".bytes";
  try {
    // A copy of exactly this size, so that sanitizers detect reads beyond it.
    const std::vector<char> copy(bytes.begin(), bytes.end());
    ++(chosen_target().read({copy.data(), copy.size()}) ? counts.accepted : counts.refused);
    return true;
  } catch (const std::exception& error) {
    std::ofstream(kept, std::ios::binary) << bytes;
    std::fprintf(stderr, "restrip-fuzz: %s; the bytes are in %s\n", error.what(), kept.c_str());
    return false;
  }
}

bool fuzz(unsigned runs, std::uint64_t seed, const std::vector<std::string>& found_before) {
  const Target& target = chosen_target();
  Counts counts;
  for (const std::string& bytes : target.seeds)
    if (!run(bytes, counts)) return false;
  if (counts.refused != 0) {
    std::fprintf(stderr, "restrip-fuzz: %s refuses a seed\n", target.name.c_str());
    return false;
  }
  for (const std::string& bytes : found_before)
    if (!run(bytes, counts)) return false;
  Random random(seed);
  const auto any = [&]() -> const std::string& {
    return target.seeds[random.below(static_cast<std::uint32_t>(target.seeds.size()))];
  };
  for (unsigned i = 0; i < runs; ++i)
    if (!run(altered(any(), any(), random), counts)) return false;
  std::printf("%s: seed %llu, %u accepted, %u refused\n", target.name.c_str(), static_cast<unsigned long long>(seed),
              counts.accepted, counts.refused);
  // A fuzzer whose inputs all have the same outcome tests nothing.
  return runs == 0 || (counts.accepted > target.seeds.size() && counts.refused > 0);
}

bool fail_allocations() {
  for (const std::string& bytes : chosen_target().seeds) {
    Counts counts;
    std::size_t failures = 0;
    const std::size_t allocations = testing_support::for_each_allocation(
        [&] { ++(chosen_target().read(bytes) ? counts.accepted : counts.refused); }, [&] { ++failures; });
    // Accepted if memory sufficed or the library manages without (std::stable_sort); a shortage is never reported as a
    // bad file.
    std::printf("%s: %zu allocations, %zu failures, %u accepted, %u refused\n", chosen_target().name.c_str(),
                allocations, failures, counts.accepted, counts.refused);
    if (allocations == 0 || failures != 2 * allocations || counts.accepted < 1 || counts.refused != 0) return false;
  }
  return true;
}

}  // namespace
}  // namespace restrip::fuzz

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  LLVMFuzzerInitialize(&argc, &argv);
  unsigned runs = restrip::fuzz::chosen_target().runs;
  std::uint64_t seed = 1;
  bool allocations = false;
  std::vector<std::string> found_before;
  const auto add = [&](const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    found_before.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  };
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--allocations") allocations = true;
    if (argument.starts_with("-runs=")) runs = static_cast<unsigned>(std::stoul(argument.substr(6)));
    if (argument.starts_with("-seed=")) seed = std::stoull(argument.substr(6));
    if (argument.starts_with("-")) continue;
    if (fs::is_directory(argument))
      for (const auto& entry : fs::directory_iterator(argument)) add(entry);
    else
      add(argument);
  }
  return (allocations ? restrip::fuzz::fail_allocations() : restrip::fuzz::fuzz(runs, seed, found_before)) ? 0 : 1;
}
