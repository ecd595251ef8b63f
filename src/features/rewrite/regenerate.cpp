#include "features/rewrite/regenerate.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/rewrite/clearing.hpp"
#include "features/rewrite/loop_rows.hpp"
#include "features/rewrite/open_layer.hpp"
#include "features/rewrite/tool_fit.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Region;

tl::unexpected<CannotCut> refuse(Code code, std::string sentence) {
  return tl::unexpected(CannotCut{code, std::move(sentence)});
}

double step_of(const std::vector<double>& distances, double radius) {
  if (distances.size() < 2) return radius;
  std::vector<double> steps;
  for (std::size_t i = 1; i < distances.size(); ++i)
    steps.push_back(distances[i] - distances[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  return steps[steps.size() / 2];
}

bool is_same_distance(double a, double b) { return std::fabs(a - b) <= 2 * kSamePoint_mm; }

std::vector<double> distances_in(const std::vector<OldLoop>& loops) {
  std::vector<double> distances;
  for (const OldLoop& loop : loops) distances.push_back(loop.distance);
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end(), is_same_distance),
                  distances.end());
  return distances;
}

/// Cuts a layer anew.
class LayerWriter {
 public:
  LayerWriter(const Recording& recording, OldWays& ways, const NewLayer& wanted)
      : recording_(recording),
        ways_(ways),
        wanted_(wanted),
        layer_(wanted.feature->layers[wanted.layer]),
        visit_(whole_visit(recording, layer_)),
        at_(recording.from(visit_.first)) {}

  [[nodiscard]] tl::expected<NewRows, CannotCut> write() {
    if (auto known = look(); !known) return tl::unexpected(known.error());
    if (auto fits = check_corners(clearing_); !fits) return tl::unexpected(fits.error());
    if (wanted_.centre_line != nullptr) return along_path(*wanted_.centre_line);
    if (layer_.loops.empty()) return along_line();
    if (shift_ != 0) look_for_rest();
    if (left_ && !wanted_.allows_rest) return tl::unexpected(*left_);
    std::vector<double> old_distances = distances_in(olds_);
    const double step = step_of(old_distances, clearing_.tool_radius);
    for (double& distance : old_distances) distance += shift_;
    const auto distances = distances_of(clearing_, old_distances, step);
    if (distances.from_wall.empty()) return does_not_fit(wanted_.feature->tool);
    if (distances.rest_mm2 > 0) left_ = left_uncut(distances.rest_mm2, distances.rest_at);
    if (left_ && !wanted_.allows_rest) return tl::unexpected(*left_);
    for (const double distance : in_order(distances.from_wall)) cut_round(distance);
    retract();
    align(recording_, visit_, recording_.from(visit_.first), rows_);
    return NewRows{{visit_, std::move(rows_)}, left_};
  }

 private:
  [[nodiscard]] tl::expected<void, CannotCut> look() {
    const bool is_one_way = wanted_.centre_line != nullptr ? is_one_pass() : is_one_line();
    if ((layer_.loops.empty() && !is_one_way) || layer_.nominal.vertices.empty() ||
        layer_.visits.size() != 1) {
      return refuse(Code::edit_not_editable,
                    "THIS LAYER IS NOT CUT IN CLOSED LOOPS: IT CAN BE MOVED, DEEPENED OR DELETED");
    }
    const OldWay& old_way = ways_.of(layer_);
    olds_ = old_way.loops;
    clearing_ = {.region = region_between(wanted_.outer, wanted_.islands),
                 .is_outside = bounds_what_stands(*wanted_.feature),
                 .tool_radius = radius_of_tool(recording_, wanted_, visit_),
                 .has_sharp_corners = old_way.turns_sharply};
    if (clearing_.tool_radius <= 0) return unknown_tool();
    if (wanted_.new_radius > 0) {
      shift_ = wanted_.new_radius - clearing_.tool_radius;
      clearing_.tool_radius = wanted_.new_radius;
    }
    if (olds_.empty()) return {};
    is_reversed_ =
        contour::is_counterclockwise(olds_.front().path) != runs_counterclockwise(olds_.front());
    return {};
  }

