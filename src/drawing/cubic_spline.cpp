#include "drawing/cubic_spline.hpp"

#include <cstddef>

namespace kerf::drawing {
namespace {

/// A row of equations in which each unknown meets its neighbours alone.
struct SplineRow {
  double before = 0;
  double own = 1;
  double behind = 0;
  double right = 0;
};

/// Gauss' elimination; the rows are dominated by `own`, so that nothing has to be exchanged.
std::vector<double> solve_rows(std::vector<SplineRow> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].before / rows[i - 1].own;
    rows[i].own -= factor * rows[i - 1].behind;
    rows[i].right -= factor * rows[i - 1].right;
  }
  std::vector<double> result(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const double known = i + 1 < rows.size() ? rows[i].behind * result[i + 1] : 0;
    result[i] = (rows[i].right - known) / rows[i].own;
  }
  return result;
}

/// The second derivatives are the same on both sides of a value.
SplineRow steady_row(double width_before, double rise_before, double width_behind,
                     double rise_behind) {
  const double before = 1 / width_before;
  const double behind = 1 / width_behind;
  return {before, 2 * (before + behind), behind,
          3 * (rise_before * before * before + rise_behind * behind * behind)};
}

}  // namespace

std::vector<double> spline_slopes(std::span<const double> at, std::span<const double> values,
                                  std::optional<double> first_slope,
                                  std::optional<double> last_slope) {
  const std::size_t last = values.size() - 1;
  const auto width = [&](std::size_t i) { return at[i + 1] - at[i]; };
  const auto rise = [&](std::size_t i) { return values[i + 1] - values[i]; };
  std::vector<SplineRow> rows(values.size());
  rows[0] =
      first_slope ? SplineRow{0, 1, 0, *first_slope} : SplineRow{0, 2, 1, 3 * rise(0) / width(0)};
  for (std::size_t i = 1; i < last; ++i)
    rows[i] = steady_row(width(i - 1), rise(i - 1), width(i), rise(i));
  rows[last] = last_slope ? SplineRow{0, 1, 0, *last_slope}
                          : SplineRow{1, 2, 0, 3 * rise(last - 1) / width(last - 1)};
  return solve_rows(std::move(rows));
}

// The corners of the matrix, which make the ring, are a product of two vectors taken off it
// (J. Sherman, W. J. Morrison, Ann. Math. Stat. 21, 1950).
std::vector<double> periodic_slopes(std::span<const double> at, std::span<const double> values) {
  const std::size_t count = values.size();
  const auto width = [&](std::size_t i) { return at[i + 1] - at[i]; };
  const auto rise = [&](std::size_t i) { return values[(i + 1) % count] - values[i]; };
  std::vector<SplineRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    rows[i] = steady_row(width(before), rise(before), width(i), rise(i));
  }
  const double corner = rows[0].before;  // which is that of the last row, too
  const double gamma = -rows[0].own;
  rows[0].own -= gamma;
  rows[count - 1].own -= corner * corner / gamma;
  std::vector<SplineRow> ring = rows;
  for (SplineRow& row : ring) row.right = 0;
  ring[0].right = gamma;
  ring[count - 1].right = corner;
  std::vector<double> slopes = solve_rows(std::move(rows));
  const std::vector<double> away = solve_rows(std::move(ring));
  const double share = corner / gamma;
  const double factor =
      (slopes[0] + share * slopes[count - 1]) / (1 + away[0] + share * away[count - 1]);
  for (std::size_t i = 0; i < count; ++i) slopes[i] -= factor * away[i];
  return slopes;
}

}  // namespace kerf::drawing
