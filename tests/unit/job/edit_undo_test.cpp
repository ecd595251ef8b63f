#include "job/edit_undo.hpp"

#include <gtest/gtest.h>

#include "base/checksum.hpp"
#include "job/facts_of_edit.hpp"
#include "job/text_changes.hpp"
#include "output/features/edit_report.hpp"

namespace kerf::job {
namespace {

// An edit of a text by changes, told as a report and taken back by that.
void expect_way_back(const std::string& before, const std::vector<TextChange>& changes) {
  const auto stretches = stretches_of(before, changes);
  ASSERT_TRUE(stretches.has_value()) << "line " << stretches.error();
  const std::string after = with_stretches(before, *stretches);
  EditResult result;
  result.texts.push_back({"part.nc", true, before, after});
  result.report.changes = changes;
  result.report.crc32 = base::crc32(after);
  const auto undos = read_edit_report(output::edit_report_json(facts_of(result)));
  ASSERT_TRUE(undos.has_value()) << undos.error();
  ASSERT_EQ(undos->size(), 1U);
  const auto back = undo_of(undos->front(), after);
  ASSERT_TRUE(back.has_value()) << "line " << back.error().line;
  EXPECT_EQ(with_stretches(after, *back), before);
}

TEST(EditUndo, GivesEveryByteBack) {
  const std::string file = "part.nc";
  expect_way_back("A\nB\nC\n", {{file, 2, {"B\n"}, {"X\n", "Y\n"}}, {file, 3, {"C\n"}, {}}});
  expect_way_back("A\r\nB\r\nC", {{file, 1, {}, {"0\r\n"}}, {file, 3, {"C"}, {"C\r\n", "D"}}});
  expect_way_back("A\rB\rC\r", {{file, 2, {"B\r"}, {"X\r"}}});
  expect_way_back("%\n(\xe4)\nM30\n%", {{file, 2, {"(\xe4)\n"}, {"(\xf6\xff)\n"}}});
  expect_way_back("(\xc3\xa4)\nM30\n", {{file, 1, {"(\xc3\xa4)\n"}, {}}});
  expect_way_back(std::string("A\0B\nC\n", 6), {{file, 2, {"C\n"}, {"\x7f\x01\n"}}});
}

TEST(EditUndo, SaysWhereATextIsAnother) {
  const TextUndo undo{.file = "part.nc",
                      .crc32 = base::crc32("A\nX\nC\n"),
                      .changes = {{"part.nc", 2, {"B\n"}, {"X\n"}}}};
  ASSERT_TRUE(undo_of(undo, "A\nX\nC\n").has_value());
  EXPECT_EQ(undo_of(undo, "A\nB\nC\n").error().line, 2U);
  EXPECT_EQ(undo_of(undo, "A\n").error().line, 2U);
  EXPECT_EQ(undo_of(undo, "").error().line, 2U);
  EXPECT_EQ(undo_of(undo, "A\nX\nD\n").error().line, 0U);  // the checksum alone
}

TEST(EditUndo, TellsTextsApart) {
  const auto undos = read_edit_report(
      R"({"kerf":"edit","version":1,"crc32":"0000000a","libraries":[{"file":"lib/o1","crc32":"0000000b"}],)"
      R"("changes":[{"file":"lib/o1","first":1,"old":["A\n"],"new":[]},)"
      R"({"file":"part.nc","first":4,"old":[],"new":["B\n"]}]})");
  ASSERT_TRUE(undos.has_value()) << undos.error();
  ASSERT_EQ(undos->size(), 2U);
  EXPECT_EQ((*undos)[0].file, "part.nc");
  EXPECT_EQ((*undos)[0].crc32, 10U);
  EXPECT_EQ((*undos)[0].changes.front().first, 4U);
  EXPECT_EQ((*undos)[1].file, "lib/o1");
  EXPECT_FALSE((*undos)[1].is_main);
  EXPECT_EQ((*undos)[1].changes.front().old_lines, std::vector<std::string>{"A\n"});
}

TEST(EditUndo, RefusesWhatIsNoReport) {
  for (
      const char* text :
      {"", "{", "[]", "{}", R"({"kerf":"features","version":1})", R"({"kerf":"edit"})",
       R"({"kerf":"edit","version":2,"changes":[],"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":{},"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":[]})",
       R"({"kerf":"edit","version":1,"changes":[],"crc32":"123"})",
       R"({"kerf":"edit","version":1,"changes":[],"crc32":"0000000g"})",
       R"({"kerf":"edit","version":1,"changes":[],"crc32":7})",
       R"({"kerf":"edit","version":1,"changes":[1],"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":[{"file":"p","first":-1,"old":[],"new":[]}],"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":[{"file":"p","first":1,"old":[1],"new":[]}],"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":[{"file":"p","first":1,"old":["€"],"new":[],"encoding":"latin-1"}],"crc32":"00000000"})",
       R"({"kerf":"edit","version":1,"changes":[],"crc32":"00000000","libraries":7})"}) {
    const auto undos = read_edit_report(text);
    EXPECT_FALSE(undos.has_value()) << text;
    if (!undos) {
      EXPECT_FALSE(undos.error().empty()) << text;
    }
  }
}

TEST(EditUndo, ChangesComeInTheirOrder) {
  const std::vector<TextChange> wrong{{"p", 3, {"C\n"}, {}}, {"p", 1, {"A\n"}, {}}};
  EXPECT_EQ(stretches_of("A\nB\nC\n", wrong).error(), 1U);
  const std::vector<TextChange> beyond{{"p", 5, {}, {"D\n"}}};
  EXPECT_EQ(stretches_of("A\nB\nC\n", beyond).error(), 5U);
  const std::vector<TextChange> nowhere{{"p", 0, {}, {"D\n"}}};
  EXPECT_FALSE(stretches_of("A\n", nowhere).has_value());
}

}  // namespace
}  // namespace kerf::job
