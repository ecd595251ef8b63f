#include "stock/dexel/tile_work.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "stock/dexel/runs.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr double kDown_mm = 1e-9;  // that a tip must go for its face to cut

float as_float(double value) { return static_cast<float>(value); }

DexelEnd end_of(float at, const Passage& passage, const Reach& reach, double b, double c,
                std::uint32_t motion) {
  // Material looks towards the tool.
  return {at, octahedral(-1.0 * passage.normal(reach, b, c)), 0, motion};
}

bool may_meet_nothing(const Task& task, ToolPart part) {
  return !task.cuts() || part != ToolPart::edge;
}

const TurningWay* turning(const Task& task) { return std::get_if<TurningWay>(&task.sweep->way); }

TurnEnds turn_ends(const Task& task, const TurningWay& way) {
  const Stroke& stroke = task.strokes.front();
  return {stroke.from, stroke.from + stroke.way, task.sweep->axis, way.to_axis};
}

}  // namespace

TileWork::TileWork(const Lattice& lattice, Tile& tile, int first_column, int first_row, Vec3 middle)
    : lattice_(lattice),
      tile_(tile),
      place_{lattice, first_column, first_row},
      middle_(middle),
      hulls_(tile),
      normals_(place_, tile) {}

Vec3 TileWork::place_of(double along, double b, double c) const {
  return middle_ + along_axis(lattice_.axis, along, b, c);
}

/// glimpse(column, row): which of four dexels are to be looked at. act(place, is_sure) says
/// whether the dexel has changed.
template <class Glimpse, class Act>
void TileWork::visit_block(const TileWindow& window, int column, int row, Glimpse&& glimpse,
                           Act&& act) {
  const int first = std::max(column, window.columns().first);
  const int last = std::min(column + Tile::kBlock - 1, window.columns().last);
  const int last_row = std::min(row + Tile::kBlock - 1, window.rows().last);
  bool changed = false;
  for (int r = std::max(row, window.rows().first); r <= last_row; ++r) {
    const double c = place_.c_of(r);
    const Glance::Answer answer = glimpse(column, r);
    visited_ += static_cast<std::uint64_t>(std::max(0, last - first + 1));
    for (int i = first; i <= last; ++i) {
      const unsigned bit = 1U << static_cast<unsigned>(i - column);
      if ((answer.may & bit) == 0) continue;
      changed |= act(Place{tile_.index(i, r), place_.b_of(i), c}, (answer.surely & bit) != 0);
    }
  }
  if (!changed) return;
  tile_.note_cut(column, row);
  normals_.note(column, row);
}

/// visit(column, row) for blocks. skip(b, c, parts, is_sure): nothing of a block around (b, c),
/// with material in these parts, is met; a glance may be sure that it may be.
template <class Skip, class Visit>
void TileWork::visit_blocks(const TileWindow& window, const Glance* far, Skip&& skip,
                            Visit&& visit) {
  constexpr int kBlock = Tile::kBlock;
  constexpr int kFour = Glance::kLines * kBlock;
  constexpr double kMiddle = 0.5 * (kBlock - 1);
  const int from_row = window.rows().first / kBlock * kBlock;
  const int from_column = window.columns().first / kBlock * kBlock;
  for (int row = from_row; row <= window.rows().last; row += kBlock) {
    const double c = place_.c_of(row) + kMiddle * lattice_.cell_c;
    for (int four = from_column; four <= window.columns().last; four += kFour) {
      const int last = std::min(four + kFour - 1, window.columns().last);
      const Glance::Answer answer = window.at_blocks(far, four, row);
      for (int column = four; answer.may != 0 && column <= last; column += kBlock) {
        const unsigned bit = 1U << static_cast<unsigned>((column - four) / kBlock);
        if ((answer.may & bit) == 0) continue;
        const double middle = place_.b_of(column) + kMiddle * lattice_.cell_b;
        const bool is_sure = (answer.surely & bit) != 0;
        if (!skip(middle, c, tile_.block_parts(column, row), is_sure)) visit(column, row);
      }
    }
  }
}

