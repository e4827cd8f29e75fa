// Runs a compute shader on the first Vulkan device (VK_ICD_FILENAMES chooses it) with tables in binding 0, an output in
// binding 1 and positions in binding 2, and prints the output.
//   driver_vulkan SHADER.spv LINES TABLES.bin…      the digests of the positions in LINES, which are those that
//                                                   restrip-dump-tables --digests prints; of more tables with more
//                                                   lines, a line "== FILE" before each of those
//   driver_vulkan SHADER.spv words N TABLES.bin     the N numbers that one invocation puts out
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace {

using Words = std::vector<std::uint32_t>;

Words words_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (bytes.empty() || bytes.size() % 4 != 0) throw std::runtime_error(path + " is not there, or no file of words");
  Words words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

struct Position {
  std::uint32_t operation, k, p, q;
};

/// For the lines of digests, plus one for the count of rules outside the tables in the last line.
std::vector<Position> positions_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<Position> all;
  std::string digest;
  for (Position at{}; file >> at.operation >> at.k >> at.p >> at.q >> digest;) all.push_back(at);
  if (all.empty()) throw std::runtime_error(path + " is not there, or has no lines of digests");
  all.push_back({7, 0, 0, 0});
  return all;
}

/// A device with one compute queue, and what is needed to run one shader on it. Nothing is freed, since the program
/// ends. Errors are thrown.
class Computer {
 public:
  explicit Computer(const Words& shader) {
    const vk::ApplicationInfo application({}, 0, {}, 0, VK_API_VERSION_1_0);
    const std::vector<vk::PhysicalDevice> found = vk::createInstance({{}, &application}).enumeratePhysicalDevices();
    if (found.empty()) throw std::runtime_error("no Vulkan device found");
    physical_ = found[0];
    const auto families = physical_.getQueueFamilyProperties();
    const auto computes = [](const auto& one) {
      return static_cast<bool>(one.queueFlags & vk::QueueFlagBits::eCompute);
    };
    const auto one = std::find_if(families.begin(), families.end(), computes);
    if (one == families.end()) throw std::runtime_error("no queue of the device computes");
    const auto family = static_cast<std::uint32_t>(one - families.begin());
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
    device_ = physical_.createDevice({{}, queue});
    queue_ = device_.getQueue(family, 0);
    pool_ = device_.createCommandPool({{}, family});
    std::array<vk::DescriptorSetLayoutBinding, 3> bindings;
    for (std::uint32_t i = 0; i < 3; ++i)
      bindings[i] = {i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute};
    const vk::DescriptorSetLayout layout = device_.createDescriptorSetLayout({{}, bindings});
    layout_ = device_.createPipelineLayout({{}, layout});
    const vk::ShaderModule module = device_.createShaderModule({{}, shader});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, module, "main");
    pipeline_ = device_.createComputePipeline({}, {{}, stage, layout_}).value;
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, 3);
    set_ = device_.allocateDescriptorSets({device_.createDescriptorPool({{}, 1, size}), layout})[0];
  }

  Words run(const Words& tables, const std::vector<Position>& positions, std::size_t results, std::uint32_t groups) {
    Words places(4 * positions.size());
    std::memcpy(places.data(), positions.data(), 4 * places.size());
    const std::array<Memory, 3> buffers{buffer_of(tables), buffer_of(Words(results, 0)), buffer_of(places)};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const vk::DescriptorBufferInfo info(buffers[i].buffer, 0, VK_WHOLE_SIZE);
      device_.updateDescriptorSets(vk::WriteDescriptorSet(set_, i, 0, vk::DescriptorType::eStorageBuffer, {}, info),
                                   {});
    }
    const vk::CommandBuffer commands = device_.allocateCommandBuffers({pool_, vk::CommandBufferLevel::ePrimary, 1})[0];
    commands.begin(vk::CommandBufferBeginInfo());
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline_);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, layout_, 0, set_, {});
    commands.dispatch(groups, static_cast<std::uint32_t>(positions.size()), 1);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             vk::MemoryBarrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead), {},
                             {});
    commands.end();
    queue_.submit(vk::SubmitInfo({}, {}, commands));
    queue_.waitIdle();
    Words output(results);
    std::memcpy(output.data(), buffers[1].mapped, 4 * results);
    return output;
  }

 private:
  struct Memory {
    vk::Buffer buffer;
    void* mapped = nullptr;
  };

  Memory buffer_of(const Words& words) {
    const vk::Buffer buffer = device_.createBuffer({{}, 4 * words.size(), vk::BufferUsageFlagBits::eStorageBuffer});
    const vk::MemoryRequirements needs = device_.getBufferMemoryRequirements(buffer);
    const vk::PhysicalDeviceMemoryProperties properties = physical_.getMemoryProperties();
    const vk::MemoryPropertyFlags wanted =
        vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    std::uint32_t type = 0;
    while (type < properties.memoryTypeCount && ((needs.memoryTypeBits >> type & 1U) == 0 ||
                                                 (properties.memoryTypes[type].propertyFlags & wanted) != wanted))
      ++type;
    if (type == properties.memoryTypeCount) throw std::runtime_error("the device has no memory that the host sees");
    const vk::DeviceMemory memory = device_.allocateMemory({needs.size, type});
    device_.bindBufferMemory(buffer, memory, 0);
    void* const mapped = device_.mapMemory(memory, 0, VK_WHOLE_SIZE);
    std::memcpy(mapped, words.data(), 4 * words.size());
    return {buffer, mapped};
  }

  vk::PhysicalDevice physical_;
  vk::Device device_;
  vk::Queue queue_;
  vk::CommandPool pool_;
  vk::PipelineLayout layout_;
  vk::Pipeline pipeline_;
  vk::DescriptorSet set_;
};

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> given(argv + 1, argv + argc);
  if (given.size() < 3)
    throw std::runtime_error("usage: driver_vulkan SHADER.spv LINES TABLES.bin..., or words N TABLES.bin");
  Computer computer(words_of(given[0]));
  if (given[1] == "words") {
    if (given.size() != 4) throw std::runtime_error("words: expected their number and one file of tables");
    for (const std::uint32_t word : computer.run(words_of(given[3]), {{0, 0, 0, 0}}, std::stoul(given[2]), 1))
      std::printf("%u\n", word);
    return 0;
  }
  for (std::size_t i = 1; i + 1 < given.size(); i += 2) {
    if (i > 1) std::printf("== %s\n", given[i + 1].c_str());
    const std::vector<Position> positions = positions_of(given[i]);
    const Words digests = computer.run(words_of(given[i + 1]), positions, positions.size(), 16);
    for (std::size_t at = 0; at < positions.size(); ++at) {
      const auto [operation, k, p, q] = positions[at];
      if (operation == 7)
        std::printf("rules outside the tables: %u\n", digests[at]);
      else
        std::printf("%u %u %u %u %08x\n", operation, k, p, q, digests[at]);
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "driver_vulkan: %s\n", error.what());
  return 1;
}
