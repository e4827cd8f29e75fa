// Reads baked meshes.
//
// Outline. The checksum is compared first. Then the base is built and coloured, and each record is played on it: names
// of vertices and edges count from places in the mesh as it is then, so a record can only be read on the mesh before
// it. The result is valid by construction, but for colours, which are checked at the base and at the finest level.
//
// The reader trusts nothing: every number is compared with its range, and announced sizes with the bytes that are left.
// Cost: linear in the bytes and the finest mesh.
#include "restrip/formats/baked_file.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "formats/baked_format.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

namespace {

/// Every function that reads returns false when it cannot continue; fault() then says why.
class BakedReader {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit BakedReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  /// The data before and after the records.
  struct Header {
    std::uint32_t points = 0;
    std::uint32_t triangles = 0;
    std::uint32_t splits = 0;
    std::uint32_t payload_bytes = 0;
    std::span<const std::byte> payload;
  };

  /// Checks the checksum and reads the header; base and records remain to be read.
  bool open() {
    using namespace baked_format;
    for (std::size_t i = 0; i < magic.size(); ++i)
      if (i >= rest_.size() || std::to_integer<char>(rest_[i]) != magic[i])
        return fail("this is not a baked mesh: it does not begin with '" + std::string(magic) + "'");
    if (rest_.size() < header_bytes + checksum_bytes)
      return fail("it ends inside its header: the file is not complete");
    const auto body = rest_.first(rest_.size() - checksum_bytes);
    rest_ = rest_.subspan(magic.size());
    std::uint32_t found = 0;
    if (!u32(found)) return false;
    if (found != version && found != version_with_payload)
      return fail("it is of version " + std::to_string(found) + ", and this program reads versions " +
                  std::to_string(version) + " and " + std::to_string(version_with_payload));
    BakedReader end(rest_.last(checksum_bytes));
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    if (!end.u32(low) || !end.u32(high) || (std::uint64_t{high} << 32 | low) != fnv1a(body))
      return fail("its checksum does not fit: the file is truncated or altered");
    rest_ = rest_.first(rest_.size() - checksum_bytes);
    if (!u32(header_.points) || !u32(header_.triangles) || !u32(header_.splits)) return false;
    if (found == version_with_payload && !u32(header_.payload_bytes)) return false;
    if (header_.payload_bytes == 0) return true;
    if (header_.splits > rest_.size() / header_.payload_bytes) return fail(promises_more);
    header_.payload = rest_.last(std::size_t{header_.splits} * header_.payload_bytes);
    rest_ = rest_.first(rest_.size() - header_.payload.size());
    return true;
  }

  bool run() {
    if (!open()) return false;
    const auto [points, triangles, splits, payload_bytes, payload] = header_;
    if (triangles == 0) return fail("its base has no triangles");
    // In 64 bits, so that nothing overflows if std::size_t has 32.
    if (std::uint64_t{points} * baked_format::point_bytes + std::uint64_t{triangles} * baked_format::triangle_bytes +
            std::uint64_t{splits} * baked_format::least_record_bytes >
        rest_.size())
      return fail(promises_more);
    file_.points.reserve(std::size_t{points} + splits);
    for (std::uint32_t v = 0; v < points; ++v)
      if (!point()) return false;
    if (!read_base(triangles, std::size_t{points} + splits)) return false;
    now_ = file_.mesh;
    now_.reserve(std::size_t{triangles} + 2 * std::size_t{splits}, std::size_t{points} + splits);
    file_.splits.reserve(splits);
    for (record_ = 0; record_ < splits; ++record_)
      if (!read_record()) return false;
    record_ = outside;
    if (!rest_.empty()) return fail("it continues after its last record");
    if (!check_coloring(now_).valid) return fail("the colours of its finest level are not valid");
    file_.payload = {payload_bytes, {payload.begin(), payload.end()}};
    return true;
  }
  [[nodiscard]] const Header& header() const noexcept { return header_; }
  [[nodiscard]] std::span<const std::byte> rest() const noexcept { return rest_; }
  [[nodiscard]] std::string& fault() noexcept { return fault_; }
  [[nodiscard]] BakedFile& file() noexcept { return file_; }

