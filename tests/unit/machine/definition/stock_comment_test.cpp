#include "machine/definition/stock_comment.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace kerf::machine {
namespace {

std::optional<CommentedStock> stock_in(const std::string& text, double mm_per_unit = 1) {
  return stock_in_comments(*base::SourceFile::from_text("-", text), mm_per_unit);
}

TEST(StockComment, SaysWhatTheOptionWouldSay) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"O1\n(WORKPIECE,BOX,XMIN=0,YMIN=-5.,ZMIN=-20,XMAX=100,YMAX=60,ZMAX=0)\n",
       "box:0,-5,-20,100,60,0"},
      {"(workpiece, cylinder, axis=z, x=1, y=2, zmin=-20, zmax=0, diameter=50)",
       "cylinder:Z,1,2,-20,0,50"},
      {"(WORKPIECE,CYLINDER,AXIS=X,XMIN=0,XMAX=80,Y=3,Z=-10,DIAMETER=20)",
       "cylinder:X,3,-10,0,80,20"},
      {"(WORKPIECE,TUBE,ZMIN=-20,ZMAX=0,DIAMETER=50,INNER_DIAMETER=20)", "tube:Z,0,0,-20,0,50,20"},
      {"G20\n(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-1,XMAX=4,YMAX=2,ZMAX=0)",
       "box:0,0,-25.4,101.6,50.8,0"},
      {"(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-1,XMAX=4,YMAX=2,ZMAX=0)\nG20\n",
       "box:0,0,-25.4,101.6,50.8,0"},
      {"(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-1,XMAX=4,YMAX=2,ZMAX=0)\n(WORKPIECE,TUBE)",
       "box:0,0,-1,4,2,0"},
  };
  for (const auto& [program, word] : cases) {
    const auto stock = stock_in(program);
    ASSERT_TRUE(stock && stock->word) << program << (stock ? stock->wrong : "");
    EXPECT_EQ(stock->said, word);
    EXPECT_TRUE(stock->wrong.empty());
  }
  EXPECT_EQ(stock_in("(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-1,XMAX=1,YMAX=1,ZMAX=0)", 25.4)->said,
            "box:0,0,-25.4,25.4,25.4,0");
}

TEST(StockComment, WhatIsNoneSaysWhy) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"(WORKPIECE,BOX,XMIN=0)", "WORKPIECE needs a number for YMIN"},
      {"(WORKPIECE,BOX,XMIN=A,YMIN=0,ZMIN=-1,XMAX=4,YMAX=2,ZMAX=0)",
       "WORKPIECE needs a number for XMIN"},
      {"(WORKPIECE,CONE,DIAMETER=2)",
       "there is no WORKPIECE of this kind: BOX, CYLINDER or TUBE is expected"},
      {"(WORKPIECE,CYLINDER,AXIS=C,ZMIN=0,ZMAX=1,DIAMETER=2)", "AXIS of WORKPIECE is X, Y or Z"},
      {"(WORKPIECE,CYLINDER,ZMIN=3,ZMAX=1,DIAMETER=2)",
       "WORKPIECE cylinder:Z,0,0,3,1,2: W0 must lie below W1"},
      {"(WORKPIECE,)", "there is no WORKPIECE of this kind: BOX, CYLINDER or TUBE is expected"},
  };
  for (const auto& [program, sentence] : cases) {
    const auto stock = stock_in("%\n" + program);
    ASSERT_TRUE(stock) << program;
    EXPECT_FALSE(stock->word);
    EXPECT_EQ(stock->line, 2U);
    EXPECT_EQ(stock->wrong, sentence);
  }
}

TEST(StockComment, OtherCommentsAreNone) {
  for (const char* const text :
       {"", "(ATTACH THE WORKPIECE)", "(WORKPIECES,BOX)", "WORKPIECE,BOX", "(WORKPIECE)"})
    EXPECT_FALSE(stock_in(text)) << text;
}

}  // namespace
}  // namespace kerf::machine