/// act(place, meeting, passage).
template <class Act>
void TileWork::visit(const PosedSolid& solid, const Frame& frame, const Stroke& stroke,
                     bool follows, Act&& act) {
  const TileWindow window = this->window(swept(solid.reach, stroke.from, stroke.way));
  if (window.is_empty() || window.is_beside(solid, frame, stroke)) return;
  Passage passage(solid.solid, frame, stroke.from, stroke.way, lattice_.axis);
  Passage around(solid.around, frame, stroke.from, stroke.way, lattice_.axis);
  if (follows) {
    passage.follow(0);
    around.follow(solid.margin);
  }
  const Glance far(around, stroke.from, window.lines(solid.margin, Tile::kBlock));
  const Glance near(passage, stroke.from, window.lines(solid.margin, 1));
  Meeting m;
  const auto skip = [&](double b, double c, std::uint64_t parts, bool is_sure) {
    if (is_sure && around.is_decisive()) return false;
    const Passage::Line line = around.line(b, c);
    const Tile::Stretch stretch = tile_.stretch(parts & window.parts());
    if (!is_sure && !around.may_meet(line, double{stretch.low}, double{stretch.high})) return true;
    if (around.is_decisive()) return false;
    return !around.meet(line, m) || (parts & tile_.parts(m.low.along, m.high.along)) == 0;
  };
  const auto glimpse = [&](int column, int row) {
    return window.at_row(near, hulls_, column, row);
  };
  const auto look = [&](const Place& place, bool is_sure) {
    const Passage::Line line = passage.line(place.b, place.c);
    const auto may_meet = [&](double low, double high) {
      return passage.may_meet(line, low, high);
    };
    return (is_sure || tile_.has_piece(place.dexel, window.low(), window.high(), may_meet)) &&
           passage.meet(line, m) && act(place, m, passage);
  };
  visit_blocks(window, &far, skip,
               [&](int column, int row) { visit_block(window, column, row, glimpse, look); });
}

/// The same for a solid that turns; meets(place, meeting).
template <class Meets, class Act>
void TileWork::visit_turn(const Task& task, const Solid& solid, Meets&& meets, Act&& act) {
  Turn turn(solid, turn_ends(task, *turning(task)), lattice_.axis, task.turn_tolerance_mm);
  const TileWindow window = this->window(turn.reach());
  if (window.is_empty()) return;
  const auto never = [](double, double, std::uint64_t, bool) { return false; };
  const auto all = [](int, int) { return Glance::Answer{~0U, 0}; };
  const auto look = [&](const Place& place, bool) {
    bool changed = false;
    turn.over(
        place.b, place.c, [&](const Meeting& m) { return meets(place, m); },
        [&](const Meeting& m, const Passage& passage) { changed |= act(place, m, passage); });
    return changed;
  };
  visit_blocks(window, nullptr, never,
               [&](int column, int row) { visit_block(window, column, row, all, look); });
}

void TileWork::cut(std::span<const Task> tasks, std::span<const std::uint32_t> numbers,
                   Tally& tally) {
  while (!numbers.empty()) {
    const std::size_t count = run_of(tasks, numbers, lattice_.axis);
    if (count < kLeastRun || !cut_run(tasks, numbers.first(count))) {
      for (const std::uint32_t number : numbers.first(count)) cut(tasks[number], tally);
    }
    numbers = numbers.subspan(count);
  }
  normals_.settle();
}

bool TileWork::cut_run(std::span<const Task> tasks, std::span<const std::uint32_t> numbers) {
  const std::vector<RunWork::Step> steps = run_steps(tasks, numbers);
  RunWork run(place_, tile_, *tasks[numbers.front()].posed, steps);
  if (run.may_collide()) return false;
  run.cut(normals_);
  hulls_.forget();
  return true;
}

void TileWork::cut(const Task& task, Tally& tally) {
  visited_ = 0;
  Outcome& outcome = tally.outcomes[task.number];
  if (!may_meet_nothing(task, ToolPart::edge)) {
    cut_edges(task, Across(*task.sweep, task.posed->tool->widest_edge), outcome);
  }
  constexpr std::array kParts{ToolPart::edge, ToolPart::flank, ToolPart::shank, ToolPart::holder};
  for (const ToolPart part : kParts) {
    if (may_meet_nothing(task, part)) check(task, part, tally);
  }
  if (lattice_.axis == task.main_axis) outcome.visited += visited_;
}

void TileWork::cut_edges(const Task& task, const Across& across, Outcome& outcome) {
  bool follows = task.follows;
  for (const Stroke& stroke : task.strokes) {
    for (const PosedSolid& solid : task.posed->solids) {
      if (solid.solid.part != ToolPart::edge) continue;
      cut_solid(task, solid, stroke, follows, across, outcome);
    }
    follows = true;
  }
}

