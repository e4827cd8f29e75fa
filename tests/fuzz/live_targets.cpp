// A LiveMesh driven by bytes, and saved LiveMeshes, both with every oracle of tests/drive. Damaged saves are refused,
// or they load as a mesh that can be driven like any other; checksums are made to match, so that alterations reach the
// reader.
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "drive/driver.hpp"
#include "drive/live_subject.hpp"
#include "formats/baked_format.hpp"
#include "restrip/search/policy.hpp"
#include "target.hpp"

namespace restrip::fuzz {
namespace {

void drive_with_oracles(drive::Input& input, LiveMesh live, std::size_t history, const drive::Limits& limits) {
  drive::LiveSubject subject(std::move(live), history);
  drive::Oracles oracles(history, 24);
  drive::drive(input, subject, oracles.all(), limits);
}

/// False for a format that a LiveMesh refuses.
bool drive_live(std::string_view bytes) {
  drive::Input input(bytes);
  const LiveOptions options = drive::any_options(input);
  const drive::Triangles triangles = drive::any_mesh(input);
  std::size_t vertices = 0;
  for (const drive::Corners& corners : triangles)
    for (const std::uint32_t v : corners) vertices = std::max<std::size_t>(vertices, v % 16 == 0 ? v : v + 1);
  std::optional<LiveMesh> live;
  try {
    live.emplace(triangles, vertices, options);
  } catch (const std::invalid_argument&) {
    return false;
  }
  drive_with_oracles(input, std::move(*live), options.history, {});
  return true;
}

std::vector<std::byte> sealed(std::string_view text) {
  std::vector<std::byte> bytes(text.size());
  if (!text.empty()) std::memcpy(bytes.data(), text.data(), text.size());
  if (bytes.size() < 8) return bytes;
  const std::span<const std::byte> above = std::span(bytes).first(bytes.size() - 8);
  const std::uint64_t sum = baked_format::fnv1a(above);
  for (std::size_t i = 0; i < 8; ++i) bytes[above.size() + i] = static_cast<std::byte>(sum >> 8 * i & 0xFF);
  return bytes;
}

bool read_saved(std::string_view text) {
  constexpr std::size_t history = 100;
  std::optional<LiveMesh> live;
  try {
    live.emplace(LiveMesh::load(sealed(text), history));
  } catch (const std::invalid_argument&) {
    return false;
  } catch (const std::length_error&) {  // 16 bits are not enough
    return false;
  }
  promise(live->mesh().triangle_bound() <= 8 * text.size(), "memory is bounded by the file");
  const std::string bytes = drive::random_bytes(200, static_cast<std::uint32_t>(text.size()));
  drive::Input input(bytes);
  drive_with_oracles(input, std::move(*live), history, {.allocations_fail = false});
  return true;
}

std::string saved_mesh(const LiveOptions& options, std::uint32_t width) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t v = 0; v < width * (width + 1); ++v)
    if (v % (width + 1) != width)
      triangles.insert(triangles.end(), {v, v + 1, v + width + 2, v, v + width + 2, v + width + 1});
  LiveMesh live(triangles, (width + 1) * (width + 1), options);
  for (Triangle t = 0; t < 2 * width; t += 3) live.collapse(StripMesh::halfedge(t * 5 % (2 * width), t % 3));
  live.update();
  for (Triangle t = 0; t < width; ++t) live.bisect(StripMesh::halfedge(t, 1));
  const std::vector<std::byte> bytes = live.save();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<Target> live_targets() {
  std::vector<std::string> seeds;
  const auto add = [&](std::initializer_list<int> options, std::size_t length) {
    std::string bytes;
    for (const int option : options) bytes.push_back(static_cast<char>(option));
    seeds.push_back(bytes + drive::random_bytes(length, static_cast<std::uint32_t>(seeds.size())));
  };
  for (const int format : {0, 1, 2, 3, 8, 12})
    for (const int policy : {1, 2, 3, 4})
      for (const int mesh : {0, 3}) add({policy, 1, 3, format, 0, 0, mesh, 45}, 150);
  add({5, 0, 2, 4, 3, 0, 7, 30}, 300);
  add({0, 2, 0, 0, 134, 0, 5, 0}, 60);
  std::vector<std::string> saved;
  for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list})
    for (const IndexWidth bits : {IndexWidth::automatic, IndexWidth::bits32}) {
      const auto n = static_cast<std::uint32_t>(saved.size());
      saved.push_back(saved_mesh({.policy = policies[n % policies.size()].policy,
                                  .cost = n % 2 == 0 ? Cost::strips() : Cost::indices(),
                                  .format = {form, bits}},
                                 n + 1));
    }
  return {{"live", seeds, drive_live, 500}, {"saved", saved, read_saved, 3000}};
}

}  // namespace restrip::fuzz
