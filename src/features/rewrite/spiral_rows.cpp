#include "features/rewrite/spiral_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "features/path/tolerance.hpp"
#include "features/rewrite/clearing.hpp"
#include "features/rewrite/visit_rows.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

constexpr double kSameRadius_mm = 3e-3;
constexpr std::size_t kMostTurns = 100'000;

struct Round {
  Vec2 centre{};
  double radius = 0;
};

/// What a contour is, if it is one circle.
std::optional<Round> round_of(const Contour& contour) {
  if (contour.vertices.size() != 2 || contour.vertices.front().bulge == 0) return std::nullopt;
  const contour::Edge edge = contour::edge_of(contour, 0);
  const contour::Edge other = contour::edge_of(contour, 1);
  if (other.bulge == 0 ||
      geometry::length(contour::centre(edge) - contour::centre(other)) > kSameRadius_mm)
    return std::nullopt;
  return Round{contour::centre(edge), contour::radius(edge)};
}

/// A step of the spiral: where it ends, from the centre of the pocket; its row turns by `sweep`.
struct Step {
  Vec2 to{};
  double sweep_rad = 0;  ///< 0: a line
  std::uint32_t like = 0;
};

/// A way from the inside to the wall, and round along that.
struct Spiral {
  Vec2 begin{};
  std::vector<Step> turns{};   ///< the last one ends beside the wall
  std::vector<Step> around{};  ///< beside it all along
  bool is_inside_out = true;
};

double turn_between(Vec2 from, Vec2 to) {
  return math::atan2(geometry::cross(from, to), geometry::dot(from, to));
}
Vec2 turned(Vec2 arm, double by) {
  return {math::cos(by) * arm.u - math::sin(by) * arm.v,
          math::sin(by) * arm.u + math::cos(by) * arm.v};
}

/// The other way along it: from the wall to the inside, or back.
std::vector<Step> backwards(Vec2 begin, const std::vector<Step>& steps) {
  std::vector<Step> made;
  for (std::size_t i = steps.size(); i-- > 0;)
    made.push_back({i > 0 ? steps[i - 1].to : begin, -steps[i].sweep_rad, steps[i].like});
  return made;
}

std::optional<Spiral> spiral_of(Vec2 begin, std::vector<Step> steps, double wall) {
  Spiral spiral;
  spiral.is_inside_out = geometry::length(begin) < geometry::length(steps.back().to);
  if (!spiral.is_inside_out) {
    const Vec2 end = steps.back().to;
    steps = backwards(begin, steps);
    begin = end;
  }
  spiral.begin = begin;
  double last = geometry::length(begin);
  for (const Step& step : steps) {
    const double off = geometry::length(step.to);
    const bool is_round = last > wall - kSameRadius_mm;
    if (off < last - kSameRadius_mm || off > wall + kSameRadius_mm) return std::nullopt;
    if (is_round && off < wall - kSameRadius_mm) return std::nullopt;
    (is_round ? spiral.around : spiral.turns).push_back(step);
    last = off;
  }
  const bool is_whole = last > wall - kSameRadius_mm && spiral.turns.size() >= 3;
  return is_whole ? std::optional(spiral) : std::nullopt;
}

