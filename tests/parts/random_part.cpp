#include "random_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mill_cam.hpp"
#include "seeded_random.hpp"

namespace kerf::parts {
namespace {

using features::FeatureType;
using features::RelationKind;
using Parent = std::optional<std::pair<std::size_t, RelationKind>>;

constexpr double kCell_mm = 100;
constexpr double kLongSlot = 3;  // of its width, from which a pocket is a slot
constexpr int kDrill = 9;

/// What may be machined where: a disc about a middle, from a height.
struct Room {
  Vec2 middle{};
  double radius = 40;
  double top = 0;
  Parent parent{};
};

class PartMaker {
 public:
  explicit PartMaker(std::uint64_t seed)
      : random_(static_cast<unsigned>(seed)), posted_(style_of_text()) {
    part_.zero = style_.zero;
    for (int i = 0; i < 3; ++i) add_tool(i + 1, stock::ToolKind::flat, random_.in(4, 12));
    add_tool(kDrill, stock::ToolKind::drill, random_.in(3, 9));
  }

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
  TextStyle style_of_text() {
    style_.has_numbers = random_.coin();
    style_.has_blanks = random_.coin();
    style_.repeats_g = random_.coin();
    style_.is_incremental = random_.count(0, 3) == 0;
    style_.has_radius = random_.count(0, 3) == 0;
    style_.is_inch = random_.count(0, 3) == 0;
    if (random_.coin())
      style_.zero = {std::round(random_.in(5, 90)), std::round(random_.in(5, 90))};
    return style_;
  }

  void add_tool(int number, stock::ToolKind kind, double diameter) {
    stock::Tool tool;
    tool.number = number;
    tool.kind = kind;
    tool.source = stock::ToolSource::file;
    tool.measures.set(stock::Measure::diameter, std::round(diameter * 100) / 100);
    tool.measures.set(stock::Measure::flute_length, 60);
    part_.tools.push_back(tool);
  }

  double radius_of(int number) const {
    for (const stock::Tool& tool : part_.tools) {
      if (tool.number == number) return tool.value(stock::Measure::diameter).value_or(0) / 2;
    }
    return 0;
  }

  void use(int number) {
    if (number == tool_) return;
    tool_ = number;
    posted_.tool(number, 3000);
  }
  // The largest mill at hand that is no larger.
  bool use_mill(double most_radius) {
    std::vector<int> fitting;
    for (int number = 1; number <= 3; ++number) {
      if (radius_of(number) <= most_radius) fitting.push_back(number);
    }
    if (fitting.empty()) return false;
    const bool stays = std::find(fitting.begin(), fitting.end(), tool_) != fitting.end();
    if (!stays || random_.count(0, 2) == 0)
      use(fitting[static_cast<std::size_t>(
          random_.count(0, static_cast<int>(fitting.size()) - 1))]);
    return true;
  }
  double radius() const { return radius_of(tool_); }

  Way random_way() {
    Way way;
    way.is_inside_out = random_.coin();
    way.climbs = random_.coin();
    way.retracts = random_.count(0, 3) == 0;
    way.step = random_.in(0.5, 0.9) * radius();
    return way;
  }

  std::vector<double> random_layers(double top, double most = 3) {
    std::vector<double> layers;
    const double step = std::round(random_.in(1, most) * 100) / 100;
    for (int i = random_.count(1, 3); i > 0; --i) layers.push_back(top -= step);
    return layers;
  }

  void note(const std::string& what) { part_.made_of += what + "; "; }

  // What has been machined there is the parent of what comes into it.
  std::size_t want(WantedFeature feature, const Room& room) {
    feature.top = room.top;
    feature.parent = room.parent;
    part_.features.push_back(std::move(feature));
    return part_.features.size() - 1;
  }

  Outline outline_in(const Room& room, double least_inner) {
    const double r = room.radius;
    const double angle = random_.coin() ? 0 : random_.in(0, 3);
    switch (random_.count(0, 4)) {
      case 0: {
        const double a = random_.in(least_inner, 0.7 * r);
        const double b = random_.in(least_inner, 0.7 * r);
        const double corner = random_.coin() ? 0 : random_.in(0.1, 0.9) * std::min(a, b);
        return Outline::rectangle(room.middle, {a, b}, angle, corner);
      }
      case 1: return Outline::circle(room.middle, random_.in(least_inner, r));
      case 2: {
        const double wide = random_.in(least_inner, 0.6 * r);
        const Vec2 arm = (r - wide) * Vec2{std::cos(angle), std::sin(angle)};
        return Outline::stadium(room.middle - arm, room.middle + arm, wide);
      }
      default: break;
    }
    return polygon_in(room, least_inner);
  }

