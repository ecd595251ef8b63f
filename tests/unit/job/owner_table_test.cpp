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
  const OwnerTable::News all = table.since(0);
  EXPECT_EQ(all.first, 0U);
  EXPECT_EQ(all.rows, (std::vector<OwnerRow>{{}, {{0, 10, 1}}, {{0, 12, 1}}}));
  EXPECT_TRUE(table.since(all.change).rows.empty());
}

TEST(OwnerTable, ATableWithoutCutsHasNobody) {
  const OwnerTable table;
  const OwnerTable::News all = table.since(0);
  EXPECT_EQ(all.rows, (std::vector<OwnerRow>{{}}));
  EXPECT_TRUE(table.since(all.change).rows.empty());
}

TEST(OwnerTable, ABlockHasTheLargestEngagementOfItsMotions) {
  OwnerTable table;
  table.add(1, {0, 10, 1}, 41.41);
  table.add(2, {0, 11, 1});
  table.add(3, {0, 12, 1}, 90);
  const std::uint64_t seen = table.since(0).change;
  table.add(4, {0, 10, 1}, 180);
  table.add(5, {0, 12, 1}, 60);
  EXPECT_EQ(table.since(0).rows,
            (std::vector<OwnerRow>{{}, {{0, 10, 1}, 180}, {{0, 11, 1}, 0}, {{0, 12, 1}, 90}}));
  const OwnerTable::News news = table.since(seen);
  EXPECT_EQ(news.first, 1U);
  EXPECT_EQ(news.rows, (std::vector<OwnerRow>{{{0, 10, 1}, 180}}));
}

TEST(OwnerTable, OnlyWhatHasChangedIsNew) {
  OwnerTable table;
  for (std::uint32_t i = 1; i <= 9; ++i) table.add(i, {0, i, 1}, 30);
  const std::uint64_t seen = table.since(0).change;
  table.add(10, {0, 4, 1}, 30.04);  // less than is told
  EXPECT_TRUE(table.since(seen).rows.empty());
  table.add(11, {0, 7, 1}, 31);
  table.add(12, {0, 5, 1}, 32);
  const OwnerTable::News news = table.since(seen);
  EXPECT_EQ(news.first, 5U);
  EXPECT_EQ(news.rows, (std::vector<OwnerRow>{{{0, 5, 1}, 32}, {{0, 6, 1}, 30}, {{0, 7, 1}, 31}}));
}

TEST(OwnerTable, MoreBlocksThanNumbersShareThem) {
  OwnerTable table;
  for (std::uint32_t i = 1; i <= 65535; ++i) table.add(i, {0, i, 1}, i % 2 == 0 ? 50 : 20);
  EXPECT_EQ(table.edition(), 0U);
  EXPECT_EQ(table.number(65535), 65535);
  table.add(65536, {0, 65536, 1});
  EXPECT_EQ(table.edition(), 1U);
  EXPECT_EQ(table.number(1), 1);
  EXPECT_EQ(table.number(2), 1);
  EXPECT_EQ(table.number(65536), 32768);
  EXPECT_EQ(table.owner(65536).line, 65536U);
  const auto rows = table.since(0).rows;
  EXPECT_EQ(rows.size(), 32769U);
  EXPECT_EQ(rows[1], (OwnerRow{{0, 1, 1}, 50}));
  EXPECT_EQ(rows.back(), (OwnerRow{{0, 65535, 1}, 20}));
}

}  // namespace
}  // namespace kerf::job