void TileWork::cut_solid(const Task& task, const PosedSolid& solid, const Stroke& stroke,
                         bool follows, const Across& across, Outcome& outcome) {
  if (turning(task) != nullptr) {
    const auto meets = [&](const Place& place, const Meeting& m) {
      return tile_.overlap(place.dexel, as_float(m.low.along), as_float(m.high.along)) >=
             Tile::kLeast_mm;
    };
    visit_turn(task, solid.solid, meets, [&](const Place& p, const Meeting& m, const Passage& by) {
      return take(task, p, m, by, nullptr, across, outcome);
    });
    return;
  }
  std::optional<Passage> core;
  const PosedTool& posed = *task.posed;
  const bool counts = posed.core && lattice_.axis == task.main_axis;
  if (counts && dot(stroke.way, posed.frame.up) < -kDown_mm) {
    core.emplace(posed.core->solid, posed.frame, stroke.from, stroke.way, lattice_.axis);
  }
  cut_ = normals_.begin(posed.frame, solid, stroke);
  visit(solid, posed.frame, stroke, follows,
        [&](const Place& p, const Meeting& m, const Passage& by) {
          return take(task, p, m, by, core ? &*core : nullptr, across, outcome);
        });
  cut_ = 0;
}

bool TileWork::take(const Task& task, const Place& place, const Meeting& meeting,
                    const Passage& passage, const Passage* core, const Across& across,
                    Outcome& outcome) {
  if (core != nullptr) count_core(place, meeting, *core, outcome);
  const bool is_told = lattice_.axis == task.main_axis && across.has_bins();
  const Tile::Stretch span = is_told ? tile_.touched_span(place.dexel, as_float(meeting.low.along),
                                                          as_float(meeting.high.along))
                                     : Tile::Stretch{};
  const double length = subtract(task, place, meeting, passage);
  if (length == 0) return false;
  count(task, place, length, span, across, outcome);
  return true;
}

double TileWork::subtract(const Task& task, const Place& place, const Meeting& meeting,
                          const Passage& passage) {
  const std::uint32_t motion = task.sweep->motion;
  const float low = as_float(meeting.low.along);
  const float high = as_float(meeting.high.along);
  double length = 0;
  if (cut_ > 0) {
    const auto end = [&](float at) { return DexelEnd{at, {}, cut_, motion}; };
    length = tile_.subtract(place.dexel, low, high, end, end);
  } else {
    length = tile_.subtract(
        place.dexel, low, high,
        [&](float at) { return end_of(at, passage, meeting.low, place.b, place.c, motion); },
        [&](float at) { return end_of(at, passage, meeting.high, place.b, place.c, motion); });
  }
  if (length > 0) hulls_.changed(place.dexel);
  return length;
}

void TileWork::count(const Task& task, const Place& place, double length, const Tile::Stretch& span,
                     const Across& across, Outcome& outcome) const {
  if (lattice_.axis != task.main_axis) return;
  const Exact volume(length * lattice_.cell_area());
  outcome.removed += volume;
  if (!across.has_bins()) return;
  const Vec3 low = place_of(double{span.low}, place.b, place.c);
  const Vec3 high = place_of(double{span.high}, place.b, place.c);
  const double s = across.distance(0.5 * (low + high));
  outcome.across[across.bin(s)] += volume;
  outcome.aside.add(s);
  outcome.heights.add(dot(low, task.sweep->axis));
  outcome.heights.add(dot(high, task.sweep->axis));
}

/// The tip face, going down, comes first to what it passes over.
void TileWork::count_core(const Place& place, const Meeting& meeting, const Passage& core,
                          Outcome& outcome) const {
  Meeting face;
  if (!core.meet(place.b, place.c, face)) return;
  const double low = std::max(face.low.along, meeting.low.along);
  const double high = std::min(face.high.along, meeting.high.along);
  const double length = low < high ? tile_.overlap(place.dexel, as_float(low), as_float(high)) : 0;
  if (length >= Tile::kLeast_mm) outcome.core += Exact(length * lattice_.cell_area());
}

/// act(solid, stroke, number of the stroke) for what belongs to a part.
template <class Act>
void TileWork::each_solid(const Task& task, const std::vector<PosedSolid>& solids, ToolPart part,
                          Act&& act) {
  std::uint32_t number = 0;
  for (const Stroke& stroke : task.strokes) {
    ++number;
    for (const PosedSolid& solid : solids) {
      if (solid.solid.part == part) act(solid, stroke, number);
    }
  }
}

void TileWork::check(const Task& task, ToolPart part, Tally& tally) {
  find_contacts(task, part);
  if (!contacts_.empty()) {
    remove_contacts(task, part, tally.outcomes[task.number]);
    tell_contacts(task, part, tally);
  }
  for (const std::size_t dexel : noted_) found_[dexel] = Found{};
  noted_.clear();
  contacts_.clear();
}

