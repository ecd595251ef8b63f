#include "features/rewrite/contour_chain.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kBeside_mm = 2.5e-3;  // what rounded words leave between a row and its element
constexpr double kLeastShare = 0.5;    // of the shorter one, that two lines have in common
constexpr double kLeastCommon_mm = 0.01;

double off_line(const Edge& line, Vec2 point) {
  return std::fabs(geometry::cross(geometry::unit(line.to - line.from), point - line.from));
}

bool are_lines_along(const Edge& a, const Edge& b) {
  const Vec2 way_a = a.to - a.from;
  const Vec2 way_b = b.to - b.from;
  const double length_a = geometry::length(way_a);
  const double length_b = geometry::length(way_b);
  if (length_a <= 0 || length_b <= 0 || geometry::dot(way_a, way_b) <= 0) return false;
  const bool is_on = length_a >= length_b
                         ? off_line(a, b.from) <= kBeside_mm && off_line(a, b.to) <= kBeside_mm
                         : off_line(b, a.from) <= kBeside_mm && off_line(b, a.to) <= kBeside_mm;
  if (!is_on) return false;
  const Vec2 unit = geometry::unit(way_a);
  const double begin = std::max(0.0, geometry::dot(unit, b.from - a.from));
  const double end = std::min(length_a, geometry::dot(unit, b.to - a.from));
  return end - begin >= std::min(kLeastCommon_mm, kLeastShare * std::min(length_a, length_b));
}

bool are_arcs_along(const Edge& a, const Edge& b) {
  if (std::signbit(a.bulge) != std::signbit(b.bulge)) return false;
  if (geometry::length(contour::centre(a) - contour::centre(b)) > 2 * kBeside_mm ||
      std::fabs(contour::radius(a) - contour::radius(b)) > 2 * kBeside_mm)
    return false;
  return contour::distance(a, contour::point_at(b, 0.5)) <= 2 * kBeside_mm ||
         contour::distance(b, contour::point_at(a, 0.5)) <= 2 * kBeside_mm;
}

/// Finds the element that each row goes along.
class ChainReader {
 public:
  ChainReader(const Recording& recording, const Contour& contour)
      : recording_(recording), count_(contour::edge_count(contour)), contour_(contour) {
    for (std::size_t i = 0; i < count_; ++i) elements_.push_back(contour::edge_of(contour, i));
  }

  [[nodiscard]] std::optional<ContourChain> read(Span rows) {
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
      if (goes_nowhere(row)) continue;
      const bool is_along =
          recording_.moves[row].cuts() && recording_.goes_across(row) && take(row);
      if (is_broken_) return std::nullopt;
      if (is_along) continue;
      if (chain_ && !ended_) ended_ = row;
    }
    if (!chain_) return std::nullopt;
    chain_->begin = recording_.flat_from(chain_->rows.first);
    chain_->end = recording_.flat_to(chain_->rows.last);
    return chain_;
  }

 private:
  [[nodiscard]] bool goes_nowhere(std::uint32_t row) const {
    return recording_.moves[row].shape == Move::Shape::line &&
           recording_.moves[row].to == recording_.from(row);
  }
  /// Whether the row goes along the contour; it must go on where the chain is by now.
  bool take(std::uint32_t row) {
    std::vector<Edge> edges;
    recording_.append_edges(row, edges);
    std::optional<std::size_t> at = at_;
    std::size_t steps = 0;
    std::optional<std::size_t> first;
    for (const Edge& edge : edges) {
      const auto element = element_along(edge, at);
      if (!element) return false;
      if (at) steps += (*element + count_ - *at) % count_;
      if (at && (*element + count_ - *at) % count_ > 1) is_broken_ = true;
      if (!first) first = element;
      at = element;
    }
    if (!first) return false;
    go_on(row, *first, steps);
    at_ = at;
    return true;
  }

  void go_on(std::uint32_t row, std::size_t first, std::size_t steps) {
    const double height = recording_.moves[row].to.z;
    if (!chain_) {
      chain_ =
          ContourChain{.rows = {row, row}, .contour = contour_, .first = first, .height = height};
    }
    if (ended_) is_broken_ = true;
    const bool climbs = std::fabs(height - chain_->height) > kSameZ_mm ||
                        std::fabs(recording_.from(row).z - chain_->height) > kSameZ_mm;
    if (climbs && !recording_.turns) is_broken_ = true;
    chain_->rows.last = row;
    chain_->steps += steps;
  }

  // The one that it is on by now, the next one, or any.
  [[nodiscard]] std::optional<std::size_t> element_along(const Edge& edge,
                                                         std::optional<std::size_t> at) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t element = (at.value_or(0) + i) % count_;
      if (lie_along(elements_[element], edge)) return element;
    }
    return std::nullopt;
  }

  const Recording& recording_;
  std::size_t count_;
  const Contour& contour_;
  std::vector<Edge> elements_{};
  std::optional<ContourChain> chain_{};
  std::optional<std::size_t> at_{};       // element
  std::optional<std::uint32_t> ended_{};  // first row behind the chain
  bool is_broken_ = false;
};

}  // namespace

bool lie_along(const Edge& a, const Edge& b) {
  if ((a.bulge == 0) != (b.bulge == 0)) return false;
  return a.bulge == 0 ? are_lines_along(a, b) : are_arcs_along(a, b);
}

std::optional<ContourChain> chain_along(const Recording& recording, Span rows,
                                        const Contour& contour) {
  if (contour::edge_count(contour) == 0) return std::nullopt;
  auto forwards = ChainReader(recording, contour).read(rows);
  if (forwards) return forwards;
  const Contour backwards = contour::reversed(contour);
  auto found = ChainReader(recording, backwards).read(rows);
  if (found) found->is_reversed = true;
  return found;
}

}  // namespace kerf::features
