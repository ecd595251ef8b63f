// A part that was saved is read back to the last bit, is cut on as if it had never been saved, and
// a file that is damaged is a sentence.
#include "stock/saved/part_file.hpp"

#include <gtest/gtest.h>

#include "parts.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/saved/saved_dexels.hpp"
#include "stock/saved/saved_field.hpp"
#include "stock/saved/saved_turned.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/turned/turned_job.hpp"

namespace kerf::stock::saved::test {
namespace {

const Bounds kBox{{-10.1, -7.3, -6}, {11.2, 8.4, 1.7}};
constexpr double kCell = 0.21;

field::FieldState state_of_field(const field::HeightField& model) {
  const auto part = part_of(file_of({.zero = "G54", .volume_mm3 = 1}, model)).part;
  return dynamic_cast<const SavedField&>(*part).state();
}

/// Both have the same volume, and the same further cuts leave the same.
template <typename Same>
void cut_on_alike(Model& whole, const SavedPart& saved, Same&& same) {
  const std::unique_ptr<Model> again = saved.model(2);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->left_mm3(), whole.left_mm3());
  EXPECT_EQ(again->stock_mm3(), again->left_mm3());
  same(*again);
  ASSERT_EQ(again->add_body(mill(5)), 0U);
  const std::vector<Sweep> more = level_sweeps(2, 40);
  cut_all(whole, more);
  cut_all(*again, more);
  same(*again);
}

void expect_same_field(const field::HeightField& a, const field::HeightField& b) {
  const field::Grid& grid = a.columns().grid();
  ASSERT_EQ(grid, b.columns().grid());
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      ASSERT_EQ(a.columns().height(i, j), b.columns().height(i, j)) << i << " " << j;
      ASSERT_EQ(a.columns().bottom(i, j), b.columns().bottom(i, j)) << i << " " << j;
    }
  }
}

TEST(PartFile, AHeightFieldIsReadBackToTheLastBitAndCutOn) {
  const auto round = [](double x, double y) -> field::Column {
    const double gone = (x * x + y * y) / 30;
    return gone > 5 ? field::Column{} : field::Column{-6 + gone, 1.7 - gone / 5};
  };
  const field::Grid grid = field::grid_of(kBox, kCell);
  for (const bool is_box : {true, false}) {
    field::HeightField model =
        is_box ? field::HeightField(grid, 1) : field::HeightField(grid, round, 1);
    ASSERT_EQ(model.add_body(mill(5)), 0U);
    cut_all(model, level_sweeps(1, 60));
    const ReadPart read = part_of(
        file_of({.zero = "G55", .volume_mm3 = 123.4567890123456, .made_by = {"O1", "É"}}, model));
    EXPECT_EQ(read.label.zero, "G55");
    EXPECT_EQ(read.label.volume_mm3, 123.4567890123456);
    EXPECT_EQ(read.label.made_by, (std::vector<std::string>{"O1", "É"}));
    ASSERT_EQ(read.part->kind(), SavedPart::Kind::field);
    EXPECT_EQ(read.part->box(), kBox);
    cut_on_alike(model, *read.part, [&](const Model& again) {
      expect_same_field(model, dynamic_cast<const field::HeightField&>(again));
    });
  }
}

TEST(PartFile, DexelsAreReadBackToTheLastBitAndCutOn) {
  dexel::TriDexel model(
      dexel::round_shape({.axis = 0, .b = 0.4, .c = -2, .low = -10, .high = 11, .radius_mm = 4}),
      0.3, 1);
  ASSERT_EQ(model.add_body(mill(5)), 0U);
  cut_all(model, level_sweeps(1, 40));
  const ReadPart read = part_of(file_of({.zero = "G54", .volume_mm3 = model.left_mm3()}, model));
  ASSERT_EQ(read.part->kind(), SavedPart::Kind::dexels);
  EXPECT_EQ(read.part->volume_mm3(), model.left_mm3());
  cut_on_alike(model, *read.part, [&](const Model& again) {
    EXPECT_EQ(state_of(dynamic_cast<const dexel::TriDexel&>(again), 0), state_of(model, 0));
  });
}

TEST(PartFile, ATurnedPartIsReadBackToTheLastBitAndCutOn) {
  turned::Job job(50, -80, 0);
  job.with(turned::turning(0.8)).at(60, 2).rapid(40, 2).to(40, -60).to(52, -66);
  const turned::TurnedThread thread{.axis = 'Z',
                                    .from = 0,
                                    .to = -30,
                                    .major = 30,
                                    .minor = 27.4,
                                    .pitch = 2,
                                    .volume_mm3 = 1339.5};
  const ReadPart read = part_of(file_of(
      {.zero = "G54", .volume_mm3 = job.part().left_mm3(), .threads = {thread}}, job.part()));
  ASSERT_EQ(read.label.threads.size(), 1U);
  EXPECT_EQ(read.label.threads[0].minor, 27.4);
  const std::unique_ptr<Model> again = read.part->model(1);
  EXPECT_EQ(again->left_mm3(), job.part().left_mm3());
  turned::Job on(dynamic_cast<const turned::TurnedPart&>(*again).region());
  for (turned::Job* const each : {&job, &on})
    each->with(turned::turning(0.4)).at(60, 5).rapid(20, 5).to(20, -10.3).to(60, -20);
  EXPECT_EQ(on.part().left_mm3(), job.part().left_mm3());
  EXPECT_EQ(on.part().region().loops.size(), job.part().region().loops.size());
}

