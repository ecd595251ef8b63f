#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "features/edit/contour_edit.hpp"
#include "features/tree/normal_form.hpp"

/// Shapes and expectations of the tests that edit contours.
namespace kerf::features::test {

using base::Code;
using contour::Contour;
using contour::Edge;
using contour::Vec2;
using Vertices = std::vector<contour::Vertex>;

inline constexpr double kSixDecimals = 0.6e-6;
inline constexpr double kQuarter = 0.41421356237309503;  // bulge of a quarter of a circle

inline Contour closed(Vertices vertices) { return {std::move(vertices), true}; }
inline Contour open(Vertices vertices) { return {std::move(vertices), false}; }

/// 40 × 28, its corners 0 to 3 from the lower left one on.
inline Contour pocket() { return closed({{{10, 10}}, {{50, 10}}, {{50, 38}}, {{10, 38}}}); }
inline Contour disc(Vec2 centre, double radius) {
  return closed({{centre - Vec2{radius, 0}, 1}, {centre + Vec2{radius, 0}, 1}});
}

inline ContourEdit edit_of(const Contour& outer, const std::vector<Contour>& islands = {}) {
  return ContourEdit({normal_form(outer), islands});
}

inline void apply(ContourEdit& edit, const EditOperation& operation,
                  std::optional<std::size_t> island = {}) {
  const auto done = edit.apply(operation, island);
  EXPECT_TRUE(done) << done.error().sentence;
}

inline void expect_refused(const Editing<void>& done, Code code, const std::string& sentence) {
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, code);
  EXPECT_EQ(done.error().sentence, sentence);
}

inline void expect_fault(const ContourEdit& edit, Code code, const std::string& sentence) {
  const auto finished = edit.finished();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().code, code);
  EXPECT_EQ(finished.error().sentence, sentence);
}

/// Vertex for vertex, from the same one on.
inline void expect_contour(const Contour& actual, const Contour& expected,
                           double within = kSixDecimals) {
  const Contour normal = normal_form(expected);
  ASSERT_EQ(actual.vertices.size(), normal.vertices.size());
  for (std::size_t i = 0; i < normal.vertices.size(); ++i) {
    EXPECT_NEAR(actual.vertices[i].point.u, normal.vertices[i].point.u, within) << i;
    EXPECT_NEAR(actual.vertices[i].point.v, normal.vertices[i].point.v, within) << i;
    const bool has_edge = actual.is_closed || i + 1 < normal.vertices.size();
    const double bulge = has_edge ? actual.vertices[i].bulge : normal.vertices[i].bulge;
    EXPECT_NEAR(bulge, normal.vertices[i].bulge, within) << i;
  }
}

inline void expect_outer(const ContourEdit& edit, const Contour& expected,
                         double within = kSixDecimals) {
  const auto finished = edit.finished();
  ASSERT_TRUE(finished) << finished.error().sentence;
  expect_contour(finished->outer, expected, within);
}

}  // namespace kerf::features::test
