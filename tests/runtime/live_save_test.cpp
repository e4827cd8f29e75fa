// A LiveMesh that was saved and loaded cannot be told from the one that was not, and damaged bytes are refused.
//
// Two programs do the same work on both for hundreds of frames, under each policy, cost and form: handles, refusals,
// counts and the bytes of the buffer are equal after every step. Damage is tried exhaustively on small files: every
// prefix, every byte; and with a matching checksum, so that it reaches the reader.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

#include "measure/check_buffer.hpp"
#include "random_operation.hpp"
#include "restrip/formats/baked_format.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/policy.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Bytes = std::vector<std::byte>;

/// Handles, corners, neighbours, colours and the next numbers; what is drawn; what has been counted.
void expect_equal(LiveMesh& one, LiveMesh& other) {
  ASSERT_EQ(look_at(one.mesh()), look_at(other.mesh()));
  ASSERT_TRUE(std::equal(one.bytes().begin(), one.bytes().end(), other.bytes().begin(), other.bytes().end()));
  ASSERT_EQ(one.index_bytes(), other.index_bytes());
  ASSERT_EQ(one.room(), other.room());
  ASSERT_EQ(one.rule_counts(), other.rule_counts());
  ASSERT_EQ(one.keeper().cost(), other.keeper().cost());
  std::vector<IndexRange> draws;
  std::vector<IndexRange> other_draws;
  one.buffer().draws(draws);
  other.buffer().draws(other_draws);
  ASSERT_EQ(draws, other_draws);
}

/// One operation, drawn from the state of the generator, so that two copies of the generator draw the same.
Checked operate_once(LiveMesh& live, std::mt19937& random) {
  const StripMesh& mesh = live.mesh();
  const DrawnOperation drawn = draw(mesh, random, all_operations, trend_between(0, 500, mesh.triangle_count()));
  return perform(live, drawn, random() % 9 == 0 ? static_cast<Vertex>(mesh.vertex_bound() + random() % 3) : none);
}

void frame(LiveMesh& live, std::mt19937& random, std::vector<Checked>& results) {
  for (auto operations = random() % 25; operations > 0; --operations) results.push_back(operate_once(live, random));
  if (random() % 5 == 0) live.improve(random() % 3000);
}

void expect_same_results(const std::vector<Checked>& one, const std::vector<Checked>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].refusal, other[i].refusal);
    ASSERT_EQ(one[i].rewrite.halfedge, other[i].rewrite.halfedge);
    ASSERT_EQ(one[i].new_vertex(), other[i].new_vertex());
    ASSERT_EQ(one[i].rewrite.strips, other[i].rewrite.strips);
  }
}

void live_on(const LiveOptions& options, unsigned seed, int frames) {
  std::mt19937 random(seed);
  const StripMesh start = random() % 2 == 0 ? sample::torus(12, 10) : sample::rectangle(12, 9);
  LiveMesh live(start, options);
  for (int i = 0; i < 20; ++i) {
    std::vector<Checked> results;
    frame(live, random, results);
    live.update();
  }
  LiveMesh loaded = LiveMesh::load(live.save(), options.history);
  expect_equal(live, loaded);
  live.update();  // the ranges of the frame that saving has ended
  for (int i = 0; i < frames && !testing::Test::HasFatalFailure(); ++i) {
    std::mt19937 same = random;
    std::vector<Checked> results;
    std::vector<Checked> other_results;
    frame(live, random, results);
    frame(loaded, same, other_results);
    expect_same_results(results, other_results);
    const Upload ranges = live.update();
    const Upload other_ranges = loaded.update();
    ASSERT_TRUE(std::equal(ranges.begin(), ranges.end(), other_ranges.begin(), other_ranges.end()));
    ASSERT_EQ(ranges.outgrown, other_ranges.outgrown);
    if (options.history != 0 && i > 2 && random() % 4 == 0) {
      ASSERT_EQ(live.undo(), loaded.undo());
      live.update();
      loaded.update();
    }
    expect_equal(live, loaded);
    if (i % 10 == 9) {
      loaded = LiveMesh::load(live.save(), options.history);
      if (options.history != 0) live = LiveMesh::load(loaded.save(), options.history);  // which forgets frames, too
    }
  }
}

TEST(LiveSave, ContinuesAsIfItHadNotBeenSaved) {
  unsigned seed = 0;
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices()})
      for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list}) {
        SCOPED_TRACE(testing::Message() << row.name << " cost " << cost.swap << " form " << int(form));
        const IndexWidth width = seed % 2 == 0 ? IndexWidth::automatic : IndexWidth::bits32;
        live_on({.policy = row.policy, .cost = cost, .history = seed % 3 * 1000, .format = {form, width}}, seed + 1,
                row.policy == Policy::best ? 6 : 40);
        ++seed;
        if (HasFatalFailure()) return;
      }
}

TEST(LiveSave, SavesInTheMiddleOfAFrameAndAfterUndo) {
  LiveMesh live(sample::torus(8, 8), {.history = 1000});
  ASSERT_TRUE(live.collapse(live.edge(0, 1)));
  LiveMesh loaded = LiveMesh::load(live.save());
  expect_equal(live, loaded);
  EXPECT_NE(live.update().size(), 0U);  // the caller has not seen the frame that saving has ended
  EXPECT_EQ(loaded.update().size(), 0U);
  ASSERT_TRUE(live.undo());
  loaded = LiveMesh::load(live.save());
  expect_equal(live, loaded);
  EXPECT_EQ(live.redoable(), 1U);
  EXPECT_EQ(loaded.undoable() + loaded.redoable(), 0U);
}

