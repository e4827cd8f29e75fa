// Runs a compute shader on the first Vulkan device (VK_ICD_FILENAMES chooses it) with tables in binding 0, an output in
// binding 1 and positions in binding 2, and prints what it puts out.
//   driver_vulkan SHADER.spv K TABLES.bin…    the lines of digests, up to k = K for the first tables and up to k =
//   4
//                                             for the others, a line "== FILE" before each of those
//   driver_vulkan SHADER.spv automaton K TABLES.bin…     the same of automata, which are asked by keys
//   driver_vulkan SHADER.spv words N TABLES.bin     the N numbers that one invocation puts out
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "driver_vulkan: %s\n", what.c_str());
  std::exit(1);
}

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS) fail(std::string(what) + " gave " + std::to_string(result));
}

std::vector<std::uint32_t> words_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (bytes.empty() || bytes.size() % 4 != 0) fail(std::string(path) + " is not there, or no file of words");
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

struct Position {
  std::uint32_t operation, k, p, q;
};

/// All that digests are printed of, and one that counts rules outside the tables. Of collapses beyond k = 6 only the
/// first, unless RESTRIP_EVERY_POSITION is set.
std::vector<Position> positions_up_to(std::uint32_t max_k) {
  const bool every = std::getenv("RESTRIP_EVERY_POSITION") != nullptr;
  std::vector<Position> all;
  for (std::uint32_t operation = 0; operation < 6; ++operation)
    for (std::uint32_t k = operation < 2 ? 3 : 1; k <= max_k; ++k) {
      const std::size_t before = all.size();
      for (std::uint32_t p = operation < 2 ? 1 : 0; p < k + (operation < 2 ? 0 : 1); ++p) {
        if (operation / 2 != 1) all.push_back({operation, k, p, 0});
        for (std::uint32_t q = p + 1; operation / 2 == 1 && q <= k; ++q) all.push_back({operation, k, p, q});
      }
      if (operation % 2 == 1 && k > 6 && !every) all.resize(before + 1);
    }
  all.push_back({6, 0, 0, 0});
  all.push_back({7, 0, 0, 0});
  return all;
}

/// The same for automata, whose answers after a collapse depend on k alone.
std::vector<Position> positions_of_automaton(std::uint32_t max_k) {
  std::vector<Position> all;
  for (const std::uint32_t operation : {0U, 1U, 2U, 3U, 4U})
    for (std::uint32_t k = operation < 2 ? 3 : 1; k <= max_k; ++k) {
      const std::uint32_t last = operation == 0 || operation == 2 ? k - 1 : operation == 4 ? k : 0;
      for (std::uint32_t p = operation == 0 ? 1 : 0; p <= last; ++p) {
        if (operation != 2) all.push_back({operation, k, p, 0});
        for (std::uint32_t q = p + 1; operation == 2 && q <= k; ++q) all.push_back({operation, k, p, q});
      }
    }
  all.push_back({7, 0, 0, 0});
  return all;
}

/// A device with one queue that computes, and what it takes to run one shader on it. Nothing is freed: the program
/// ends.
class Computer {
 public:
  explicit Computer(const std::vector<std::uint32_t>& shader) {
    const VkApplicationInfo application{
        VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, nullptr, 0, nullptr, 0, VK_API_VERSION_1_0};
    VkInstanceCreateInfo instance_info{};
    instance_info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    instance_info.pApplicationInfo = &application;
    VkInstance instance{};
    check(vkCreateInstance(&instance_info, nullptr, &instance), "vkCreateInstance");
    std::uint32_t count = 1;
    const VkResult found = vkEnumeratePhysicalDevices(instance, &count, &physical_);
    if ((found != VK_SUCCESS && found != VK_INCOMPLETE) || count == 0) fail("there is no Vulkan device");
    std::uint32_t families = 8;
    std::array<VkQueueFamilyProperties, 8> properties{};
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &families, properties.data());
    std::uint32_t family = 0;
    while (family < families && (properties[family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) ++family;
    if (family == families) fail("no queue of the device computes");
    const float priority = 1;
    VkDeviceQueueCreateInfo queue_info{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, family, 1, &priority};
    VkDeviceCreateInfo device_info{};
    device_info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    device_info.queueCreateInfoCount = 1;
    device_info.pQueueCreateInfos = &queue_info;
    check(vkCreateDevice(physical_, &device_info, nullptr, &device_), "vkCreateDevice");
    vkGetDeviceQueue(device_, family, 0, &queue_);
    make_pipeline(shader);
    const VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0, family};
    check(vkCreateCommandPool(device_, &pool_info, nullptr, &pool_), "vkCreateCommandPool");
  }