/// By how much a turn comes nearer to the wall: the median.
double growth_of(const Spiral& spiral) {
  std::vector<double> steps;
  double last = geometry::length(spiral.begin);
  for (const Step& step : spiral.turns) {
    steps.push_back(geometry::length(step.to) - last);
    last = geometry::length(step.to);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// The spiral to another wall.
std::optional<Spiral> reaching(const Spiral& old, double old_wall, double wall) {
  if (geometry::length(old.begin) >= wall - kSameRadius_mm) return std::nullopt;
  Spiral made{.begin = old.begin, .is_inside_out = old.is_inside_out};
  const double least = std::min(wall, old_wall) - kSameRadius_mm;
  for (const Step& step : old.turns) {
    if (geometry::length(step.to) >= least) break;
    made.turns.push_back(step);
  }
  const double growth = growth_of(old);
  const Step& like = old.turns[std::min(made.turns.size(), old.turns.size() - 1)];
  const std::size_t count = old.turns.size();
  const double turn = turn_between(old.turns[count - 2].to, old.turns[count - 1].to);
  const double by = like.sweep_rad != 0 ? std::copysign(std::fabs(turn), like.sweep_rad) : turn;
  double off = geometry::length(made.turns.empty() ? made.begin : made.turns.back().to);
  if (growth <= kSameRadius_mm || (made.turns.empty() && off <= kSameRadius_mm))
    return std::nullopt;
  while (off < wall - kSameRadius_mm && made.turns.size() < kMostTurns) {
    const Vec2 arm = made.turns.empty() ? made.begin : made.turns.back().to;
    const bool is_last = off + growth > wall - kSameRadius_mm;
    const double next = is_last ? wall : off + growth;
    made.turns.push_back({(next / off) * turned(arm, by), like.sweep_rad, like.like});
    off = next;
  }
  Vec2 arm = made.turns.back().to;
  for (const Step& step : old.around) {
    arm = turned(arm, step.sweep_rad);
    made.around.push_back({arm, step.sweep_rad, step.like});
  }
  return made;
}

/// Reads, and writes, one layer.
class SpiralWriter {
 public:
  SpiralWriter(const Recording& recording, const NewLayer& wanted, Span visit, double tool_radius)
      : recording_(recording),
        wanted_(wanted),
        layer_(wanted.feature->layers[wanted.layer]),
        visit_(visit),
        radius_(tool_radius),
        new_radius_(wanted.new_radius > 0 ? wanted.new_radius : tool_radius) {}

  [[nodiscard]] tl::expected<NewRows, CannotCut> write() {
    const auto was = round_of(layer_.nominal);
    const auto is = round_of(wanted_.outer);
    if (!was || !is || !layer_.nominal_islands.empty() || !wanted_.islands.empty())
      return cannot_edit("A SPIRAL CLEARS WHAT IS ROUND, WITHOUT ISLANDS");
    if (is->radius - new_radius_ <= kSameRadius_mm) return does_not_fit(wanted_.feature->tool);
    const auto old = read(*was);
    if (!old)
      return cannot_edit("THE TURNS OF THIS LAYER ARE NO SPIRAL OF ARCS OR LINES TO ITS WALL");
    const auto now = reaching(*old, was->radius - radius_, is->radius - new_radius_);
    if (!now) return cannot_edit("NO TURN OF THE SPIRAL WOULD BE LEFT");
    return rows_of(*now, is->centre);
  }

 private:
  [[nodiscard]] bool is_level(std::uint32_t row) const {
    return cuts_across_at(recording_, row, layer_.z);
  }

  [[nodiscard]] std::optional<Spiral> read(const Round& was) {
    std::vector<Step> steps;
    for (std::uint32_t row = visit_.first; row <= visit_.last; ++row) {
      if (!is_level(row)) continue;
      if (!steps.empty() && row != last_ + 1) return std::nullopt;
      if (steps.empty()) first_ = row;
      last_ = row;
      const bool is_arc = recording_.moves[row].shape == Move::Shape::arc;
      const double sweep = is_arc ? recording_.arc_of(row).sweep_rad : 0;
      steps.push_back({recording_.flat_to(row) - was.centre, sweep, row});
    }
    if (steps.size() < 3) return std::nullopt;
    return spiral_of(recording_.flat_from(first_) - was.centre, std::move(steps),
                     was.radius - radius_);
  }

  [[nodiscard]] tl::expected<NewRows, CannotCut> rows_of(const Spiral& spiral, Vec2 centre) const {
    std::vector<Step> steps = spiral.turns;
    steps.insert(steps.end(), spiral.around.begin(), spiral.around.end());
    Vec2 begin = spiral.begin;
    if (!spiral.is_inside_out) {
      const Vec2 end = steps.back().to;
      steps = backwards(begin, steps);
      begin = end;
    }
    VisitRows rows(recording_, visit_, layer_.z);
    rows.approach(first_, centre + begin);
    Contour way{{}, false};
    for (const Step& step : steps) {
      const auto is_whole = std::fabs(step.sweep_rad) > 2 * std::numbers::pi - 1e-6;
      const Contour part =
          is_whole ? circle(centre, begin, step) : line_or_arc(centre, begin, step);
      rows.go_along(part, step.like);
      way.vertices.insert(way.vertices.end(), part.vertices.begin(), part.vertices.end() - 1);
      begin = step.to;
    }
    way.vertices.push_back({centre + begin, 0, 0});
    rows.retract(last_);
    NewRows made;
    if (auto left = rest_of(way)) {
      if (!wanted_.allows_rest) return tl::unexpected(*left);
      made.left = std::move(left);
    }
    made.stretch = rows.done();
    return made;
  }
  static Contour line_or_arc(Vec2 centre, Vec2 from, const Step& step) {
    return {{{centre + from, math::tan(step.sweep_rad / 4), 0}, {centre + step.to, 0, 0}}, false};
  }
  static Contour circle(Vec2 centre, Vec2 from, const Step& step) {
    const double bulge = step.sweep_rad > 0 ? 1 : -1;
    return {{{centre + from, bulge, 0}, {centre - from, bulge, 0}, {centre + from, 0, 0}}, false};
  }

  [[nodiscard]] std::optional<CannotCut> rest_of(const Contour& way) const {
    const Clearing clearing{.region = region_between(wanted_.outer, wanted_.islands),
                            .tool_radius = new_radius_};
    const contour::Region rest = rest_behind(clearing, {way});
    if (rest.is_empty()) return std::nullopt;
    return left_uncut(contour::area(rest), contour::extents(rest).low);
  }

  const Recording& recording_;
  const NewLayer& wanted_;
  const Layer& layer_;
  Span visit_;
  double radius_;
  double new_radius_;
  std::uint32_t first_ = 0;  // rows at the level
  std::uint32_t last_ = 0;
};

}  // namespace

tl::expected<NewRows, CannotCut> regenerated_as_spiral(const Recording& recording,
                                                       const NewLayer& wanted, Span visit,
                                                       double tool_radius) {
  return SpiralWriter(recording, wanted, visit, tool_radius).write();
}

}  // namespace kerf::features