  // A slot that is one straight pass.
  [[nodiscard]] bool is_one_line() const {
    if (layer_.cuts.size() != 1 || layer_.cuts.front().first != layer_.cuts.front().last)
      return false;
    return recording_.moves[layer_.cuts.front().first].shape == Move::Shape::line;
  }

  // Several rows one behind the other, and none of them comes back.
  [[nodiscard]] bool is_one_pass() const { return layer_.cuts.size() == 1 && layer_.loops.empty(); }

  // From the end that is nearer to where the old pass began.
  [[nodiscard]] tl::expected<NewRows, CannotCut> along_path(const Contour& path) {
    if (!is_one_pass())
      return refuse(Code::edit_not_editable, "A CENTRE LINE IS THE WAY OF ONE PASS");
    const Span cut = layer_.cuts.front();
    const Vec2 from = recording_.flat_from(cut.first);
    const bool is_reversed = geometry::length(path.vertices.back().point - from) <
                             geometry::length(path.vertices.front().point - from);
    const Contour way = is_reversed ? contour::reversed(path) : path;
    const Vec2 start = way.vertices.front().point;
    for (std::uint32_t row = visit_.first; row < cut.first; ++row) put_moved(row, start - from);
    append_loop(way, layer_.z, cut.first, rows_);
    const Vec2 by = way.vertices.back().point - recording_.flat_to(cut.last);
    for (std::uint32_t row = cut.last + 1; row <= visit_.last; ++row) put_moved(row, by);
    align(recording_, visit_, recording_.from(visit_.first), rows_);
    return NewRows{{visit_, std::move(rows_)}, std::nullopt};
  }

  // What another tool does not reach, but for sharp corners: those no tool reaches.
  void look_for_rest() {
    if (clearing_.is_outside) return;
    const Region rest = contour::offset(
        contour::subtract(clearing_.region, opened(clearing_.region, clearing_.tool_radius)),
        -kSamePoint_mm);
    for (const Contour& piece : rest.loops) {
      const double area = contour::area(piece);
      if (area <= kEmptyArea_mm2 || has_sharp_corner(piece)) continue;
      left_ = left_uncut(area, contour::extents(piece).low);
      return;
    }
  }
  [[nodiscard]] bool has_sharp_corner(const Contour& piece) const {
    for (const Contour& wall : clearing_.region.loops) {
      for (const contour::Vertex& vertex : wall.vertices) {
        if (contour::distance(piece, vertex.point) <= 3 * kSamePoint_mm) return true;
      }
    }
    return false;
  }

  // The pass between the centres of the ends of a stadium as wide as the tool.
  [[nodiscard]] tl::expected<NewRows, CannotCut> along_line() {
    std::vector<Vec2> ends;
    for (std::size_t i = 0; i < contour::edge_count(wanted_.outer); ++i) {
      const contour::Edge edge = contour::edge_of(wanted_.outer, i);
      const bool is_end = edge.bulge > 0 &&
                          std::fabs(contour::radius(edge) - clearing_.tool_radius) <= kSamePoint_mm;
      if (is_end) ends.push_back(contour::centre(edge));
    }
    if (ends.size() != 2 || wanted_.outer.vertices.size() != 4 || !wanted_.islands.empty()) {
      return refuse(Code::edit_not_editable,
                    "ONE PASS CUTS A SLOT AS WIDE AS ITS TOOL, WITH ROUND ENDS");
    }
    const std::uint32_t cut = layer_.cuts.front().first;
    const Vec2 from = recording_.flat_from(cut);
    if (geometry::length(ends[1] - from) < geometry::length(ends[0] - from))
      std::swap(ends[0], ends[1]);
    for (std::uint32_t row = visit_.first; row < cut; ++row) put_moved(row, ends[0] - from);
    put_moved(cut, ends[1] - recording_.flat_to(cut));
    for (std::uint32_t row = cut + 1; row <= visit_.last; ++row)
      put_moved(row, ends[1] - recording_.flat_to(cut));
    return NewRows{{visit_, std::move(rows_)}, left_};
  }

