#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "features/recognition.hpp"
#include "small_cam.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;
using test::Dice;
using test::FeaturePath;
using test::SmallCam;

constexpr double kBorder_mm = 1e-3;  // by which borders may differ
constexpr double kCell_mm = 100;     // a thing each, far from all others
constexpr int kThings = 6;

/// How many parts; the environment may want more.
std::uint64_t part_count() {
  const char* const wanted = std::getenv("KERF_FEATURE_PARTS");
  return wanted == nullptr ? 40 : std::strtoull(wanted, nullptr, 10);
}

Contour rectangle(Vec2 low, Vec2 high) {
  return {{{low}, {{high.u, low.v}}, {high}, {{low.u, high.v}}}, true};
}

Contour turned(Contour contour, Vec2 about, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  for (contour::Vertex& vertex : contour.vertices) {
    const Vec2 arm = vertex.point - about;
    vertex.point = about + Vec2{c * arm.u - s * arm.v, s * arm.u + c * arm.v};
  }
  return contour;
}

/// What a thing of the part should be recognised as.
struct Wanted {
  FeatureType type = FeatureType::pocket;
  bool is_hole = false;
  Region removed{};
  std::size_t layers = 1;
  double bottom = 0;
  std::size_t islands = 0;
  double diameter = 0;  // of a hole, a slot's width
  double length = 0;    // of a slot
  Vec2 at{};
};

/// Programs a part of random things and keeps what they are.
class PartMaker {
 public:
  explicit PartMaker(std::uint64_t seed) : dice_(seed) {
    tool_radius_ = dice_.between(2, 6);
    path_.spindle(3000).tool(1, 2 * tool_radius_);
  }

  void make() {
    for (int i = 0; i < kThings; ++i) {
      const Vec2 middle{kCell_mm * (i % 3 + 0.5), kCell_mm * (i / 3 + 0.5)};
      switch (dice_.below(6)) {
        case 0: pocket(middle, rectangle_at(middle)); break;
        case 1: pocket(middle, l_shape_at(middle)); break;
        case 2: pocket_with_island(middle); break;
        case 3: zig_zag(middle); break;
        case 4: slot(middle); break;
        default: hole(middle); break;
      }
    }
  }

  [[nodiscard]] const std::vector<Wanted>& wanted() const { return wanted_; }
  [[nodiscard]] const Recording& recording() const { return path_.recording(); }

 private:
  Contour rectangle_at(Vec2 middle) {
    const Vec2 half{dice_.between(2.5 * tool_radius_, 35), dice_.between(2.5 * tool_radius_, 35)};
    return turned(rectangle(middle - half, middle + half), middle, dice_.between(0, 3));
  }
  Contour l_shape_at(Vec2 middle) {
    const double a = dice_.between(2.2, 2.8) * tool_radius_;
    const double b = dice_.between(32, 40);
    const Vec2 low = middle - Vec2{b / 2, b / 2};
    const Contour l{{{low},
                     {low + Vec2{b, 0}},
                     {low + Vec2{b, a}},
                     {low + Vec2{a, a}},
                     {low + Vec2{a, b}},
                     {low + Vec2{0, b}}},
                    true};
    return turned(l, middle, dice_.between(0, 3));
  }

  void pocket(Vec2, const Contour& outline) { clear({{outline}}, 0); }

  void pocket_with_island(Vec2 middle) {
    const double radius = dice_.between(4, 10);
    const double half = radius + 2 * tool_radius_ + dice_.between(3, 12);
    const Region outer = {{rectangle(middle - Vec2{half, half}, middle + Vec2{half, half})}};
    clear(contour::subtract(outer, contour::disc(middle, radius)), 1);
  }

  void clear(const Region& region, std::size_t islands) {
    SmallCam cam(path_, tool_radius_);
    const auto way = dice_.tossed() ? SmallCam::Way::inside_out : SmallCam::Way::outside_in;
    const double step = dice_.between(0.4, 0.9) * tool_radius_;
    Wanted thing{
        .removed = cam.reachable(region), .layers = 1 + dice_.below(3), .islands = islands};
    for (std::size_t i = 0; i < thing.layers; ++i)
      cam.parallel(region, thing.bottom -= dice_.between(1, 3), step, way);
    wanted_.push_back(std::move(thing));
  }

  void zig_zag(Vec2 middle) {
    SmallCam cam(path_, tool_radius_);
    const Vec2 half{dice_.between(3 * tool_radius_, 35), dice_.between(3 * tool_radius_, 35)};
    Wanted thing{.removed = cam.reachable({{rectangle(middle - half, middle + half)}}),
                 .bottom = -2};
    cam.zig_zag(middle - half, middle + half, -2, dice_.between(0.8, 1.6) * tool_radius_);
    wanted_.push_back(std::move(thing));
  }

  void slot(Vec2 middle) {
    SmallCam cam(path_, tool_radius_);
    const double way = dice_.between(8, 60);
    const double angle = dice_.between(0, 6);
    const Vec2 arm = (way / 2) * Vec2{std::cos(angle), std::sin(angle)};
    const Contour line{{{middle - arm}, {middle + arm}}, false};
    cam.pass(line, -3);
    wanted_.push_back({.type = FeatureType::slot,
                       .removed = contour::sweep_of_disc(line, tool_radius_),
                       .bottom = -3,
                       .diameter = 2 * tool_radius_,
                       .length = way + 2 * tool_radius_});
  }