 private:
  static constexpr std::size_t outside = ~std::size_t{0};
  static constexpr std::string_view promises_more = "its header announces more data than the file holds";

  bool fail(std::string_view what) {
    if (record_ != outside) fault_ = "record " + std::to_string(record_) + ": ";
    fault_ += what;
    return false;
  }
  bool u8(std::uint8_t& value) {
    if (rest_.empty()) return fail("it ends too early");
    value = std::to_integer<std::uint8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return true;
  }
  bool u32(std::uint32_t& value) {
    value = 0;
    std::uint8_t byte = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
      if (!u8(byte)) return false;
      value |= std::uint32_t{byte} << shift;
    }
    return true;
  }
  bool number(std::uint64_t& value) {
    value = 0;
    std::uint8_t byte = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      if (!u8(byte)) return false;
      value |= std::uint64_t{byte & 127U} << shift;
      if (byte < 128) return true;
    }
    return fail("a number in it is too long");
  }
  /// Reads a vertex's place.
  bool point() {
    std::array<float, 3> p{};
    for (float& coordinate : p) {
      std::uint32_t bits = 0;
      if (!u32(bits)) return false;
      coordinate = std::bit_cast<float>(bits);
      if (!std::isfinite(coordinate)) return fail("a coordinate in it is infinite or not a number");
    }
    file_.points.push_back(p);
    return true;
  }

  bool read_base(std::size_t triangles, std::size_t fine_points) {
    file_.base.resize(triangles);
    for (std::array<Vertex, 3>& triangle : file_.base)
      for (Vertex& corner : triangle) {
        if (!u32(corner)) return false;
        if (corner >= file_.points.size()) return fail("a triangle of its base names a vertex that does not exist");
      }
    StripMesh& mesh = file_.mesh = StripMesh::build(file_.base, fine_points);
    if (mesh.triangle_count() != triangles) return fail("a triangle of its base is degenerate");
    std::vector<std::uint8_t> stored(triangles);
    for (Triangle t = 0; t < triangles; ++t) {
      if (!u8(stored[t])) return false;
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if ((stored[t] >> side & 1U) != 0 && !StripMesh::on_boundary(mesh.opposite(h))) mesh.set_solid(h, true);
      }
    }
    for (Triangle t = 0; t < triangles; ++t)
      if (mesh.solid_sides(t) != stored[t]) return fail("neighbours in its base disagree on a colour");
    if (!check_coloring(mesh).valid) return fail("the colours of its base are not valid");
    return true;
  }

  bool read_record() {
    const auto v_t = static_cast<Vertex>(file_.points.size());
    std::uint64_t v_s = 0;
    std::uint64_t apexes = 0;
    if (!point() || !number(v_s)) return false;
    if (v_s >= v_t || now_.spoke(static_cast<Vertex>(v_s)).id == none)
      return fail("it splits a vertex that does not exist");
    SplitRecord split{static_cast<Vertex>(v_s), v_t, none, none};
    baked_format::neighbors_of(now_, split.v_s, neighbors_);
    if (!number(apexes)) return false;
    const std::uint64_t radix = neighbors_.size() + 1;
    if (apexes == 0 || apexes / radix >= radix) return fail("its apexes are not neighbours of the split vertex");
    if (const auto left = static_cast<std::size_t>(apexes / radix); left != 0) split.v_l = neighbors_[left - 1];
    if (const auto right = static_cast<std::size_t>(apexes % radix); right != 0) split.v_r = neighbors_[right - 1];
    const auto where = spokes_of(now_, split);
    if (const Refusal refusal = check_split(now_, where); refusal != Refusal::granted) return fail(describe(refusal));
    if (!read_flips(split_baked(now_, where, {}, v_t).halfedge)) return false;
    const auto flips = file_.records[record_];
    flip_colors(now_, flips);
    for (const Halfedge h : flips)
      for (const Halfedge half : {h, now_.opposite(h)})
        if (now_.solid_degree(StripMesh::triangle(half)) > 2) return fail("it gives a triangle three solid edges");
    file_.splits.push_back(split);
    return true;
  }

  bool read_flips(Halfedge chord) {
    constexpr std::string_view nowhere = "it flips a dual edge that does not exist";
    std::vector<Halfedge>& flips = file_.records.flips;
    std::uint64_t head = 0;
    std::uint64_t step = 0;
    if (!number(head)) return false;
    order_.start(now_, chord);
    std::uint64_t next = 0;
    for (std::uint64_t n = head / 2; n > 0; --n, ++next) {
      if (!number(step)) return false;
      next += step;
      const Halfedge h = next < baked_format::near_edges ? order_.edge(static_cast<std::size_t>(next)) : Halfedge{none};
      if (h.id == none) return fail(nowhere);
      flips.push_back(baked_format::canonical(now_, h));
    }
    std::uint64_t skipped = 0;
    if (head % 2 != 0 && !number(skipped)) return false;
    next = 0;
    for (; skipped > 0; --skipped, ++next) {
      if (!number(step)) return false;
      next += step;
      if (next >= 3 * std::uint64_t{now_.triangle_bound()}) return fail(nowhere);
      const Halfedge h = StripMesh::halfedge(static_cast<Triangle>(next / 3), static_cast<unsigned>(next % 3));
      if (StripMesh::on_boundary(now_.opposite(h))) return fail(nowhere);
      flips.push_back(baked_format::canonical(now_, h));
    }
    file_.records.first.push_back(static_cast<std::uint32_t>(flips.size()));
    return true;
  }

  std::span<const std::byte> rest_;
  Header header_;
  std::size_t record_ = outside;  ///< that is being read
  std::string fault_;
  BakedFile file_;
  StripMesh now_;
  DualOrder order_;
  std::vector<Vertex> neighbors_;
};

}  // namespace

