#include "random_part.hpp"

#include <cmath>
#include <numbers>

#include "thing_maker.hpp"

namespace kerf::parts {
namespace {

constexpr double kCell_mm = 100;

class PartMaker : ThingMaker {
 public:
  explicit PartMaker(std::uint64_t seed) : ThingMaker(seed) {}

  RandomPart make() {
    if (random_.count(0, 3) == 0) {
      make_open_part();
    } else {
      make_closed_part();
    }
    part_.program = posted_.text();
    part_.rounding_mm = posted_.rounding_mm();
    return std::move(part_);
  }

 private:
  void make_closed_part() {
    if (random_.coin()) {
      part_.stock = Vec2{3 * kCell_mm, 2 * kCell_mm};
      part_.stock_depth = 60;
    }
    const int things = random_.count(3, 6);
    for (int i = 0; i < things; ++i) {
      const Vec2 middle{kCell_mm * (i % 3 + 0.5), kCell_mm * (i / 3 + 0.5)};
      thing({middle, random_.in(18, 45)}, 0);
    }
  }

  // On the border of a blank, perhaps faced first.
  void make_open_part() {
    const Vec2 size{200, 160};
    part_.stock = size;
    part_.stock_depth = 60;
    use(random_.count(1, 3));
    double top = 0;
    Parent floor{};
    MillCam::Open all{true, true, true, true};
    Way way = random_way();
    way.strategy = random_.coin() ? Way::Strategy::zig : Way::Strategy::zig_zag;
    if (random_.coin()) {
      note("face");
      MillCam(posted_, radius()).corner({0, 0}, size, all, 0, -1, way);
      top = -1;
      WantedFeature face{.type = FeatureType::face, .layers = {-1}};
      face.outline = box_contour({0, 0}, size, all, 0);
      floor = std::pair{want(std::move(face), {}), RelationKind::nested};
      use_mill(100);
      way.step = random_.in(0.5, 0.9) * radius();
    }
    if (random_.count(0, 3) == 0) return boss(size, top, floor, way);
    border_thing(size, top, floor, way);
    thing({{130, 100}, 28, top, floor}, 1);
  }

  void boss(Vec2 size, double top, const Parent& floor, Way way) {
    const Vec2 middle = 0.5 * size;
    const double r = radius();
    const Outline island =
        random_.coin() ? Outline::circle(middle, random_.in(20, 45))
                       : Outline::rectangle(middle, {random_.in(20, 40), random_.in(20, 40)},
                                            random_.in(0, 3));
    const Outline round =
        Outline::rectangle(middle, {middle.u + 2 * r + 1, middle.v + 2 * r + 1}, 0);
    WantedFeature wanted{.type = FeatureType::boss, .layers = random_layers(top)};
    MillCam cam(posted_, r);
    note("boss");
    double from = top;
    for (const double z : wanted.layers) {
      cam.pocket(round, island, from, z, way);
      from = z;
    }
    wanted.outline = box_contour({0, 0}, size, {true, true, true, true}, 0);
    wanted.islands = {island.drawn()};
    const Room room{.top = top, .parent = floor};
    const std::size_t place = want(std::move(wanted), room);
    hole({middle, 12, top, std::pair{place, RelationKind::island}});
  }

  // Corners between two walls are rounded.
  static Contour box_contour(Vec2 low, Vec2 high, MillCam::Open open, double radius) {
    const double round = std::tan(std::numbers::pi / 8);
    Contour contour;
    const auto add = [&](Vec2 corner, Vec2 before, Vec2 behind, bool is_walled) {
      if (!is_walled) return contour.vertices.push_back({corner});
      contour.vertices.push_back({corner - radius * before, round});
      contour.vertices.push_back({corner + radius * behind});
    };
    add(low, {0, -1}, {1, 0}, !open.left && !open.low);
    add({high.u, low.v}, {1, 0}, {0, 1}, !open.low && !open.right);
    add(high, {0, 1}, {-1, 0}, !open.right && !open.high);
    add({low.u, high.v}, {-1, 0}, {0, -1}, !open.high && !open.left);
    return contour;
  }

  void border_thing(Vec2 size, double top, const Parent& floor, const Way& way) {
    const double r = radius();
    const double wide = random_.in(2.5 * r, 40);
    MillCam::Open open{};
    Vec2 low{};
    Vec2 high = size;
    FeatureType type = FeatureType::step;
    switch (random_.count(0, 4)) {
      case 0:
        high.v = wide;
        open = {true, true, true, false};
        break;
      case 1:
        high.u = wide;
        open = {true, false, true, true};
        break;
      case 2:
        high = {random_.in(50, 80), wide};
        open = {true, false, true, false};
        break;
      case 3:
        low.v = 5;
        high.v = 5 + wide;
        open = {true, true, false, false};
        type = FeatureType::slot;
        break;
      default:
        low = {0, 10};
        high = {random_.in(50, 80), 10 + wide};
        open = {true, false, false, false};
        type = FeatureType::open_pocket;
        break;
    }
    WantedFeature wanted{.type = type, .layers = random_layers(top)};
    MillCam cam(posted_, r);
    note(type == FeatureType::step ? "step" : type == FeatureType::slot ? "channel" : "bay");
    double from = top;
    for (const double z : wanted.layers) {
      cam.corner(low, high, open, from, z, way);
      from = z;
    }
    wanted.outline = box_contour(low, high, open, r);
    const Room room{.top = top, .parent = floor};
    want(std::move(wanted), room);
  }
};

}  // namespace

RandomPart random_part(std::uint64_t seed) { return PartMaker(seed).make(); }

}  // namespace kerf::parts