  // What a loop at the distance of an old one would do by itself.
  [[nodiscard]] bool runs_counterclockwise(const OldLoop& old) const {
    if (layer_.nominal_islands.empty()) return true;
    const double to_outer = contour::distance(layer_.nominal, old.path.vertices.front().point);
    for (const Contour& island : layer_.nominal_islands) {
      if (contour::distance(island, old.path.vertices.front().point) < to_outer - kSamePoint_mm)
        return false;
    }
    return true;
  }

  [[nodiscard]] std::vector<double> in_order(std::vector<double> distances) const {
    const bool begins_inside = olds_.size() > 1 && olds_.front().distance > olds_.back().distance;
    if (begins_inside) std::reverse(distances.begin(), distances.end());
    return distances;
  }

  // All loops of one distance, the nearest one next.
  void cut_round(double distance) {
    std::vector<Contour> loops = loops_at(clearing_, distance);
    while (!loops.empty()) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < loops.size(); ++i) {
        if (contour::distance(loops[i], next_start(distance)) <
            contour::distance(loops[best], next_start(distance)))
          best = i;
      }
      Contour loop = is_reversed_ ? contour::reversed(loops[best]) : loops[best];
      loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(best));
      cut(begun(loop, distance));
    }
  }

  [[nodiscard]] const OldLoop* old_at(double distance) const {
    for (std::size_t i = 0; i < olds_.size(); ++i) {
      if (!used(i) && is_same_distance(olds_[i].distance + shift_, distance)) return &olds_[i];
    }
    return nullptr;
  }
  [[nodiscard]] bool used(std::size_t i) const {
    return std::find(used_.begin(), used_.end(), i) != used_.end();
  }
  [[nodiscard]] Vec2 next_start(double distance) const {
    if (const OldLoop* const old = old_at(distance)) return old->path.vertices.front().point;
    if (!has_cut_) return olds_.front().path.vertices.front().point;
    return {at_.x, at_.y};
  }
  [[nodiscard]] Contour begun(const Contour& loop, double distance) {
    const OldLoop* const old = old_at(distance);
    if (old != nullptr) used_.push_back(static_cast<std::size_t>(old - olds_.data()));
    if (old != nullptr) return begun_like(loop, *old);
    return begun_like(loop, has_cut_ ? last_ : olds_.front());
  }

  void cut(const Contour& loop) {
    const Vec2 start = loop.vertices.front().point;
    if (has_cut_) {
      link(start);
    } else {
      approach(start);
    }
    has_cut_ = true;
    append_loop(loop, layer_.z, olds_.front().rows.first, rows_);
    at_ = rows_.back().to;
    last_ = {.path = loop, .begins_at_corner = olds_.front().begins_at_corner};
  }

  // The rows before the first loop, moved by as much as its start.
  void approach(Vec2 start) {
    const std::uint32_t first = olds_.front().rows.first;
    const Vec2 by = start - recording_.flat_from(first);
    for (std::uint32_t row = visit_.first; row < first; ++row) put_moved(row, by);
    at_ = {start.u, start.v, layer_.z};
  }

  // Straight, as the loops were linked, or over the work where the wall is in the way.
  void link(Vec2 start) {
    const Vec2 from{at_.x, at_.y};
    if (geometry::length(start - from) <= kSamePoint_mm) return;
    const std::uint32_t like =
        olds_.size() > 1 && !layer_.links.empty() ? layer_.links.front() : olds_.front().rows.first;
    if (is_clear(clearing_, from, start)) {
      rows_.push_back({.to = {start.u, start.v, layer_.z}, .like = like});
      return;
    }
    const std::uint32_t up = olds_.back().rows.last + 1;
    const double clear_z = recording_.moves[std::min(up, visit_.last)].to.z;
    rows_.push_back({.to = {at_.x, at_.y, clear_z}, .kind = Move::Kind::rapid, .like = like});
    rows_.push_back({.to = {start.u, start.v, clear_z}, .kind = Move::Kind::rapid, .like = like});
    rows_.push_back({.to = {start.u, start.v, layer_.z}, .like = olds_.front().rows.first - 1});
  }

  // The rows behind the last loop, moved by as much as its end; what goes elsewhere goes there.
  void retract() {
    const std::uint32_t last = olds_.back().rows.last;
    const Vec2 by = Vec2{at_.x, at_.y} - recording_.flat_to(last);
    for (std::uint32_t row = last + 1; row <= visit_.last; ++row) put_moved(row, by);
  }

  void put_moved(std::uint32_t row, Vec2 by) {
    PlannedRow planned = as_it_is(recording_, row);
    planned.to = planned.to + Vec3{by.u, by.v, 0};
    if (planned.arc) planned.arc->centre = planned.arc->centre + by;
    rows_.push_back(planned);
  }

  const Recording& recording_;
  OldWays& ways_;
  const NewLayer& wanted_;
  const Layer& layer_;
  Span visit_;
  Vec3 at_;
  Clearing clearing_{};
  std::vector<OldLoop> olds_{};
  std::vector<std::size_t> used_{};
  OldLoop last_{};    // that was cut, where it began
  double shift_ = 0;  // by how much another tool is wider, in radii
  bool is_reversed_ = false;
  bool has_cut_ = false;
  std::vector<PlannedRow> rows_{};
  std::optional<CannotCut> left_{};
};

}  // namespace

