#include "output/picture/internal/turned_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "plot_motions.hpp"

namespace kerf::output::plot {
namespace {

using namespace testing;

// A lathe's path: places are (x, z), x a radius.
struct Lathe {
  motion::AxisSetup setup = lathe_axes();
  PathRecorder recorder{setup};

  Lathe& rapid(double x, double z) { return take(motion::Rapid{at(x, z)}); }
  Lathe& cut(double x, double z) { return take(motion::Line{at(x, z), {}}); }
  Lathe& arc(double x, double z, double centre_x, double centre_z) {
    motion::Arc arc;
    arc.plane = motion::Plane::zx;
    arc.to = at(x, z);
    arc.center = {centre_z, centre_x};
    return take(arc);
  }
  Lathe& take(const motion::Motion::Action& action) {
    recorder.take(motion(action));
    return *this;
  }

  // From z = -100 to 100, columns of 0.1 mm.
  [[nodiscard]] TurnedProfile profile(const TurningInsert& insert) const {
    const std::vector<TurningInsert> inserts(recorder.tools().size(), insert);
    return {recorder.store().path(), inserts, -100, 100, 2000};
  }
};

TurnedProfile::Column at_z(const TurnedProfile& profile, double z) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < profile.columns().size(); ++i) {
    if (std::abs(profile.z_of(i) - z) < std::abs(profile.z_of(nearest) - z)) nearest = i;
  }
  return profile.columns()[nearest];
}

double outer_at(const TurnedProfile& profile, double z) { return at_z(profile, z).outer; }

TEST(TurnedProfile, LeavesWhatTheDeepestCutReachedOnCylindersAndTapers) {
  const Lathe lathe = Lathe().rapid(30, 2).cut(30, -50).rapid(20, 2).cut(20, -20).cut(26, -32);
  const TurnedProfile profile = lathe.profile({});
  EXPECT_EQ(outer_at(profile, -10.05), 20);
  EXPECT_NEAR(outer_at(profile, -26.05), 20 + 6.05 / 2, 1e-9);
  EXPECT_EQ(outer_at(profile, -40.05), 30);
  EXPECT_FALSE(at_z(profile, -50.15).has_material());
}

// A nose of radius R that goes down a taper of slope 1 leaves the fillet of its round, and on the
// taper the line that touches it.
TEST(TurnedProfile, AnEdgeIsRoundAboutTheNose) {
  TurningInsert insert;
  insert.nose_mm = 2;
  insert.tip_known = true;  // towards -z and -x: the centre is 2 mm to the right and above
  const Lathe lathe = Lathe().rapid(20, 10).cut(20, -30).cut(30, -30).rapid(30, 10);
  const TurnedProfile profile = lathe.profile(insert);
  EXPECT_NEAR(outer_at(profile, -10.05), 20, 1e-12);  // beside the wall as programmed
  for (const double z : {-29.95, -29.45, -28.75, -28.05}) {
    const double aside = z + 28;
    EXPECT_NEAR(outer_at(profile, z), 22 - std::sqrt(4 - aside * aside), 1e-9) << z;
  }
  const Lathe taper = Lathe().rapid(20, 0).cut(30, -10);
  const double r = outer_at(taper.profile(insert), -5.05);  // centre (z + 2, x + 2), touched below
  EXPECT_NEAR(r, 25.05 + 4 - 2 * std::sqrt(2.0), 1e-9);
}

TEST(TurnedProfile, ArcsAreThoseOfTheCircle) {
  const Lathe lathe = Lathe().rapid(0, 10).arc(10, 0, 0, 0);  // a ball end of radius 10 at z = 0
  const TurnedProfile profile = lathe.profile({});
  // Within a column the deepest place counts.
  for (const double z : {0.05, 3.05, 7.05, 9.05})
    EXPECT_NEAR(outer_at(profile, z), std::sqrt(100 - z * z),
                0.05 * z / std::sqrt(100 - z * z) + 0.02)
        << z;
}

TEST(TurnedProfile, BoresAreTheLargestThatAnEdgeReached) {
  TurningInsert boring;
  boring.inside = true;
  boring.tip = {-1, 1};
  const Lathe lathe =
      Lathe().rapid(8, 2).cut(8, -30).rapid(7, 2).rapid(10, 2).cut(10, -20).rapid(6, -20);
  const TurnedProfile profile = lathe.profile(boring);
  EXPECT_EQ(at_z(profile, -10.05).inner, 10);
  EXPECT_EQ(at_z(profile, -25.05).inner, 8);
  EXPECT_GT(at_z(profile, -10.05).outer, 10);  // some stock is around it
}

TEST(TurnedProfile, ABladeCutsAsWideAsItIs) {
  TurningInsert blade;
  blade.kind = TurningInsert::Kind::blade;
  blade.width_mm = 4;
  const Lathe lathe = Lathe().rapid(30, -20).cut(15, -20);
  const TurnedProfile profile = lathe.profile(blade);
  EXPECT_EQ(outer_at(profile, -19.95), 15);
  EXPECT_EQ(outer_at(profile, -16.15), 15);
  EXPECT_FALSE(at_z(profile, -15.85).has_material());
  EXPECT_FALSE(at_z(profile, -20.15).has_material());
}

TEST(TurnedProfile, WhatLiesInFrontOfAFaceIsAir) {
  const Lathe lathe = Lathe().rapid(30, 0).cut(-0.5, 0).rapid(30, 3).rapid(20, 3).cut(20, -50);
  const TurnedProfile profile = lathe.profile({});
  EXPECT_EQ(outer_at(profile, -0.15), 20);
  EXPECT_FALSE(at_z(profile, 1).has_material());
}

TEST(TurnedProfile, APartThatIsCutOffStays) {
  const Lathe lathe = Lathe().rapid(20, 0).cut(20, -52).rapid(30, -50).cut(0, -50);
  const TurnedProfile profile = lathe.profile({});
  EXPECT_EQ(outer_at(profile, -25.05), 20);
  EXPECT_FALSE(at_z(profile, -49.95).has_material() && at_z(profile, -50.05).has_material());
  EXPECT_EQ(outer_at(profile, -1.05), 20);
}

TEST(TurnedProfile, AThreadHasFlanksOfSixtyDegrees) {
  const Lathe lathe = Lathe().rapid(10, 0).cut(10, -30);
  TurnedProfile profile = lathe.profile({});
  profile.cut_thread({{9, 0, 0}, {9, 0, -20}, 2});
  EXPECT_NEAR(outer_at(profile, -6.05), 9 + 0.05 * std::sqrt(3.0), 1e-9);  // beside a root
  EXPECT_EQ(outer_at(profile, -7.05), 10);                                 // on a crest
  EXPECT_EQ(outer_at(profile, -26.05), 10);                                // behind the thread
}

TEST(TurnedProfile, LongPathsAreFollowedAsSimplifiedOnes) {
  Lathe lathe;
  for (int pass = 0; pass < 40'000; ++pass) {
    const double x = 50 - pass * 0.0005;
    lathe.rapid(x, 2).cut(x, -60).rapid(x + 1, 2);
  }
  EXPECT_NEAR(outer_at(lathe.profile({}), -30.05), 30, 0.1);
}

}  // namespace
}  // namespace kerf::output::plot