  Outline polygon_in(const Room& room, double least_inner) {
    for (int count = random_.count(3, 7);; ++count) {
      std::vector<Vec2> corners;
      const double begin = random_.in(0, 6);
      for (int i = 0; i < count; ++i) {
        const double angle = begin + 2 * std::numbers::pi * (i + random_.in(-0.2, 0.2)) / count;
        corners.push_back(room.middle + room.radius * Vec2{std::cos(angle), std::sin(angle)});
      }
      const Outline outline = Outline::polygon(corners);
      if (outline.inner_radius() >= least_inner || count > 12) return outline;
    }
  }

  Outline l_shape_in(const Room& room, double arm) {
    const double b = 1.3 * room.radius;
    const double turn = random_.in(0, 6);
    const Vec2 u{std::cos(turn), std::sin(turn)};
    const Vec2 v = geometry::left_of(u);
    const Vec2 low = room.middle - (b / 2) * (u + v);
    const auto at = [&](double x, double y) { return low + x * u + y * v; };
    return Outline::polygon({at(0, 0), at(b, 0), at(b, arm), at(arm, arm), at(arm, b), at(0, b)});
  }

  static FeatureType type_of(const Outline& outline) {
    if (outline.is_polygon() || outline.is_circle()) return FeatureType::pocket;
    const contour::Contour stadium = outline.drawn();
    const double width = 2 * outline.inner_radius();
    const double length = contour::length(contour::edge_of(stadium, 0)) + width;
    return length >= kLongSlot * width ? FeatureType::slot : FeatureType::pocket;
  }

  void choose_strategy(const Outline& outline, Way& way, WantedFeature& wanted) {
    const int loops = loop_count(outline, way.step);
    wanted.strategy =
        loops == 1 ? features::Strategy::single : features::Strategy::contour_parallel;
    wanted.milling = way.climbs ? features::Milling::climb : features::Milling::conventional;
    const int which = random_.count(0, 5);
    if (is_l_ || which >= 3) {
      if (loops > 1)
        wanted.order =
            way.is_inside_out ? features::Order::inside_out : features::Order::outside_in;
      choose_entry(outline, way, wanted);
      return;
    }
    if (outline.is_circle() && which == 2) {
      const double reach = outline.inner_radius() - radius();
      if (reach < 4 * way.step) return;
      way.strategy = Way::Strategy::spiral;
      wanted.strategy = features::Strategy::spiral;
      return;
    }
    if (which == 2) return;
    way.strategy = which == 0 ? Way::Strategy::zig : Way::Strategy::zig_zag;
    wanted.strategy.reset();
    if (outline.inner_radius() > 5 * radius())
      wanted.strategy = which == 0 ? features::Strategy::zig : features::Strategy::zig_zag;
  }

  int loop_count(const Outline& outline, double step) const {
    int count = 0;
    for (double d = radius(); !outline.inset(d).vertices.empty(); d += step) ++count;
    return count;
  }

  void choose_entry(const Outline& outline, Way& way, WantedFeature& wanted) {
    wanted.entry = features::Entry::Kind::plunge;
    const int which = random_.count(0, 3);
    if (which == 0 && !is_l_) {
      way.entry = Way::Entry::ramp;
      wanted.entry = features::Entry::Kind::ramp;
    } else if (which == 1 && !is_l_ && outline.inner_radius() > 1.6 * radius()) {
      way.entry = Way::Entry::helix;
      way.retracts = false;
      wanted.entry = features::Entry::Kind::helix;
    }
  }

  /// Clears an outline; with luck something comes onto its floor.
  void pocket(const Room& room, int depth) {
    if (!use_mill(room.radius / 3)) return hole(room);
    is_l_ = random_.count(0, 5) == 0 && room.radius > 4 * radius();
    const Outline outline = is_l_ ? l_shape_in(room, random_.in(2.3, 3.2) * radius())
                                  : outline_in(room, 1.5 * radius());
    WantedFeature wanted{.type = type_of(outline), .layers = random_layers(room.top)};
    Way way = random_way();
    choose_strategy(outline, way, wanted);
    wanted.outline = outline.milled(radius());
    if (outline.is_polygon() && wanted.strategy) wanted.nominal = nominal_of(outline);
    wanted.is_round = outline.is_circle();
    MillCam cam(posted_, radius());
    note("pocket");
    clear_layers(wanted.layers, room.top,
                 [&](double top, double z) { cam.pocket(outline, top, z, way); });
    const double bottom = wanted.layers.back();
    const bool is_sloped = is_l_;
    const std::size_t place = want(std::move(wanted), room);
    const double inside = outline.inner_radius() * 0.75;
    if (depth < 2 && !is_sloped && inside > 6 && random_.coin())
      thing({outline.middle(), inside, bottom, std::pair{place, RelationKind::nested}}, depth + 1);
  }