bool bounds_what_stands(const Feature& feature) {
  return feature.type == FeatureType::outside_profile || feature.type == FeatureType::boss;
}

Span whole_visit(const Recording& recording, const Layer& layer) {
  Span span = layer.visits.front();
  for (const Span& visit : layer.visits) {
    span.first = std::min(span.first, visit.first);
    span.last = std::max(span.last, visit.last);
  }
  for (const Span& cut : layer.cuts) {
    span.first = std::min(span.first, cut.first);
    span.last = std::max(span.last, cut.last);
  }
  const Vec2 start = recording.flat_from(span.first);
  const auto comes_to_start = [&](std::uint32_t row) {
    const bool is_retract = row > 0 && recording.moves[row - 1].cuts() &&
                            is_upright(recording, row) &&
                            recording.moves[row].to.z > recording.from(row).z;
    return !is_retract && recording.moves[row].kind == Move::Kind::rapid &&
           recording.begins.count(row + 1) == 0 &&
           geometry::length(recording.flat_to(row) - start) <= kSamePoint_mm;
  };
  const bool is_there =
      recording.moves[span.first].kind != Move::Kind::rapid || is_upright(recording, span.first);
  if (!is_there) return span;
  while (span.first > 0 && comes_to_start(span.first - 1)) {
    --span.first;
    if (!is_upright(recording, span.first)) break;
  }
  return span;
}

tl::expected<NewRows, CannotCut> regenerated(const Recording& recording, OldWays& ways,
                                             const NewLayer& wanted) {
  if (wanted.centre_line == nullptr && is_in_lines_or_turns(recording, wanted)) {
    auto made = in_lines_or_turns(recording, wanted);
    const bool has_loops = wanted.feature->strategy == Strategy::single ||
                           wanted.feature->strategy == Strategy::contour_parallel;
    if (made || !has_loops || made.error().code != Code::edit_not_editable) return made;
  }
  return LayerWriter(recording, ways, wanted).write();
}

}  // namespace kerf::features
