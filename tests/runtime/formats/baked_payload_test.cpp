// Each record has its own bytes of the payload, one after the other.
#include "restrip/formats/baked_payload.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace restrip {
namespace {

TEST(Payload, RecordsLieOneAfterTheOther) {
  BakedPayload payload{5, std::vector<std::byte>(35)};
  for (std::size_t i = 0; i < payload.all.size(); ++i) payload.all[i] = static_cast<std::byte>(i);
  for (std::size_t record = 0; record < 7; ++record) {
    ASSERT_EQ(payload[record].size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(std::to_integer<std::size_t>(payload[record][i]), 5 * record + i);
  }
  EXPECT_TRUE(BakedPayload{}[1000].empty()) << "without a payload each record has none";
}

}  // namespace
}  // namespace restrip
