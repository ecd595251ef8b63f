// Points made by hand: laser power and an arm under way.
#include "output/records/set_point_csv.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"

namespace kerf::output {
namespace {

std::string csv_of(const std::string& machine, const std::vector<motion::AxisPoint>& points) {
  const test::TemporaryFolder folder;
  auto file = std::move(*base::OutputFile::create(folder / "points.csv"));
  SetPointCsv csv(*machine::find_machine(machine), *file);
  for (const motion::AxisPoint& point : points) csv.take(point);
  EXPECT_TRUE(file->commit());
  return folder.read("points.csv");
}

motion::AxisPoint point(double time_s, const base::TipPoint& tip, const base::JointPoint& joints,
                        std::uint32_t line, float power_percent = 0) {
  motion::AxisPoint made{{time_s, tip, {}}, joints};
  made.tip.mark.block.line = line;
  made.power_percent = power_percent;
  return made;
}

TEST(SetPointCsv, PowerIsThatOfThePeriod) {
  const base::TipPoint at{{1, 2, 3}};
  const base::JointPoint joints(at.numbers());
  EXPECT_EQ(csv_of("laser3", {point(0.001, at, joints, 7), point(0.002, at, joints, 8, 33.3F),
                              point(0.003, at, joints, 8, 33.3F), point(0.004, at, joints, 9)}),
            "t,X,Y,Z,power,j1,j2,j3,line\n"
            "0.001,1,2,3,0,1,2,3,7\n0.002,1,2,3,33.3,1,2,3,8\n0.003,1,2,3,33.3,1,2,3,8\n"
            "0.004,1,2,3,0,1,2,3,9\n");
}

TEST(SetPointCsv, JointsOfTheArmStandBehindItsTip) {
  EXPECT_EQ(csv_of("arm4", {point(0.001, {{132, 132, 5, 20}}, {{-90, 90, 20, 5}}, 4),
                            point(0.002, {{132, 132, 5, 21}}, {{-90, 90, 21, 5}}, 4)}),
            "t,X,Y,Z,C,j1,j2,j3,j4,line\n"
            "0.001,132,132,5,20,-90,90,20,5,4\n0.002,132,132,5,21,-90,90,21,5,4\n");
}

TEST(SetPointCsv, AJointThatPassesTheTipKeepsItsOwnNumber) {
  EXPECT_EQ(csv_of("laser3", {point(0.001, {1}, {1}, 4), point(0.002, {2}, {1}, 4),
                              point(0.003, {2}, {2}, 4), point(0.004, {1}, {2}, 4)}),
            "t,X,Y,Z,power,j1,j2,j3,line\n"
            "0.001,1,0,0,0,1,0,0,4\n0.002,2,0,0,0,1,0,0,4\n"
            "0.003,2,0,0,0,2,0,0,4\n0.004,1,0,0,0,2,0,0,4\n");
}

TEST(SetPointCsv, SumsOfPeriodsAreTimesThatAPersonWouldWrite) {
  const std::string text = csv_of("mill3", {point(9 * 0.001, {}, {}, 1), point(1e-3 * 3, {}, {}, 1),
                                            point(123456.789, {}, {}, 1)});
  EXPECT_NE(text.find("\n0.009,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n0.003,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n123456.789,"), std::string::npos) << text;
}

}  // namespace
}  // namespace kerf::output
