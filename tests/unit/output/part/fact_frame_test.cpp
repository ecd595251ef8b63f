// What frames tell of places besides where they are, byte by byte.
#include "output/part/fact_frame.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

namespace kerf::output {
namespace {

/// A number of a part, little endian.
template <class Number>
Number at(const std::string& part, std::size_t place) {
  static_assert(std::endian::native == std::endian::little);
  Number number;
  std::memcpy(&number, part.data() + place, sizeof number);
  return number;
}

constexpr std::size_t kHead = 24;

TEST(FactFrame, APartIsNamedByItsTileAndPaddedToFourBytes) {
  const std::vector<std::uint16_t> owners{1, 65535, 7};
  const std::string part = owner_part({3, -2, 5}, owners);
  ASSERT_EQ(part.size(), kHead + 8);
  EXPECT_EQ(at<std::int32_t>(part, 0), 3);
  EXPECT_EQ(at<std::int32_t>(part, 4), -2);
  EXPECT_EQ(at<std::int32_t>(part, 8), 5);
  EXPECT_EQ(at<std::uint16_t>(part, 12), 1);
  EXPECT_EQ(at<std::uint32_t>(part, 16), 3U);
  for (std::size_t i = 0; i < owners.size(); ++i)
    EXPECT_EQ(at<std::uint16_t>(part, kHead + 2 * i), owners[i]);
}

TEST(FactFrame, DeviationsAreRightToHalfAStepOfTheirLargest) {
  const std::vector<std::optional<float>> deviations{0.0F, -0.2F, 0.1F, 31.7F, -0.0004F};
  const std::string part = deviation_part({0, 0, 0}, deviations);
  ASSERT_EQ(part.size(), kHead + 12);
  EXPECT_EQ(at<std::uint16_t>(part, 12), 0);
  const double step = at<float>(part, 20);
  EXPECT_NEAR(step, 31.7 / 32767, 1e-9);
  for (std::size_t i = 0; i < deviations.size(); ++i)
    EXPECT_NEAR(step * at<std::int16_t>(part, kHead + 2 * i), double{*deviations[i]}, 0.51 * step);
}

TEST(FactFrame, WhatIsNotKnownIsNoNumberOfTheScale) {
  const std::vector<std::optional<float>> deviations{std::nullopt, -2.0F};
  const std::string part = deviation_part({0, 0, 0}, deviations);
  EXPECT_EQ(at<std::int16_t>(part, kHead), -32768);
  EXPECT_EQ(at<std::int16_t>(part, kHead + 2), -32767);
}

TEST(FactFrame, WherePlacesLieOnTheDesignTheScaleIsNone) {
  const std::vector<std::optional<float>> deviations{0.0F, std::nullopt};
  const std::string part = deviation_part({0, 0, 0}, deviations);
  EXPECT_EQ(at<float>(part, 20), 0.0F);
  EXPECT_EQ(at<std::int16_t>(part, kHead), 0);
  EXPECT_EQ(at<std::int16_t>(part, kHead + 2), -32768);
}

TEST(FactFrame, PlacesOfALoopLieInTheHalfPlaneOfXAndZ) {
  const contour::Contour loop{{{{-9, 0}}, {{0, 4}}, {{-9, 4}}}};
  const PartPlaces places = loop_places(loop);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(*places[1], (geometry::Vec3{4, 0, 0}));
  EXPECT_EQ(*places[2], (geometry::Vec3{4, 0, -9}));
}

}  // namespace
}  // namespace kerf::output