TEST(PartFile, ASheetIsReadBackToTheLastBit) {
  const sheet::Grid grid = sheet::grid_of({{-10, -10}, {31, 30}}, 0.1);
  sheet::Sheet cut(grid, {.kerf_mm = 0.4, .spot_mm = 0.2});
  const std::vector<sheet::Trace> ways{sheet::straight({0, 0}, {20, 3}),
                                       sheet::round({5, 5}, 4, 0, 5)};
  cut.cut(ways);
  cut.burn(std::vector<sheet::Burn>{{{0, 0}, {20, 3}, 12.5}});
  const std::vector<SheetCut> cuts{{ways[0], 0.4}, {ways[1], 0.3}};
  const ReadPart read =
      part_of(file_of({.zero = "G54", .volume_mm3 = 7}, SheetPart{cut, cuts, 1.5}));
  const auto& part = dynamic_cast<const SavedSheet&>(*read.part);
  EXPECT_EQ(part.box(), (Bounds{{-10, -10, -1.5}, {31, 30, 0}}));
  ASSERT_EQ(part.state().cuts.size(), 2U);
  EXPECT_EQ(part.state().cuts[1].way, ways[1]);
  EXPECT_EQ(part.state().cuts[1].kerf_mm, 0.3);
  sheet::Sheet again(part.state().grid, {.kerf_mm = 0.4, .spot_mm = 0.2});
  ASSERT_TRUE(part.restore(again));
  EXPECT_EQ(again.cut_mm2(), cut.cut_mm2());
  EXPECT_EQ(again.peak_j_mm2(), cut.peak_j_mm2());
  EXPECT_EQ(again.energy_on_sheet_j(), cut.energy_on_sheet_j());
  EXPECT_EQ(again.touched_tiles(), cut.touched_tiles());
}

std::string small_part() {
  field::HeightField model(field::grid_of({{0, 0, -2}, {4, 3, 0}}, 0.5), 1);
  return file_of({.zero = "G54", .volume_mm3 = model.left_mm3(), .made_by = {"O1"}}, model);
}

std::string wrong(std::string_view bytes, std::size_t most_bytes = kRoom) {
  const auto read = read_bytes(bytes, most_bytes);
  if (read) return "it was read";
  EXPECT_EQ(read.error().kind, base::Failure::Kind::input);
  return read.error().message;
}

TEST(PartFile, WhatIsCutOffAnywhereIsRefused) {
  const std::string bytes = small_part();
  ASSERT_EQ(wrong(bytes), "it was read");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string sentence = wrong(std::string_view(bytes).substr(0, size));
    EXPECT_TRUE(sentence.starts_with("is damaged: ") || (size < 6 && sentence == "is no .kstock"))
        << size << ": " << sentence;
  }
  EXPECT_EQ(wrong(bytes + "x"), "is damaged: bytes follow its end");
}

TEST(PartFile, AByteThatIsAnotherIsFound) {
  const std::string bytes = small_part();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const int by : {1, 0x55, 0x80}) {
      std::string other = bytes;
      other[i] = static_cast<char>(other[i] ^ by);
      EXPECT_NE(wrong(other), "it was read") << i;
    }
  }
}

TEST(PartFile, SentencesSayWhatIsWrong) {
  const std::string bytes = small_part();
  EXPECT_EQ(wrong(""), "is no .kstock");
  EXPECT_EQ(wrong("solid cube"), "is no .kstock");
  EXPECT_EQ(wrong("KSTOCK2\n" + bytes.substr(8)),
            "was written by a newer Kerf: this one reads KSTOCK1");
  EXPECT_EQ(wrong("KSTOCK10" + bytes.substr(8)),
            "was written by a newer Kerf: this one reads KSTOCK1");
  EXPECT_EQ(wrong(bytes.substr(0, bytes.size() - 4) + "\1\2\3\4"),
            "is damaged: the sum over its bytes is wrong");
  EXPECT_EQ(wrong(bytes, 100), "needs more than the 0 MiB that there are for it");
}

TEST(PartFile, TheSamePartIsTheSameBytes) {
  EXPECT_EQ(small_part(), small_part());
  const std::string bytes = small_part();
  const ReadPart read = part_of(bytes);
  EXPECT_EQ(file_of(read.label, *read.part->model(1)), bytes);
}

TEST(PartFile, TheMotionsOfOneProgramAreNotThoseOfTheNext) {
  dexel::TriDexel model(dexel::box_shape(kBox), 0.5, 1);
  ASSERT_EQ(model.add_body(mill(5)), 0U);
  cut_all(model, level_sweeps(1, 20));
  const auto again = part_of(file_of({.zero = "G54", .volume_mm3 = 1}, model)).part->model(1);
  EXPECT_EQ(again->error_mm3(), 0);
  for (const dexel::DexelEnd& end :
       state_of(dynamic_cast<const dexel::TriDexel&>(*again), 0).tiles[2][0].ends)
    EXPECT_EQ(end.motion, 0U);
  field::HeightField field(field::grid_of(kBox, 0.5), 1);
  ASSERT_EQ(field.add_body(mill(5)), 0U);
  cut_all(field, level_sweeps(1, 20));
  const field::HeightField same(state_of_field(field), 1);
  EXPECT_EQ(same.columns().owner(3, 3), 0U);
}

}  // namespace
}  // namespace kerf::stock::saved::test