  std::optional<Contour> nominal_of(const Outline& outline) {
    const Contour drawn = outline.drawn();
    const bool is_sharp = contour::edge_count(drawn) <= 12 &&
                          std::all_of(drawn.vertices.begin(), drawn.vertices.end(),
                                      [](const auto& vertex) { return vertex.bulge == 0; });
    return is_sharp ? std::optional(drawn) : std::nullopt;
  }

  template <typename Clear>
  void clear_layers(const std::vector<double>& layers, double top, const Clear& clear) {
    const bool calls = random_.count(0, 3) == 0;
    for (const double z : layers) {
      if (calls) posted_.begin_subprogram();
      clear(top, z);
      if (calls) posted_.end_subprogram();
      top = z;
    }
  }

  void island_pocket(const Room& room, int depth) {
    if (!use_mill(room.radius / 5)) return pocket(room, depth);
    const double r = radius();
    is_l_ = false;
    const bool is_round = random_.coin();
    const double outer = is_round ? room.radius : 0.7 * room.radius;
    const double free_least = 2 * r + 0.5;
    const double inner = std::min(random_.in(0.25, 0.45) * outer, outer - free_least);
    if (inner < 1) return pocket(room, depth);
    const double free = outer - inner - 2 * r;
    const Outline outline = is_round ? Outline::circle(room.middle, outer)
                                     : Outline::rectangle(room.middle, {outer, outer},
                                                          random_.coin() ? 0 : random_.in(0, 2));
    const Outline island =
        random_.coin() || free < 0.5 * inner + 2
            ? Outline::circle(room.middle, inner)
            : Outline::rectangle(room.middle, {inner, 0.8 * inner}, random_.in(0, 3));
    WantedFeature wanted{.layers = random_layers(room.top)};
    Way way = random_way();
    MillCam cam(posted_, r);
    const bool is_ring = outline.is_circle() && island.is_circle() && random_.coin();
    note(is_ring ? "ring pocket" : "island pocket");
    clear_layers(wanted.layers, room.top, [&](double top, double z) {
      if (is_ring) {
        cam.ring_pocket(room.middle, inner, outer, top, z, way);
      } else {
        cam.pocket(outline, island, top, z, way);
      }
    });
    wanted.outline = outline.milled(r);
    wanted.islands = {island.drawn()};
    if (!is_ring)
      wanted.milling = way.climbs ? features::Milling::climb : features::Milling::conventional;
    const std::size_t place = want(std::move(wanted), room);
    if (inner > 6 && random_.coin())
      hole({room.middle, inner * 0.6, room.top, std::pair{place, RelationKind::island}});
  }

  void slot(const Room& room) {
    if (!use_mill(room.radius / 3)) return hole(room);
    const double r = radius();
    const double angle = random_.in(0, 6);
    const double reach = room.radius - r;
    const Vec2 arm = reach * Vec2{std::cos(angle), std::sin(angle)};
    Contour path{{{room.middle - arm}, {room.middle + arm}}, false};
    Contour outline = Outline::stadium(room.middle - arm, room.middle + arm, r).drawn();
    if (reach > 3 * r && random_.coin()) {
      const double bulge = (random_.coin() ? 1 : -1) * random_.in(0.2, 0.6);
      path.vertices.front().bulge = bulge;
      const contour::Edge edge = contour::edge_of(path, 0);
      const Vec2 out_a = r * geometry::unit(geometry::left_of(contour::tangent_at_start(edge)));
      const Vec2 out_b = r * geometry::unit(geometry::left_of(contour::tangent_at_end(edge)));
      outline = {{{edge.from - out_a, bulge},
                  {edge.to - out_b, 1},
                  {edge.to + out_b, -bulge},
                  {edge.from + out_a, 1}},
                 true};
    }
    WantedFeature wanted{.type = FeatureType::slot, .layers = random_layers(room.top)};
    MillCam cam(posted_, r);
    note("slot");
    clear_layers(wanted.layers, room.top,
                 [&](double top, double z) { cam.pass(path, top, z, Way::Entry::plunge); });
    wanted.outline = outline;
    want(std::move(wanted), room);
  }

