#include "stock/dexel/preparation.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr double kLeast_mm = 0.001;
constexpr double kFixedOfCell = 0.01;
constexpr double kTurningOfCell = 0.02;

double turning_tolerance_mm(double cell_mm) {
  return std::max(kLeast_mm, kTurningOfCell * cell_mm);
}

const TurningWay* turning(const Sweep& sweep) { return std::get_if<TurningWay>(&sweep.way); }

/// Of the dexels that look along a direction best.
int main_axis(Vec3 up) {
  const double x = std::fabs(up.x);
  const double y = std::fabs(up.y);
  const double z = std::fabs(up.z);
  if (z >= x && z >= y) return 2;
  return x >= y ? 0 : 1;
}

/// Largest distance of a corner of the box around the middle from a place.
double farthest(Vec3 half, Vec3 place) {
  return math::hypot(std::fabs(place.x) + half.x, std::fabs(place.y) + half.y,
                     std::fabs(place.z) + half.z);
}

/// What is above the stock needs no turning.
void cut_off(std::vector<PosedSolid>& solids, double height) {
  const auto is_above = [&](const PosedSolid& each) { return each.solid.low >= height; };
  solids.erase(std::remove_if(solids.begin(), solids.end(), is_above), solids.end());
  for (PosedSolid& each : solids) each.solid.high = std::min(each.solid.high, height);
}

}  // namespace

double fixed_tolerance_mm(double cell_mm) { return std::min(kLeast_mm, kFixedOfCell * cell_mm); }

bool Trail::goes_on(const Sweep& sweep) const {
  return is_cut && turning(sweep) == nullptr && sweep.body == body && sweep.axis == axis &&
         point_at(sweep.way, 0) == tip;
}

Trail Trail::after(const Sweep& sweep, const Tool& tool) {
  const bool is_cut = tool.body.cuts && turning(sweep) == nullptr && sweep.kind == SweepKind::cut;
  return {is_cut, sweep.body, sweep.axis, point_at(sweep.way, 1)};
}

Preparation::Preparation(std::span<const Sweep> sweeps, const std::deque<Tool>& tools,
                         const StockPlace& place, Trail& trail)
    : place_(place) {
  std::vector<std::size_t> ends;
  for (const Sweep& sweep : sweeps) {
    append_strokes(sweep.way, place_.middle, fixed_tolerance_mm(place_.cell_mm) / 2, strokes_);
    ends.push_back(strokes_.size());
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const Tool& tool = tools[sweeps[i].body];
    add(sweeps[i], tool, {strokes_.data() + begin, ends[i] - begin}, trail.goes_on(sweeps[i]));
    trail = Trail::after(sweeps[i], tool);
    begin = ends[i];
  }
}

void Preparation::add(const Sweep& sweep, const Tool& tool, std::span<const Stroke> strokes,
                      bool follows) {
  Task task;
  task.sweep = &sweep;
  task.posed = &posed(sweep, tool);
  task.strokes = strokes;
  task.number = tasks_.size();
  task.main_axis = main_axis(sweep.axis);
  task.turn_tolerance_mm = turning_tolerance_mm(place_.cell_mm);
  task.follows = follows;
  tasks_.push_back(task);
}

const PosedTool& Preparation::posed(const Sweep& sweep, const Tool& tool) {
  const TurningWay* way = turning(sweep);
  const bool is_same = way == nullptr && has_fixed_ && posed_.back().tool == &tool &&
                       posed_.back().frame.up == sweep.axis;
  if (!is_same) posed_.push_back(PosedTool::of(tool, sweep.axis, place_.block_mm));
  has_fixed_ = way == nullptr;
  if (way != nullptr) limit(posed_.back(), *way);
  return posed_.back();
}

void Preparation::limit(PosedTool& posed, const TurningWay& way) const {
  const double height = std::max(farthest(place_.half, way.from - place_.middle),
                                 farthest(place_.half, way.to - place_.middle));
  cut_off(posed.solids, height);
  cut_off(posed.touching, height);
  const double all = math::hypot(std::min(height, posed.tool->height), posed.tool->widest);
  posed.reach = {{-all, -all, -all}, {all, all, all}};
}

Bounds Preparation::box(const Task& task) const {
  const Bounds tips = bounds(task.sweep->way);
  const Bounds& reach = task.posed->reach;
  return {tips.low - place_.middle + reach.low, tips.high - place_.middle + reach.high};
}

}  // namespace kerf::stock::dexel
