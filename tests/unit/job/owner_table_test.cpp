// Who cut a place, in numbers of 16 bits.
#include "job/live/owner_table.hpp"

#include <gtest/gtest.h>

namespace kerf::job {
namespace {

TEST(OwnerTable, BlocksHaveNumbersInTheOrderOfTheirFirstCut) {
  OwnerTable table;
  table.add(3, {0, 10, 1});
  table.add(5, {0, 12, 1});
  table.add(6, {0, 10, 1});
  EXPECT_EQ(table.number(3), 1);
  EXPECT_EQ(table.number(5), 2);
  EXPECT_EQ(table.number(6), 1);
  EXPECT_EQ(table.number(4), 0);
  EXPECT_EQ(table.number(1000), 0);
  EXPECT_EQ(table.numbered(0), (std::vector<PartOwner>{{}, {0, 10, 1}, {0, 12, 1}}));
  EXPECT_EQ(table.numbered(2), (std::vector<PartOwner>{{0, 12, 1}}));
}

TEST(OwnerTable, MoreBlocksThanNumbersShareThem) {
  OwnerTable table;
  for (std::uint32_t i = 1; i <= 65535; ++i) table.add(i, {0, i, 1});
  EXPECT_EQ(table.edition(), 0U);
  EXPECT_EQ(table.number(65535), 65535);
  table.add(65536, {0, 65536, 1});
  EXPECT_EQ(table.edition(), 1U);
  EXPECT_EQ(table.number(1), 1);
  EXPECT_EQ(table.number(2), 1);
  EXPECT_EQ(table.number(65536), 32768);
  EXPECT_EQ(table.owner(65536).line, 65536U);
  const auto rows = table.numbered(0);
  EXPECT_EQ(rows.size(), 32769U);
  EXPECT_EQ(rows.back().line, 65535U);
}

}  // namespace
}  // namespace kerf::job
