#include "output/picture/solid/internal/band.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::output::plot {
namespace {

constexpr std::int64_t kUnit = 256;  // to a sample

std::int64_t fixed(double at) { return static_cast<std::int64_t>(std::nearbyint(at * kUnit)); }

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

/// A side of a triangle: > 0 on its inner side; samples on it belong to one of the two triangles.
struct Side {
  std::int64_t dx, dy, at;

  Side(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1)
      : dx(y0 - y1), dy(x1 - x0), at(-(dx * x0 + dy * y0)) {
    const bool is_owner = dx > 0 || (dx == 0 && dy > 0);
    if (!is_owner) --at;
  }
  [[nodiscard]] std::int64_t value(std::int64_t x, std::int64_t y) const {
    return dx * x + dy * y + at;
  }
};

}  // namespace

void Band::draw(const SeenTriangle& t, const std::array<Vec3, 3>& normals) {
  std::array<std::int64_t, 3> x{};
  std::array<std::int64_t, 3> y{};
  for (std::size_t i = 0; i < 3; ++i) x[i] = fixed(t.x[i]), y[i] = fixed(t.y[i]);
  std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0) return;
  std::array<std::size_t, 3> order{0, 1, 2};
  if (area < 0) order = {0, 2, 1}, area = -area;
  const auto [a, b, c] = order;
  const std::array<Side, 3> sides{Side(x[b], y[b], x[c], y[c]), Side(x[c], y[c], x[a], y[a]),
                                  Side(x[a], y[a], x[b], y[b])};
  const auto [x_low, x_high] = std::minmax({x[0], x[1], x[2]});
  const auto [y_low, y_high] = std::minmax({y[0], y[1], y[2]});
  const auto from_x = std::max<std::int64_t>(0, floor_div(x_low, kUnit));
  const auto to_x = std::min<std::int64_t>(width_ - 1, floor_div(x_high, kUnit));
  const auto from_y = std::max<std::int64_t>(first_row_, floor_div(y_low, kUnit));
  const auto to_y = std::min<std::int64_t>(end_row() - 1, floor_div(y_high, kUnit));
  const double share = 1 / static_cast<double>(area);
  for (std::int64_t row = from_y; row <= to_y; ++row) {
    for (std::int64_t column = from_x; column <= to_x; ++column) {
      const std::int64_t px = column * kUnit + kUnit / 2;
      const std::int64_t py = row * kUnit + kUnit / 2;
      const std::int64_t wa = sides[0].value(px, py);
      const std::int64_t wb = sides[1].value(px, py);
      const std::int64_t wc = sides[2].value(px, py);
      if ((wa | wb | wc) < 0) continue;
      const double sa = static_cast<double>(wa) * share;
      const double sb = static_cast<double>(wb) * share;
      const double sc = 1 - sa - sb;
      const auto depth = static_cast<float>(sa * double{t.depth[a]} + sb * double{t.depth[b]} +
                                            sc * double{t.depth[c]});
      Sample& sample =
          samples_[static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(column)];
      if (!(depth > sample.depth)) continue;
      const Vec3 n = sa * normals[a] + (sb * normals[b] + sc * normals[c]);
      const double turned = n.z < 0 ? -1 : 1;
      const double size = std::sqrt(dot(n, n));
      const double scale = size > 0 ? turned / size : 0;
      sample.depth = depth;
      sample.normal = {static_cast<float>(scale * n.x), static_cast<float>(scale * n.y),
                       static_cast<float>(scale * n.z)};
      sample.paint = t.paint;
      sample.body = t.body;
    }
  }
}

}  // namespace kerf::output::plot