  // In one plunge, or peck by peck.
  void hole(Vec2 middle) {
    SmallCam cam(path_, tool_radius_);
    const std::size_t pecks = 1 + dice_.below(3);
    double bottom = 0;
    for (std::size_t i = 0; i < pecks; ++i) {
      cam.plunge(middle, bottom -= dice_.between(2, 5));
      cam.retract();
    }
    wanted_.push_back(
        {.is_hole = true, .bottom = bottom, .diameter = 2 * tool_radius_, .at = middle});
  }

  Dice dice_;
  double tool_radius_ = 0;
  FeaturePath path_;
  std::vector<Wanted> wanted_;
};

void expect_region(const Region& found, const Region& wanted) {
  const double off = contour::area(contour::symmetric_difference(found, wanted));
  EXPECT_LE(off, kBorder_mm * contour::length(wanted));
}

void expect_feature(const Feature& found, const Wanted& wanted) {
  EXPECT_EQ(found.type, wanted.type);
  EXPECT_NEAR(found.bottom, wanted.bottom, 1e-6);
  ASSERT_EQ(found.layers.size(), wanted.layers);
  for (const Layer& layer : found.layers) {
    expect_region(layer.removed, wanted.removed);
    EXPECT_EQ(layer.islands.size(), wanted.islands);
    EXPECT_NEAR(layer.area, contour::area(wanted.removed),
                kBorder_mm * contour::length(wanted.removed));
  }
  if (wanted.type != FeatureType::slot) return;
  EXPECT_NEAR(found.measures.width.value_or(0), wanted.diameter, kBorder_mm);
  EXPECT_NEAR(found.measures.length.value_or(0), wanted.length, kBorder_mm);
}

void expect_hole(const Hole& found, const Wanted& wanted) {
  EXPECT_NEAR(geometry::length(found.at - wanted.at), 0, kBorder_mm);
  EXPECT_NEAR(found.diameter, wanted.diameter, kBorder_mm);
  EXPECT_NEAR(found.bottom, wanted.bottom, 1e-6);
  EXPECT_NEAR(found.top, 0, 1e-6);
}

/// Every row at feed is part of a layer, a hole or a span that is told.
double told_length(const Recording& recording, const Tree& tree) {
  double sum = 0;
  for (const Feature& feature : tree.features) {
    for (const Layer& layer : feature.layers) {
      for (const Span& span : layer.cuts) sum += recording.length_of(span);
      for (const Span& span : layer.entries) sum += recording.length_of(span);
    }
  }
  for (const Hole& hole : tree.holes) {
    for (const HoleStep& step : hole.steps) {
      for (const Span& span : step.rows) sum += recording.length_of(span);
    }
  }
  for (const Unrecognised& span : tree.unrecognised) sum += span.cut_mm;
  return sum;
}

/// Goes anywhere by any moves.
void wander(Dice& dice, FeaturePath& path) {
  double x = 0;
  double y = 0;
  double z = 5;
  const auto jump = [&] {
    x = dice.between(-20, 20);
    y = dice.between(-20, 20);
  };
  for (std::uint64_t i = 5 + dice.below(60); i > 0; --i) {
    const auto direction =
        dice.tossed() ? motion::Direction::clockwise : motion::Direction::counterclockwise;
    const double old_x = x;
    const double old_y = y;
    switch (dice.below(9)) {
      case 0:
        jump();
        path.rapid(x, y, z);
        break;
      case 1: path.rapid(x, y, z = 5); break;
      case 2: path.line(x, y, z = -static_cast<double>(1 + dice.below(3))); break;
      case 3:
      case 4:
        jump();
        path.line(x, y, z);
        break;
      case 5:
        jump();
        path.line(x, y, z = dice.between(-4, 1));
        break;
      case 6: path.arc(x, y, z, x + dice.between(1, 6), y, direction); break;
      case 7: path.arc(x, y, z -= 0.5, x + dice.between(1, 6), y, direction); break;
      default:
        jump();
        path.arc(x, y, z, (x + old_x) / 2, (y + old_y) / 2, direction);
        break;
    }
    if (dice.below(15) == 0)
      path.rapid(x, y, z = 5).tool(1 + static_cast<std::uint32_t>(dice.below(3)), 0);
  }
}

TEST(RandomPaths, NothingThatCutsIsDropped) {
  for (std::uint64_t seed = 1; seed <= 8 * part_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    FeaturePath path;
    path.spindle(1000).tool(3, 4, stock::ToolKind::ball).tool(2, 5, stock::ToolKind::drill);
    path.tool(1, dice.between(1, 8));
    wander(dice, path);
    const Tree tree = recognise(path.recording(), {}, Method::both);
    double cut_mm = 0;
    for (const OperationFacts& operation : tree.operations) cut_mm += operation.cut_mm;
    EXPECT_NEAR(told_length(path.recording(), tree), cut_mm, 1e-6 * (1 + cut_mm));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(GeneratedParts, AreRecognisedAsWhatTheyWereMadeOf) {
  for (std::uint64_t seed = 1; seed <= part_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PartMaker maker(seed);
    maker.make();
    const Tree tree = recognise(maker.recording(), {}, Method::both);
    std::size_t features = 0;
    std::size_t holes = 0;
    for (const Wanted& wanted : maker.wanted()) {
      if (wanted.is_hole) {
        ASSERT_LT(holes, tree.holes.size());
        expect_hole(tree.holes[holes++], wanted);
      } else {
        ASSERT_LT(features, tree.features.size());
        expect_feature(tree.features[features++], wanted);
      }
    }
    EXPECT_EQ(tree.features.size(), features);
    EXPECT_EQ(tree.holes.size(), holes);
    double cut_mm = 0;
    for (const OperationFacts& operation : tree.operations) cut_mm += operation.cut_mm;
    EXPECT_NEAR(told_length(maker.recording(), tree), cut_mm, 1e-6);
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace kerf::features
