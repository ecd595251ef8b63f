#include "control/gcode/cycles/monotone_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "geometry/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::control {
namespace {

using geometry::Vec2;

// Ends of pieces that are no farther apart are one point.
constexpr double kNoLength_mm = 1e-9;
constexpr double kQuarter_rad = std::numbers::pi / 2;

double between(double value, double a, double b) {
  return std::clamp(value, std::min(a, b), std::max(a, b));
}

// Where the circle of a quarter has the height: on the side of the centre on which the quarter is.
double on_circle(const MonotonePiece& arc, double height, double fraction) {
  const double r_from = length(arc.from - arc.centre);
  const double r = r_from + fraction * (length(arc.to - arc.centre) - r_from);
  const double above = height - arc.centre.v;
  const double aside = std::sqrt(std::max(0.0, (r - above) * (r + above)));
  const bool ahead = arc.from.u + arc.to.u >= 2 * arc.centre.u;
  return between(ahead ? arc.centre.u + aside : arc.centre.u - aside, arc.from.u, arc.to.u);
}

// Collects pieces, without those that have no length.
class Chain {
 public:
  void add(MonotonePiece piece) {
    if (!pieces.empty()) piece.from = pieces.back().to;
    const Vec2 way = piece.to - piece.from;
    if (std::max(std::fabs(way.u), std::fabs(way.v)) > kNoLength_mm) pieces.push_back(piece);
  }
  // Parts of an arc, each up to one of the points where it turns back.
  void add_arc(const MonotonePiece& arc);

  std::vector<MonotonePiece> pieces;
};

Vec2 quarter_direction(int quarter) {
  constexpr std::array<Vec2, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return kDirections[static_cast<std::size_t>(((quarter % 4) + 4) % 4)];
}

void Chain::add_arc(const MonotonePiece& arc) {
  const Vec2 arm = arc.from - arc.centre;
  const double r = length(arm);
  const double r_growth = length(arc.to - arc.centre) - r;
  const double begin_rad = math::atan2(arm.v, arm.u);
  const double sweep_rad = geometry::sweep_rad(arc.from, arc.to, arc.centre, arc.clockwise);
  const int step = arc.clockwise ? -1 : 1;
  const double quarters = begin_rad / kQuarter_rad;
  int quarter = static_cast<int>(arc.clockwise ? std::ceil(quarters) : std::floor(quarters)) + step;
  const auto swept = [&] { return step * (quarter * kQuarter_rad - begin_rad); };
  for (MonotonePiece part = arc; swept() < sweep_rad; quarter += step) {
    const double r_here = r + r_growth * (swept() / sweep_rad);
    part.to = arc.centre + r_here * quarter_direction(quarter);
    // Beside an end the arc does not turn back by more than rounding.
    if (length(part.to - arc.to) > kNoLength_mm) add(part);
  }
  add(arc);
}

}  // namespace

Vec2 MonotonePiece::at_height(double height) const {
  const double rise = to.v - from.v;
  const double fraction = rise == 0 ? 0 : std::clamp((height - from.v) / rise, 0.0, 1.0);
  if (fraction == 0) return from;
  if (fraction == 1) return to;
  const double u =
      is_arc ? on_circle(*this, height, fraction) : from.u + fraction * (to.u - from.u);
  return {u, height};
}

std::vector<MonotonePiece> monotone_pieces(const TurningShape& shape, const TurningFrame& frame,
                                           Vec2 offset) {
  const auto local = [&](Vec2 point) { return frame.local(point + offset); };
  Chain chain;
  for (const ShapePiece& piece : shape.pieces) {
    const MonotonePiece whole{.from = local(piece.from),
                              .to = local(piece.to),
                              .is_arc = piece.is_arc,
                              .clockwise = piece.clockwise != frame.turns_over(),
                              .centre = local(piece.centre),
                              .block = piece.block};
    if (piece.is_arc) {
      chain.add_arc(whole);
    } else {
      chain.add(whole);
    }
  }
  return std::move(chain.pieces);
}

void drop_way_back(std::vector<MonotonePiece>& pieces) {
  const auto leads_back = [](const MonotonePiece& piece) {
    return piece.to.u < piece.from.u - geometry::kSamePoint_mm;
  };
  while (!pieces.empty() && leads_back(pieces.back())) pieces.pop_back();
}

}  // namespace kerf::control