std::string read_baked(std::span<const std::byte> bytes, BakedFile& file) {
  BakedReader reader(bytes);
  if (!reader.run()) return std::move(reader.fault());
  file = std::move(reader.file());
  return {};
}

std::string set_payload(std::vector<std::byte>& file, std::span<const std::byte> payload) {
  using namespace baked_format;
  BakedReader reader(file);
  if (!reader.open()) return std::move(reader.fault());
  const auto& header = reader.header();
  const std::size_t records = header.splits;
  if (records == 0 ? !payload.empty() : payload.size() % records != 0)
    return "a payload of " + std::to_string(payload.size()) + " bytes does not have the same number for each of " +
           std::to_string(records) + " records";
  const std::size_t each = records == 0 ? 0 : payload.size() / records;
  if (each > (std::numeric_limits<std::uint32_t>::max)()) return "the payload has more than 2^32 - 1 bytes a record";
  std::vector<std::byte> bytes;
  bytes.reserve(header_bytes + 4 + reader.rest().size() + payload.size() + checksum_bytes);
  const auto put = [&bytes](std::uint64_t value, unsigned size) {
    for (unsigned i = 0; i < size; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFFU));
  };
  for (const char c : magic) bytes.push_back(static_cast<std::byte>(c));
  put(each == 0 ? version : version_with_payload, 4);
  for (const std::uint32_t count : {header.points, header.triangles, header.splits}) put(count, 4);
  if (each != 0) put(each, 4);
  for (const auto part : {reader.rest(), payload}) bytes.insert(bytes.end(), part.begin(), part.end());
  put(fnv1a(std::span<const std::byte>(bytes)), checksum_bytes);
  file = std::move(bytes);
  return {};
}

}  // namespace restrip