TEST(LiveSave, EmptyMeshesAndMarkedVertices) {
  LiveMesh empty(std::vector<std::uint32_t>{}, 0);
  LiveMesh loaded = LiveMesh::load(empty.save());
  EXPECT_EQ(loaded.mesh().triangle_count(), 0U);
  EXPECT_EQ(loaded.bytes().size(), 0U);
  // Three triangles at one edge.
  LiveMesh book(std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3, 0, 1, 4}, 9);
  loaded = LiveMesh::load(book.save());
  expect_equal(book, loaded);
  EXPECT_TRUE(loaded.mesh().non_manifold(0));
  EXPECT_FALSE(loaded.mesh().non_manifold(2));
}

// The format is the same on every machine: the bytes of one triangle.
TEST(LiveSave, BytesAreAsDocumented) {
  LiveMesh live(std::vector<std::uint32_t>{0, 1, 2}, 3, {.format = {.form = StripForm::list}});
  const Bytes bytes = live.save();
  std::vector<unsigned> numbers;
  for (const std::byte b : bytes) numbers.push_back(std::to_integer<unsigned>(b));
  const std::vector<unsigned> head{'R', 'e', 's', 't', 'r', 'i', 'p', 'L', 1, 0, 0, 0, 3, 3, 0, 1,   0,   0,   0,  3, 0,
                                   32,  0,   0,   0,   95,  0,   0,   0,   5, 0, 0, 0, 1, 0, 0, 0,   3,   0,   0,  0, 0,
                                   0,   0,   0,   0,   0,   0,   0,   1,   0, 0, 0, 2, 0, 0, 0, 254, 255, 255, 255};
  ASSERT_GT(numbers.size(), head.size());
  numbers.resize(head.size());
  EXPECT_EQ(numbers, head);
}

/// What load() says about these bytes; empty if it accepts them.
std::string refusal_of(std::span<const std::byte> bytes) {
  try {
    LiveMesh live = LiveMesh::load(bytes);
    EXPECT_EQ(fault_of(live.mesh()), "");
    EXPECT_TRUE(check_coloring(live.mesh()).valid);
    LiveBuffer buffer = live.buffer();
    EXPECT_TRUE(
        std::visit([&](const auto& indices) { return check_buffer(indices, live.mesh()); }, buffer.buffer()).right());
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// With a matching checksum.
Bytes sealed(Bytes bytes) {
  bytes.resize(bytes.size() - 8);
  std::uint64_t sum = baked_format::fnv1a(std::span<const std::byte>(bytes));
  for (int i = 0; i < 8; ++i, sum >>= 8) bytes.push_back(static_cast<std::byte>(sum & 0xFF));
  return bytes;
}

TEST(LiveSave, DamagedBytesAreRefused) {
  std::mt19937 random(7);
  for (const StripForm form : {StripForm::restart, StripForm::stitched, StripForm::list}) {
    LiveMesh live(sample::rectangle(4, 3), {.format = {.form = form}});
    for (int i = 0; i < 30; ++i) operate_once(live, random);
    const Bytes bytes = live.save();
    ASSERT_EQ(refusal_of(bytes), "");
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_NE(refusal_of(std::span(bytes).first(size)), "") << size;
    unsigned accepted = 0;
    unsigned refused = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at)
      for (const unsigned flip : {1U, 2U, 0x80U, 0xFFU}) {
        Bytes altered = bytes;
        altered[at] ^= static_cast<std::byte>(flip);
        ASSERT_NE(refusal_of(altered), "") << at;
        if (at + 8 < bytes.size()) ++(refusal_of(sealed(altered)).empty() ? accepted : refused);
      }
    // Weights, marks, counts and places of unused numbers may be different; corners and links may not.
    EXPECT_GT(refused, 3 * accepted);
    EXPECT_GT(accepted, 0U);
  }
}

TEST(LiveSave, RefusalsSayWhatIsWrong) {
  LiveMesh live(sample::rectangle(2, 2));
  const Bytes bytes = live.save();
  EXPECT_NE(refusal_of(Bytes(100)).find("not a saved LiveMesh"), std::string::npos);
  EXPECT_NE(refusal_of(std::span(bytes).first(11)).find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of(std::span(bytes).first(bytes.size() - 1)).find("checksum"), std::string::npos);
  Bytes other = bytes;
  other[8] = std::byte{2};
  EXPECT_NE(refusal_of(sealed(other)).find("version"), std::string::npos);
  other = bytes;
  other.insert(other.end() - 8, std::byte{0});
  EXPECT_NE(refusal_of(sealed(other)).find("too long"), std::string::npos);
  other = bytes;
  for (std::size_t i = 33; i < 37; ++i) other[i] = std::byte{0xFF};  // the number of triangles
  EXPECT_NE(refusal_of(sealed(other)).find("truncated"), std::string::npos);
}

}  // namespace
}  // namespace restrip
