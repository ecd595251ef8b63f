#include "base/checksum.hpp"

#include <gtest/gtest.h>

namespace kerf::base {
namespace {

TEST(Checksum, IsThatOfZipFiles) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926U);
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(crc32(std::string_view("\xff\x00\x80", 3)), 0xac616edfU);
}

TEST(Checksum, HasEightDigits) {
  EXPECT_EQ(hex_text(0xcbf43926U), "cbf43926");
  EXPECT_EQ(hex_text(0x1fU), "0000001f");
}

}  // namespace
}  // namespace kerf::base
