#include "job/internal/stroke_watch.hpp"

#include <algorithm>

namespace kerf::job {
namespace {

constexpr bool kOn = true;

void add(const base::AxisVector& offset, base::AxisSet& axes) {
  for (std::size_t i = 0; i < offset.values.size(); ++i) {
    if (offset.values[i] != 0)
      axes =
          static_cast<base::AxisSet>(axes | base::only(base::Axis{static_cast<std::uint8_t>(i)}));
  }
}

}  // namespace

StrokeWatch::StrokeWatch(const machine::BatchRun& run)
    : run_(run),
      axes_(run.definition().axes),
      limits_(axes_, kOn, &length_),
      at_(axes_.start),
      known_(0),
      revision_(run.memory().revision) {
  know(run.definition().parameters.stroke_check ? static_cast<base::AxisSet>(~0U) : with_offsets());
}

void StrokeWatch::know(base::AxisSet axes) {
  known_ = static_cast<base::AxisSet>(known_ | axes);
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const motion::AxisConfig& whole = run_.definition().axes.axes[i];
    const bool is_known = base::contains(known_, base::Axis{static_cast<std::uint8_t>(i)});
    axes_.axes[i].travel_min = is_known ? whole.travel_min : 0;
    axes_.axes[i].travel_max = is_known ? whole.travel_max : 0;
  }
}

base::AxisSet StrokeWatch::with_offsets() const {
  const control::Memory& memory = run_.memory();
  base::AxisSet axes = 0;
  add(memory.external, axes);
  for (const base::AxisVector& offset : memory.work) add(offset, axes);
  for (const base::AxisVector& offset : memory.extended) add(offset, axes);
  for (const control::TurningOffset& tool : memory.turning) {
    base::AxisVector geometry;
    if (const auto x = axes_.find('X')) geometry[*x] = tool.geometry.x;
    if (const auto z = axes_.find('Z')) geometry[*z] = tool.geometry.z;
    add(geometry, axes);
  }
  return axes;
}

void StrokeWatch::look(const motion::Motion& motion, std::uint64_t number) {
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action))
    tool_ = change->tool;
  const base::TipPoint* const to = motion::target_of(motion);
  if (to == nullptr) return;
  if (run_.memory().revision != revision_) {
    revision_ = run_.memory().revision;
    know(with_offsets());
  }
  length_ = {};
  if (index(motion.length.axis) < axes_.count()) length_[motion.length.axis] = motion.length.mm;
  if (const auto beyond = limits_.refusal(at_, motion)) {
    findings_.add({.code = beyond->code,
                   .detail = beyond->sentence,
                   .block = motion.block,
                   .tool = tool_,
                   .motion = number});
  }
  at_ = *to;
}

void StrokeWatch::tell(stock::Judge& judge) {
  if (has_told_) return;
  has_told_ = true;
  for (const stock::Finding& finding : findings_.in_order()) judge.add(finding);
}

}  // namespace kerf::job
