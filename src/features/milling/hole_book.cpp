#include "features/milling/hole_book.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using How = HoleStep::How;
using Form = Hole::Form;

constexpr double kWider_mm = 1e-3;
constexpr double kMostFinished = 1.2;  // times what was drilled; what is wider is a step of its own

bool is_cylinder(How how) {
  return how == How::drill || how == How::ream || how == How::bore || how == How::mill ||
         how == How::helix;
}

bool has(const std::vector<HoleStep>& steps, How how) {
  return std::any_of(steps.begin(), steps.end(),
                     [&](const HoleStep& step) { return step.how == how; });
}

/// What goes deepest of what is as wide as it is said to be; else of all.
const HoleStep& main_step(const std::vector<HoleStep>& steps) {
  const auto deeper = [](const HoleStep& a, const HoleStep& b) {
    if (is_cylinder(a.how) != is_cylinder(b.how)) return is_cylinder(a.how);
    if (std::fabs(a.bottom - b.bottom) > kSameZ_mm) return a.bottom < b.bottom;
    return a.diameter > b.diameter;
  };
  return *std::min_element(steps.begin(), steps.end(), deeper);
}

/// As wide as reaming or boring has left what was drilled for it, if it goes down far enough to be
/// the same hole: the drill's tip is deeper.
double finished_diameter(const std::vector<HoleStep>& steps, const HoleStep& main) {
  double widest = main.diameter;
  for (const HoleStep& step : steps) {
    const bool finishes = step.how == How::ream || step.how == How::bore;
    const bool is_deep = step.bottom <= (main.top + main.bottom) / 2;
    if (finishes && is_deep && step.diameter <= kMostFinished * main.diameter)
      widest = std::max(widest, step.diameter);
  }
  return widest;
}

Form form_of(const std::vector<HoleStep>& steps, const HoleStep& main, double diameter) {
  if (has(steps, How::tap)) return Form::tapped;
  if (!is_cylinder(main.how))
    return has(steps, How::countersink) && steps.size() > 1 ? Form::countersink : Form::spot;
  bool is_stepped = false;
  for (const HoleStep& step : steps) {
    const bool is_wider = step.diameter > diameter + kWider_mm;
    if (!is_wider) continue;
    if (step.how == How::countersink || step.how == How::spot) return Form::countersink;
    if (step.how == How::mill || step.how == How::helix) return Form::counterbore;
    is_stepped = true;
  }
  return is_stepped ? Form::stepped : Form::plain;
}

// Each step as the cylinder to its tip; of what two of them go through the wider one counts.
double volume_of(const std::vector<HoleStep>& steps, double top) {
  std::vector<double> heights{top};
  for (const HoleStep& step : steps) {
    if (step.thread_pitch) continue;
    heights.push_back(std::min(step.bottom, top));
    heights.push_back(std::min(step.top, top));
  }
  std::sort(heights.begin(), heights.end());
  double sum = 0;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const double middle = (heights[i - 1] + heights[i]) / 2;
    double widest = 0;
    for (const HoleStep& step : steps) {
      if (!step.thread_pitch && step.bottom < middle && step.top > middle)
        widest = std::max(widest, step.diameter);
    }
    sum += std::numbers::pi / 4 * widest * widest * (heights[i] - heights[i - 1]);
  }
  return sum;
}

}  // namespace

void HoleBook::add(std::size_t setup, Vec2 at, HoleStep step) {
  Entry* const known = find(setup, at);
  if (known == nullptr) {
    places_[setup].add(at, static_cast<std::uint32_t>(entries_.size()));
    const std::uint32_t row = step.rows.front().first;
    entries_.push_back({setup, at, {std::move(step)}, row});
    return;
  }
  add_step(known->steps, std::move(step));
}

HoleBook::Entry* HoleBook::find(std::size_t setup, Vec2 at, double tolerance) {
  const auto place = places_[setup].near(at, tolerance);
  return place ? &entries_[*place] : nullptr;
}

std::vector<HoleBook::Entry> HoleBook::done() {
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.first_row < b.first_row; });
  for (Entry& entry : entries_) {
    std::stable_sort(entry.steps.begin(), entry.steps.end(),
                     [](const HoleStep& a, const HoleStep& b) {
                       return a.rows.front().first < b.rows.front().first;
                     });
  }
  return std::move(entries_);
}

double drilled_diameter(const std::vector<HoleStep>& steps) {
  double widest = 0;
  for (const HoleStep& step : steps) {
    if (step.how == How::drill || step.how == How::ream || step.how == How::bore)
      widest = std::max(widest, step.diameter);
  }
  return widest;
}

Hole hole_of(const HoleBook::Entry& entry, const std::optional<double>& bottom) {
  Hole hole{.setup = entry.setup, .tool = entry.steps.front().tool, .at = entry.at};
  hole.steps = entry.steps;
  const HoleStep& main = main_step(hole.steps);
  hole.diameter = finished_diameter(hole.steps, main);
  hole.top = hole.steps.front().top;
  hole.bottom = main.bottom;
  for (const HoleStep& step : hole.steps) {
    hole.top = std::max(hole.top, step.top);
    hole.bottom = std::min(hole.bottom, step.bottom);
    const auto pitch = step.thread_pitch;
    if (pitch) hole.thread = HoleThread{*pitch, step.diameter};
  }
  hole.form = form_of(hole.steps, main, hole.diameter);
  if (hole.thread && hole.form != Form::tapped) hole.form = Form::threaded;
  hole.through = bottom && hole.bottom <= *bottom + kSameZ_mm;
  hole.volume = volume_of(hole.steps, hole.top);
  return hole;
}

}  // namespace kerf::features