  std::vector<std::uint32_t> run(const std::vector<std::uint32_t>& tables, const std::vector<Position>& positions,
                                 std::size_t results, std::uint32_t groups) {
    std::vector<std::uint32_t> places(4 * positions.size());
    std::memcpy(places.data(), positions.data(), 4 * places.size());
    const std::array<Memory, 3> buffers{buffer_of(tables), buffer_of(std::vector<std::uint32_t>(results, 0)),
                                        buffer_of(places)};
    std::array<VkDescriptorBufferInfo, 3> infos{};
    std::array<VkWriteDescriptorSet, 3> writes{};
    for (std::uint32_t i = 0; i < 3; ++i) {
      infos[i] = {buffers[i].buffer, 0, VK_WHOLE_SIZE};
      writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      writes[i].dstSet = set_;
      writes[i].dstBinding = i;
      writes[i].descriptorCount = 1;
      writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
      writes[i].pBufferInfo = &infos[i];
    }
    vkUpdateDescriptorSets(device_, 3, writes.data(), 0, nullptr);
    const VkCommandBufferAllocateInfo command_info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_,
                                                   VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    VkCommandBuffer commands{};
    check(vkAllocateCommandBuffers(device_, &command_info, &commands), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
    vkCmdDispatch(commands, groups, static_cast<std::uint32_t>(positions.size()), 1);
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_SHADER_WRITE_BIT,
                            VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
    std::vector<std::uint32_t> output(results);
    std::memcpy(output.data(), buffers[1].mapped, 4 * results);
    return output;
  }

 private:
  struct Memory {
    VkBuffer buffer{};
    void* mapped = nullptr;
  };

  Memory buffer_of(const std::vector<std::uint32_t>& words) {
    Memory made;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = 4 * words.size();
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    check(vkCreateBuffer(device_, &info, nullptr, &made.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device_, made.buffer, &needs);
    VkPhysicalDeviceMemoryProperties properties{};
    vkGetPhysicalDeviceMemoryProperties(physical_, &properties);
    constexpr VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    std::uint32_t type = 0;
    while (type < properties.memoryTypeCount && ((needs.memoryTypeBits >> type & 1U) == 0 ||
                                                 (properties.memoryTypes[type].propertyFlags & wanted) != wanted))
      ++type;
    if (type == properties.memoryTypeCount) fail("the device has no memory that the host sees");
    const VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
    VkDeviceMemory memory{};
    check(vkAllocateMemory(device_, &allocate, nullptr, &memory), "vkAllocateMemory");
    check(vkBindBufferMemory(device_, made.buffer, memory, 0), "vkBindBufferMemory");
    check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "vkMapMemory");
    std::memcpy(made.mapped, words.data(), 4 * words.size());
    return made;
  }

  void make_pipeline(const std::vector<std::uint32_t>& shader) {
    std::array<VkDescriptorSetLayoutBinding, 3> bindings{};
    for (std::uint32_t i = 0; i < 3; ++i)
      bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    const VkDescriptorSetLayoutCreateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, nullptr, 0, 3,
                                                   bindings.data()};
    VkDescriptorSetLayout set_layout{};
    check(vkCreateDescriptorSetLayout(device_, &set_info, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
    const VkPipelineLayoutCreateInfo layout_info{
        VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, nullptr, 0, 1, &set_layout, 0, nullptr};
    check(vkCreatePipelineLayout(device_, &layout_info, nullptr, &layout_), "vkCreatePipelineLayout");
    const VkShaderModuleCreateInfo module_info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, nullptr, 0,
                                               4 * shader.size(), shader.data()};
    VkShaderModule module{};
    check(vkCreateShaderModule(device_, &module_info, nullptr, &module), "vkCreateShaderModule");
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = layout_;
    check(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), "vkCreateComputePipelines");
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 3};
    const VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, nullptr, 0, 1, 1, &size};
    VkDescriptorPool pool{};
    check(vkCreateDescriptorPool(device_, &pool_info, nullptr, &pool), "vkCreateDescriptorPool");
    const VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr, pool, 1,
                                               &set_layout};
    check(vkAllocateDescriptorSets(device_, &allocate, &set_), "vkAllocateDescriptorSets");
  }

  VkPhysicalDevice physical_{};
  VkDevice device_{};
  VkQueue queue_{};
  VkPipelineLayout layout_{};
  VkPipeline pipeline_{};
  VkDescriptorSet set_{};
  VkCommandPool pool_{};
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) fail("usage: driver_vulkan SHADER.spv K|automaton K|words N TABLES.bin...");
  Computer computer(words_of(argv[1]));
  if (std::string(argv[2]) == "words") {
    if (argc != 5) fail("words: expected their number and one file of tables");
    for (const std::uint32_t word :
         computer.run(words_of(argv[4]), {{0, 0, 0, 0}}, std::strtoul(argv[3], nullptr, 10), 1))
      std::printf("%u\n", word);
    return 0;
  }
  const bool automaton = std::string(argv[2]) == "automaton";
  const int first = automaton ? 4 : 3;
  auto max_k = static_cast<std::uint32_t>(std::strtoul(argv[first - 1], nullptr, 10));
  for (int i = first; i < argc; ++i) {
    if (i > first) std::printf("== %s\n", argv[i]);
    const std::vector<Position> positions = automaton ? positions_of_automaton(max_k) : positions_up_to(max_k);
    const std::vector<std::uint32_t> digests = computer.run(words_of(argv[i]), positions, positions.size(), 16);
    for (std::size_t at = 0; at < positions.size(); ++at) {
      const auto [operation, k, p, q] = positions[at];
      if (operation == 7)
        std::printf("rules outside the tables: %u\n", digests[at]);
      else
        std::printf("%u %u %u %u %08x\n", operation, k, p, q, digests[at]);
    }
    max_k = std::min(max_k, 4U);
  }
  return 0;
}
