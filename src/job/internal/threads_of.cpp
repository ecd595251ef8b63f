#include "job/internal/threads_of.hpp"

#include <algorithm>
#include <cmath>

#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

using Thread = output::StockFacts::Thread;

const stock::turned::TurnedPart* turned_part_of(const stock::Model& model) {
  if (const auto* const part = dynamic_cast<const stock::turnmill::TurnMillPart*>(&model))
    return &part->profile();
  return dynamic_cast<const stock::turned::TurnedPart*>(&model);
}

// A screw that is driven in clockwise advances away from who turns it: so does a tool while the
// work turns as with M03 and the tool goes to -Z.
Thread thread_of(const stock::turned::TurnedThread& thread, const stock::Cutter& cutter) {
  const auto begin = cutter.threads().find(thread.motion);
  const bool is_known = begin != cutter.threads().end();
  const bool is_left = is_known && begin->second.spindle == stock::Turning::left;
  const bool is_back = thread.axis == 'Z' && thread.to > thread.from;
  const auto at = [&](double along) {
    return thread.axis == 'Z' ? stock::Vec3{0, 0, along} : stock::Vec3{along, 0, 0};
  };
  return {.line = is_known ? begin->second.block.line : 0,
          .axis = thread.axis,
          .from = thread.from,
          .to = thread.to,
          .begin = at(thread.from),
          .end = at(thread.to),
          .major = thread.major,
          .minor = thread.minor,
          .pitch = thread.pitch,
          .starts = thread.starts,
          .hand = is_left != is_back ? stock::Hand::left : stock::Hand::right,
          .is_inside = thread.is_inside,
          .volume_mm3 = thread.volume_mm3,
          .motion = thread.motion};
}

Thread thread_of(const stock::CutThread& thread) {
  const stock::Vec3 way = thread.to - thread.from;
  const double x = std::fabs(way.x);
  const double y = std::fabs(way.y);
  const double z = std::fabs(way.z);
  const char axis = z >= x && z >= y ? 'Z' : x >= y ? 'X' : 'Y';
  const auto along = [&](stock::Vec3 p) { return axis == 'Z' ? p.z : axis == 'X' ? p.x : p.y; };
  return {.line = thread.block.line,
          .axis = axis,
          .from = along(thread.from),
          .to = along(thread.to),
          .begin = thread.from,
          .end = thread.to,
          .major = thread.major,
          .minor = thread.minor,
          .pitch = thread.pitch,
          .starts = thread.starts,
          .hand = thread.hand,
          .is_inside = thread.is_inside,
          .is_milled = thread.is_milled,
          .volume_mm3 = thread.volume_mm3,
          .motion = thread.motion};
}

}  // namespace

std::vector<output::StockFacts::Thread> threads_of(const stock::Model& model,
                                                   const stock::Cutter& cutter) {
  std::vector<Thread> out;
  if (const stock::turned::TurnedPart* const part = turned_part_of(model)) {
    for (const stock::turned::TurnedThread& each : part->threads())
      out.push_back(thread_of(each, cutter));
  }
  for (const stock::CutThread& each : cutter.cut_threads()) out.push_back(thread_of(each));
  std::stable_sort(out.begin(), out.end(),
                   [](const Thread& a, const Thread& b) { return a.motion < b.motion; });
  return out;
}

}  // namespace kerf::job
