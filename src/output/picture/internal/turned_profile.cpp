#include "output/picture/internal/turned_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vec2.hpp"

namespace kerf::output::plot {

using geometry::Vec2;

namespace {

constexpr double kUncut = std::numeric_limits<double>::infinity();
constexpr double kThrough = 1e-3;  // mm: nearer to the axis is through
constexpr double kTan30 = 0.5773502691896258;

}  // namespace

/// The lowest place that a round edge has come to, by columns.
class TurnedProfile::Envelope {
 public:
  Envelope(double first_mm, double width_mm, std::size_t columns)
      : first_mm_(first_mm), width_mm_(width_mm), low_(columns, kUncut) {}

  /// A disc goes from `a` to `b`, places of its centre. Below its way lies the line that touches
  /// both discs, and at the ends they themselves.
  void disc(Vec2 a, Vec2 b, double radius) {
    const double way = length(b - a);
    const Vec2 below = way == 0 ? Vec2{} : (b.u < a.u ? 1 : -1) * (radius / way) * left_of(b - a);
    const Vec2 from = a + below, to = b + below;
    for_columns(
        std::min(a.u, b.u) - radius, std::max(a.u, b.u) + radius, [&](double z, double& low) {
          low = std::min({low, on_line(from, to, z), on_disc(a, radius, z), on_disc(b, radius, z)});
        });
  }

  /// A flat edge reaches down to `x` between two places.
  void flat(double left, double right, double x) {
    for_columns(left, right, [&](double, double& low) { low = std::min(low, x); });
  }

  [[nodiscard]] double low(std::size_t column) const { return low_[column]; }

 private:
  // The columns that hold the ends count whole, so that a wall is not lost between two middles.
  template <typename Act>
  void for_columns(double from, double to, Act act) {
    const auto count = static_cast<double>(low_.size());
    const double first = std::floor((from - first_mm_) / width_mm_);
    const double last = std::floor((to - first_mm_) / width_mm_);
    if (!(last >= 0 && first < count)) return;
    const auto end = static_cast<std::size_t>(std::min(last, count - 1));
    for (auto i = static_cast<std::size_t>(std::max(first, 0.0)); i <= end; ++i) {
      const double middle = first_mm_ + (static_cast<double>(i) + 0.5) * width_mm_;
      act(std::clamp(middle, from, to), low_[i]);
    }
  }

  static double on_line(Vec2 from, Vec2 to, double z) {
    if (from.u == to.u) return z == from.u ? std::min(from.v, to.v) : kUncut;
    const double t = (z - from.u) / (to.u - from.u);
    return t >= 0 && t <= 1 ? from.v + t * (to.v - from.v) : kUncut;
  }
  static double on_disc(Vec2 centre, double radius, double z) {
    const double aside = z - centre.u;
    const double square = radius * radius - aside * aside;
    return square >= 0 ? centre.v - std::sqrt(square) : kUncut;
  }

  double first_mm_, width_mm_;
  std::vector<double> low_;
};

TurnedProfile::TurnedProfile(const Path& path, std::span<const TurningInsert> inserts,
                             double first_mm, double last_mm, std::size_t columns)
    : first_mm_(first_mm),
      width_mm_((last_mm - first_mm) / static_cast<double>(columns)),
      columns_(columns) {
  Envelope outer(first_mm_, width_mm_, columns), inner = outer;
  take_cuts(path, inserts, outer, inner);
  join(outer, inner);
  cut_off(outer);
}

// Bores are seen in a mirror along the axis: there, too, the edge goes down.
void TurnedProfile::take_cuts(const Path& path, std::span<const TurningInsert> inserts,
                              Envelope& outer, Envelope& inner) const {
  using Kind = TurningInsert::Kind;
  for_each_cut(path, width_mm_ / 8, [&](const Pen& pen, const Point3& from, const Point3& to) {
    const TurningInsert& insert = inserts[pen.tool];
    const double side = (insert.inside ? -1 : 1) * (from[kX] + to[kX] < 0 ? -1 : 1);
    const Vec2 a{from[kZ], side * from[kX]}, b{to[kZ], side * to[kX]};
    Envelope& envelope = insert.inside ? inner : outer;
    if (insert.kind == Kind::rhomb) {
      const Vec2 nose{insert.nose().u, (insert.inside ? -1 : 1) * insert.nose().v};
      envelope.disc(a + nose, b + nose, insert.nose_mm);
    } else if (insert.kind == Kind::blade) {
      const double left = std::min(a.u, b.u) + insert.left_mm();
      envelope.flat(left, std::max(a.u, b.u) + insert.left_mm() + insert.width_mm,
                    std::min(a.v, b.v));
    } else if (insert.kind == Kind::drill && insert.width_mm > 0) {
      inner.flat(std::min(a.u, b.u), std::max(a.u, b.u), -insert.width_mm / 2);
    }
  });
}

// Around a bore that nobody turned outside there is stock as wide as the part is elsewhere.
void TurnedProfile::join(const Envelope& outer, const Envelope& inner) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (outer.low(i) < kUncut) columns_[i].outer = std::max(outer.low(i), 0.0);
    if (inner.low(i) < kUncut) columns_[i].inner = std::max(-inner.low(i), 0.0);
  }
  const double stock = largest_radius();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (outer.low(i) == kUncut && columns_[i].inner > 0) columns_[i].outer = stock;
  }
}

double TurnedProfile::largest_radius() const {
  constexpr double kWall = 1.3;  // of the bore, where nothing is turned at all
  double outer = 0, inner = 0;
  for (const Column& column : columns_) {
    outer = std::max(outer, column.outer);
    inner = std::max(inner, column.inner);
  }
  return outer > inner ? outer : kWall * inner;
}

// A cut to the axis is a face when most of what is turned lies behind it: what lies in front is
// air. A part that is cut off stays.
void TurnedProfile::cut_off(const Envelope& outer) {
  std::size_t turned = 0;
  for (const Column& column : columns_) turned += column.outer > kThrough;
  std::size_t behind = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    behind += columns_[i].outer > kThrough;
    if (outer.low(i) > kThrough || 2 * behind < turned) continue;
    return std::fill(columns_.begin() + static_cast<std::ptrdiff_t>(i), columns_.end(), Column{});
  }
}

void TurnedProfile::cut_thread(const ThreadCut& thread) {
  const double low = std::min(thread.from[kZ], thread.to[kZ]);
  const double high = std::max(thread.from[kZ], thread.to[kZ]);
  const double slope = (thread.to[kX] - thread.from[kX]) / (thread.to[kZ] - thread.from[kZ]);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double z = z_of(i);
    Column& column = columns_[i];
    if (z < low || z > high || !column.has_material()) continue;
    const double turns = (z - thread.from[kZ]) / thread.lead;
    const double flank = std::abs(turns - std::round(turns)) * thread.lead / kTan30;
    const double root = std::abs(thread.from[kX] + slope * (z - thread.from[kZ]));
    const bool outside = root > (column.inner + column.outer) / 2;
    if (outside) column.outer = std::min(column.outer, root + flank);
    if (!outside) column.inner = std::max(column.inner, root - flank);
  }
}

}  // namespace kerf::output::plot
