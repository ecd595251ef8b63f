#include "job/internal/stroke_watch.hpp"

#include <algorithm>

namespace kerf::job {
namespace {

constexpr bool kOn = true;

bool is_any(const base::AxisVector& vector) {
  return std::any_of(vector.values.begin(), vector.values.end(), [](double v) { return v != 0; });
}

bool is_any(const control::TurningOffset::Part& part) {
  return part.x != 0 || part.y != 0 || part.z != 0;
}

}  // namespace

StrokeWatch::StrokeWatch(const machine::BatchRun& run)
    : run_(run),
      axes_(run.definition().axes),
      limits_(axes_, kOn, &length_),
      at_(axes_.start),
      is_known_(run.definition().parameters.stroke_check || has_offsets()),
      revision_(run.memory().revision) {}

bool StrokeWatch::has_offsets() const {
  const control::Memory& memory = run_.memory();
  const auto any = [](const base::AxisVector& vector) { return is_any(vector); };
  return is_any(memory.external) || std::any_of(memory.work.begin(), memory.work.end(), any) ||
         std::any_of(memory.extended.begin(), memory.extended.end(), any) ||
         std::any_of(memory.turning.begin(), memory.turning.end(),
                     [](const control::TurningOffset& tool) { return is_any(tool.geometry); });
}

void StrokeWatch::look(const motion::Motion& motion, std::uint64_t number) {
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) tool_ = change->tool;
  const base::TipPoint* const to = motion::target_of(motion);
  if (to == nullptr) return;
  if (!is_known_ && run_.memory().revision != revision_) {
    revision_ = run_.memory().revision;
    is_known_ = has_offsets();
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
  if (!is_known_ || has_told_) return;
  has_told_ = true;
  for (const stock::Finding& finding : findings_.in_order()) judge.add(finding);
}

}  // namespace kerf::job
