#include "output/picture/internal/shading.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

double nearness(const Point3& p) { return p[kX] - p[kY]; }  // in the isometric view

std::size_t step_of(double fraction, std::size_t count) {
  const double scaled = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count);
  return std::min(static_cast<std::size_t>(scaled), count - 1);
}

// Mean and standard deviation of the height of the cuts.
struct Heights {
  double length = 0, sum = 0, squares = 0;
  void add(const Point3& from, const Point3& to) {
    const Point3 step = to - from;
    const double weight = std::abs(step[kX]) + std::abs(step[kY]);
    const double z = (from[kZ] + to[kZ]) / 2;
    length += weight;
    sum += weight * z;
    squares += weight * z * z;
  }
  [[nodiscard]] double mean() const { return length > 0 ? sum / length : 0; }
  [[nodiscard]] double spread() const {
    return length > 0 ? std::sqrt(std::max(0.0, squares / length - mean() * mean())) : 0;
  }
};

std::uint8_t mixed(std::uint8_t part, std::uint8_t with, double share) {
  return static_cast<std::uint8_t>(part + (with - part) * share + 0.5);
}

}  // namespace

Shading::Shading(const Subject& subject, Order order)
    : order_(order),
      layers_(std::clamp<std::size_t>(64 / std::max<std::size_t>(1, subject.cutters.size()), 4,
                                      kMostLayers)) {
  const Box3& box = subject.box;
  back_ = box.low()[kX] - box.high()[kY];
  depth_ = std::max(box.size()[kX] + box.size()[kY], 1e-12);
  Heights heights;
  for (std::size_t i = 0; i < subject.path.strokes.size(); ++i) {
    if (subject.path.strokes[i].pen.trace != Trace::cut) continue;
    const auto vertices = subject.path.vertices_of(i);
    for (std::size_t v = 1; v < vertices.size(); ++v) {
      heights.add(vertices[v - 1].at, vertices[v].at);
    }
  }
  mean_height_ = heights.mean();
  height_spread_ = heights.spread();
}

std::size_t Shading::layer(const Point3& from, const Point3& to, double progress) const {
  if (order_ == Order::in_time) return step_of(progress, layers_);
  return step_of(((nearness(from) + nearness(to)) / 2 - back_) / depth_, layers_);
}

std::size_t Shading::shade(const Point3& from, const Point3& to) const {
  constexpr double kLightX = 0.93, kLightY = -0.37;  // what rises this way is lit
  const Point3 step = to - from;
  const double level = math::hypot(step[kX], step[kY]);
  const double length = math::hypot(level, step[kZ]);
  const double along_light = step[kX] * kLightX + step[kY] * kLightY;
  const double lit = level > 0 ? step[kZ] * along_light / (level * length) : 0;
  const double above = (from[kZ] + to[kZ]) / 2 - mean_height_;
  const double high =
      height_spread_ > 1e-9 ? std::clamp(above / (2 * height_spread_), -1.0, 1.0) : 0;
  return step_of(0.5 + 0.28 * high + 0.45 * lit, kShades);
}

Color Shading::tint(Color color, std::size_t shade) {
  const double at = (static_cast<double>(shade) + 0.5) / kShades * 2 - 1;
  const std::uint8_t with = at > 0 ? 255 : 0;
  const double share = at > 0 ? 0.75 * at : -0.65 * at;
  return {mixed(color.red, with, share), mixed(color.green, with, share),
          mixed(color.blue, with, share)};
}

}  // namespace kerf::output::plot
