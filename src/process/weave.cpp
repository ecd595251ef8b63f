#include "process/weave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::process {
namespace {

using contour::Edge;

/// A point of the course and what is to its left there.
struct Station {
  Vec2 at;
  Vec2 on;
};

class Course {
 public:
  explicit Course(std::span<const Edge> edges) : edges_(edges) {
    for (const Edge& edge : edges) whole_ += length(edge);
  }
  [[nodiscard]] double length_mm() const { return whole_; }

  /// Asked with ascending distances.
  Station at(double distance) {
    while (index_ + 1 < edges_.size() && distance > before_ + length(edges_[index_]))
      before_ += length(edges_[index_++]);
    const Edge& edge = edges_[index_];
    const double share = std::clamp((distance - before_) / length(edge), 0.0, 1.0);
    const Vec2 on = share < 1 ? tangent_at_start(part(edge, share, 1)) : tangent_at_end(edge);
    return {point_at(edge, share), geometry::unit(on)};
  }

 private:
  std::span<const Edge> edges_;
  double whole_ = 0;
  std::size_t index_ = 0;
  double before_ = 0;
};

double zigzag(double phase) {
  return phase < 0.25 ? 4 * phase : phase < 0.75 ? 2 - 4 * phase : 4 * phase - 4;
}

/// Along and across, mm, at a phase from 0 to 1 of a turn.
Vec2 swing(const Weave& weave, double phase) {
  const double half = 0.5 * weave.width_mm;
  if (weave.shape == Weave::Shape::zigzag) return {0, half * zigzag(phase)};
  const auto [sine, cosine] = math::sine_cosine(2 * std::numbers::pi * phase);
  if (weave.shape == Weave::Shape::sine) return {0, half * sine};
  return {half * (1 - cosine), half * sine};
}

}  // namespace

std::vector<Edge> woven(std::span<const Edge> edges, const Weave& weave) {
  constexpr double kPartsOfATurn = 48;
  Course course(edges);
  const double turns = course.length_mm() / weave.pitch_mm;
  const double parts = weave.shape == Weave::Shape::zigzag ? 4 : kPartsOfATurn;
  const auto point = [&](double turn) {
    const Station station = course.at(std::min(turn * weave.pitch_mm, course.length_mm()));
    const Vec2 by = swing(weave, turn - std::floor(turn));
    return station.at + by.u * station.on + by.v * geometry::left_of(station.on);
  };
  std::vector<Edge> way;
  Vec2 at = edges.front().from;
  const auto go = [&](Vec2 to) {
    way.push_back({at, to});
    at = to;
  };
  const double steps = std::ceil(turns * parts - 1e-9);
  for (double i = 1; i < steps; ++i) {
    const bool is_between = weave.shape == Weave::Shape::zigzag && std::fmod(i, 2) == 0;
    if (!is_between) go(point(i / parts));
  }
  go(edges.back().to);
  return way;
}

}  // namespace kerf::process