  void profile(const Room& room) {
    if (!use_mill(room.radius / 4)) return hole(room);
    const double r = radius();
    const double size = room.radius - 2 * r;
    const Outline island =
        random_.coin() ? Outline::circle(room.middle, random_.in(0.6, 1) * size)
                       : Outline::rectangle(room.middle, {0.7 * size, random_.in(0.4, 0.7) * size},
                                            random_.in(0, 3));
    if (island.inner_radius() < 0.5) return hole(room);
    const bool climbs = random_.coin();
    const bool leads = random_.coin();
    WantedFeature wanted{.type = FeatureType::outside_profile, .layers = random_layers(room.top)};
    MillCam cam(posted_, r);
    note("profile");
    clear_layers(wanted.layers, room.top,
                 [&](double top, double z) { cam.profile(island, top, z, climbs, leads); });
    wanted.outline = island.outset(2 * r);
    wanted.islands = {island.drawn()};
    wanted.nominal = island.drawn();
    wanted.milling = climbs ? features::Milling::climb : features::Milling::conventional;
    want(std::move(wanted), room);
  }

  // By one tool with something left on the wall, by another one along it.
  void finished_pocket(const Room& room) {
    if (!use_mill(room.radius / 3)) return hole(room);
    const double rough = radius();
    const int rough_tool = tool_;
    const double half = random_.in(1.8 * rough, 0.7 * room.radius);
    if (half < 1.8 * rough) return hole(room);
    const double left = random_.in(0.1, 0.15) * rough;
    const bool is_round = random_.coin();
    const auto outline = [&](double inside) {
      return is_round ? Outline::circle(room.middle, half - inside)
                      : Outline::rectangle(room.middle, {half - inside, half - inside}, 0.3);
    };
    std::optional<int> finisher;
    for (int number = 1; number <= 3; ++number) {
      const double r = radius_of(number);
      if (number != rough_tool && r <= rough && r >= 0.6 * rough) finisher = number;
    }
    if (!finisher) return pocket(room, 2);
    const Way way = random_way();
    const double z = room.top - 2;
    note("finished pocket");
    MillCam(posted_, rough).pocket(outline(left), room.top, z, way);
    use(*finisher);
    MillCam(posted_, radius()).finish(outline(0), room.top, z, way.climbs);
    want({.layers = {z}, .outline = outline(0).milled(radius()), .cuts = 2}, room);
  }

  void hole(const Room& room) {
    WantedHole wanted{.at = room.middle, .top = room.top, .parent = room.parent};
    const double drill = radius_of(kDrill);
    const double depth = random_.in(3, 12);
    wanted.bottom = room.top - depth;
    const int which = random_.count(0, 3);
    if (which == 0 && use_mill(0.5 * room.radius)) {
      const double r = radius();
      const double wide = random_.in(1.3, 1.9) * r;
      note("helical hole");
      MillCam(posted_, r).helix_hole(room.middle, wide, room.top, wanted.bottom, r / 2);
      wanted.diameter = 2 * wide;
    } else if (which == 1 && drill * 2.8 < room.radius && use_mill(drill)) {
      const double wide = random_.in(1.3, 2.8) * drill;
      const double floor = room.top - 2;
      note("counterbore");
      Way way = random_way();
      if (wide < 1.2 * radius()) return;
      MillCam(posted_, radius()).pocket(Outline::circle(room.middle, wide), room.top, floor, way);
      use(kDrill);
      posted_.drill(room.middle, wanted.bottom - 2, 0);
      wanted.bottom -= 2;
      wanted.diameter = 2 * drill;
      wanted.form = features::Hole::Form::counterbore;
    } else if (drill < room.radius) {
      use(kDrill);
      note("drilled hole");
      if (random_.coin()) {
        MillCam(posted_, drill).plunges(room.middle, wanted.bottom, random_.count(1, 3));
      } else {
        posted_.drill(room.middle, wanted.bottom, random_.coin() ? 0 : 2);
      }
      wanted.diameter = 2 * drill;
    } else {
      return;
    }
    part_.holes.push_back(wanted);
  }

  void thing(const Room& room, int depth) {
    switch (random_.count(0, 8)) {
      case 0:
      case 1:
      case 2: return pocket(room, depth);
      case 3:
      case 4: return island_pocket(room, depth);
      case 5: return slot(room);
      case 6: return profile(room);
      case 7: return finished_pocket(room);
      default: return hole(room);
    }
  }

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

  RandomPart part_{};
  test::SeededRandom random_;
  TextStyle style_{};
  Posted posted_;
  int tool_ = 0;
  bool is_l_ = false;
};

}  // namespace

RandomPart random_part(std::uint64_t seed) { return PartMaker(seed).make(); }

}  // namespace kerf::parts
