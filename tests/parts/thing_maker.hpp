#pragma once

#include <array>
#include <numbers>

#include "machinist.hpp"

namespace kerf::parts {

inline constexpr double kLongSlot = 3;  // of its width, from which a pocket is a slot
inline constexpr double kMostOfDrilled =
    3;  // a round pocket up to so many times a hole is its step

/// Machines one thing in a room: pockets, with islands or finished, slots, profiles, holes.
class ThingMaker : protected Machinist {
 protected:
  using Machinist::Machinist;

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
    join_counterbore(place);
  }

  // A round pocket over a drilled hole that is not much narrower is the hole's.
  void join_counterbore(std::size_t place) {
    const WantedFeature& pocket = part_.features[place];
    const Parent nested = std::pair{place, RelationKind::nested};
    if (part_.holes.empty() || part_.holes.back().parent != nested || !pocket.is_round) return;
    WantedHole& hole = part_.holes.back();
    const bool is_drilled = hole.diameter == 2 * radius_of(kDrill);
    const contour::Box box = contour::extents(pocket.outline);
    if (!is_drilled || box.high.u - box.low.u > kMostOfDrilled * hole.diameter) return;
    hole.form = features::Hole::Form::counterbore;
    hole.top = pocket.top;
    hole.parent = pocket.parent;
    part_.features.pop_back();
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

 private:
  bool is_l_ = false;
};

}  // namespace kerf::parts