void TileWork::find_contacts(const Task& task, ToolPart part) {
  each_solid(task, task.posed->touching, part,
             [&](const PosedSolid& solid, const Stroke& stroke, std::uint32_t number) {
               const auto act = [&](const Place& place, const Meeting& m, const Passage&) {
                 note(task, place, m, number);
                 return false;
               };
               if (turning(task) == nullptr) {
                 visit(solid, task.posed->frame, stroke, false, act);
                 return;
               }
               const auto meets = [&](const Place& place, const Meeting& m) {
                 const bool is_known = !found_.empty() && found_[place.dexel].is_contact;
                 return !is_known && tile_.overlap(place.dexel, as_float(m.low.along),
                                                   as_float(m.high.along)) >= Tile::kLeast_mm;
               };
               visit_turn(task, solid.solid, meets, act);
             });
}

/// Solids of a stroke lie above each other: what they meet adds up, that of strokes does not.
void TileWork::note(const Task& task, const Place& place, const Meeting& meeting,
                    std::uint32_t stroke) {
  const double length =
      tile_.overlap(place.dexel, as_float(meeting.low.along), as_float(meeting.high.along));
  if (length <= 0) return;
  if (found_.empty()) found_.resize(tile_.count());
  Found& found = found_[place.dexel];
  if (found.stroke == 0) noted_.push_back(place.dexel);
  const bool is_turning = turning(task) != nullptr;
  const bool adds = found.stroke == stroke && !is_turning;
  found.shrunk = (adds ? found.shrunk : 0) + as_float(length);
  found.stroke = stroke;
  const double least = std::max(task.posed->tool->body.touch_mm, Tile::kLeast_mm);
  if (found.is_contact || double{found.shrunk} <= least) return;
  found.is_contact = true;
  contacts_.push_back(place.dexel);
}

void TileWork::remove_contacts(const Task& task, ToolPart part, Outcome& outcome) {
  const Across across(*task.sweep, task.posed->tool->widest_edge);
  const auto act = [&](const Place& place, const Meeting& m, const Passage& passage) {
    if (!found_[place.dexel].is_contact) return false;
    const float before = found_[place.dexel].removed;
    if (!remove_contact(task, place, m, passage)) return false;
    const float at = found_[place.dexel].at;
    count(task, place, double{found_[place.dexel].removed - before}, {at, at}, across, outcome);
    return true;
  };
  each_solid(task, task.posed->solids, part,
             [&](const PosedSolid& solid, const Stroke& stroke, std::uint32_t) {
               if (turning(task) == nullptr) {
                 visit(solid, task.posed->frame, stroke, false, act);
                 return;
               }
               const auto meets = [&](const Place& place, const Meeting&) {
                 return found_[place.dexel].is_contact;
               };
               visit_turn(task, solid.solid, meets, act);
             });
}

/// It keeps the place that is nearest to the tip.
bool TileWork::remove_contact(const Task& task, const Place& place, const Meeting& meeting,
                              const Passage& passage) {
  Found& found = found_[place.dexel];
  const float low = as_float(meeting.low.along);
  const float high = as_float(meeting.high.along);
  const auto [from, to] = tile_.touched_span(place.dexel, low, high);
  const double length = subtract(task, place, meeting, passage);
  if (length == 0) return false;
  const bool is_up = on_axis(task.sweep->axis, lattice_.axis) >= 0;
  const float at = is_up ? from : to;
  const bool is_nearer = is_up ? at < found.at : at > found.at;
  if (found.removed == 0 || is_nearer) found.at = at;
  found.removed += as_float(length);
  return true;
}

void TileWork::tell_contacts(const Task& task, ToolPart part, Tally& tally) {
  Contact all;
  for (const std::size_t dexel : contacts_) {
    const Found& found = found_[dexel];
    const int column = static_cast<int>(dexel) % tile_.columns();
    const int row = static_cast<int>(dexel) / tile_.columns();
    const Vec3 at = place_of(double{found.at}, place_.b_of(column), place_.c_of(row));
    all.add({double{found.removed}, at, Exact(double{found.removed} * lattice_.cell_area())});
  }
  const int rank = (lattice_.axis - task.main_axis + 3) % 3;
  if (rank == 0) {
    tally.outcomes[task.number].contacts[index(part)].add(all);
  } else {
    tally.aside.push_back({task.number, index(part), rank, all});
  }
}

bool TileWork::meets(const PosedTool& posed, const Stroke& stroke) {
  bool met = false;
  for (const PosedSolid& solid : posed.solids) {
    visit(solid, posed.frame, stroke, false,
          [&](const Place& place, const Meeting& m, const Passage&) {
            met |= tile_.overlap(place.dexel, as_float(m.low.along), as_float(m.high.along)) >=
                   Tile::kLeast_mm;
            return false;
          });
    if (met) return true;
  }
  return false;
}

}  // namespace kerf::stock::dexel
