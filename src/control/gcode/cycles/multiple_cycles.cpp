#include "control/gcode/cycles/multiple_cycles.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;
using geometry::Vec2;

constexpr std::int64_t kMostThreadCode = 999999;  // P: passes, run-out, angle, two digits each
constexpr std::array<std::int64_t, 6> kTipAngles = {0, 29, 30, 55, 60, 80};

}  // namespace

bool MultipleCycles::execute(Meaning cycle, const Words& words, bool& moved) {
  const bool sets = !words.has_any(targets_.letters());
  if (cycle == Meaning::compound_thread) {
    if (sets) return set_thread(words);
    moved = true;
    return thread(words);
  }
  if (sets) return set_retreat(words);
  moved = true;
  return pecks(words, cycle == Meaning::face_pecks);
}

bool MultipleCycles::read_end(const Words& words, const motion::PlaneAxes& axes, Vec2& end) {
  Target target;
  if (!targets_.read(words, target)) return false;
  end = axes.project(state_.coordinates.path_of(target.program));
  return true;
}

// P and Q of cycles count least increments and take no decimal point.
bool MultipleCycles::in_increments(const Word& word, double& mm) {
  if (word.has(WordFlag::literal) && word.has(WordFlag::point))
    return state_.alarms.raise(Code::illegal_decimal_point, word.text);
  double count = 0;
  if (!state_.values.plain(word, count)) return false;
  mm = base::tidy(count * (state_.modal.inch() ? 0.00254 : 0.001));
  return true;
}

// G74 R and G75 R.
bool MultipleCycles::set_retreat(const Words& words) {
  if (!words.has('R')) return true;
  double retreat = 0;
  if (!state_.values.length(words['R'], retreat)) return false;
  if (retreat < 0) return state_.alarms.raise(Code::peck_step_negative, words['R'].text);
  state_.parameters.peck_retreat = retreat;
  return true;
}

// The word of the two-block form, or that of the one-block form.
bool MultipleCycles::read_amount(const Words& words, char letter, char one_block, double& mm) {
  const char written = words.has(letter) ? letter : one_block;
  if (!words.has(written)) return true;
  const Word& word = words[written];
  const bool good = written == letter ? in_increments(word, mm) : state_.values.length(word, mm);
  if (!good) return false;
  return mm >= 0 || state_.alarms.raise(Code::peck_step_negative, word.text);
}

bool MultipleCycles::read_pecks(const Words& words, PeckPlan& plan) {
  double along_x = 0;
  double along_z = 0;
  if (!read_amount(words, 'P', 'I', along_x) || !read_amount(words, 'Q', 'K', along_z))
    return false;
  const char relief = words.has('R') ? 'R' : 'D';
  if (words.has(relief) && !state_.values.length(words[relief], plan.relief)) return false;
  if (plan.relief < 0) return state_.alarms.raise(Code::peck_relief, words[relief].text);
  if ((plan.home.v != plan.end.v && along_x <= 0) || (plan.home.u != plan.end.u && along_z <= 0))
    return state_.alarms.raise(Code::peck_step_missing,
                               along_x <= 0 && plan.home.v != plan.end.v ? "P for X" : "Q for Z");
  plan.peck = plan.along_z ? along_z : along_x;
  plan.step = plan.along_z ? along_x : along_z;
  return true;
}

bool MultipleCycles::pecks(const Words& words, bool along_z) {
  motion::PlaneAxes axes;
  PeckPlan plan{.along_z = along_z, .retreat = state_.parameters.peck_retreat};
  if (!turning_.plane(axes) || !read_end(words, axes, plan.end)) return false;
  plan.home = TurningCycle::place(state_.coordinates, axes);
  if (!read_pecks(words, plan) || !moves_.has_feed(words)) return false;
  turning_.begin(along_z ? Meaning::face_pecks : Meaning::groove_pecks,
                 std::make_unique<PeckPasses>(plan), axes, {.feed = moves_.feed()});
  return true;
}

bool MultipleCycles::set_thread(const Words& words) {
  if (words.has('P') && !set_thread_code(words['P'])) return false;
  double least = 0;
  if (words.has('Q')) {
    if (!in_increments(words['Q'], least)) return false;
    if (least < 0) return state_.alarms.raise(Code::illegal_minus, words['Q'].text);
    state_.parameters.thread_least_cut = least;
  }
  if (!words.has('R')) return true;
  if (words['R'].value < 0) return state_.alarms.raise(Code::illegal_minus, words['R'].text);
  return state_.values.length(words['R'], state_.parameters.thread_finish);
}

// Two digits each: finishing passes, run-out in tenths of the lead, angle of the tip.
bool MultipleCycles::set_thread_code(const Word& word) {
  std::int64_t code = 0;
  if (!state_.values.integer(word, 0, kMostThreadCode, code)) return false;
  if (!set_tip_angle(code % 100, word.text)) return false;
  state_.parameters.thread_finish_passes = std::max(1, static_cast<int>(code / 10000));
  state_.parameters.chamfer_thread = static_cast<double>(code / 100 % 100);
  return true;
}

bool MultipleCycles::set_tip_angle(std::int64_t degrees, const vm::Span& at) {
  if (std::find(kTipAngles.begin(), kTipAngles.end(), degrees) == kTipAngles.end())
    return state_.alarms.raise(Code::thread_tip_angle, at, std::to_string(degrees) + " degrees");
  state_.parameters.thread_angle = static_cast<int>(degrees);
  return true;
}

bool MultipleCycles::thread(const Words& words) {
  motion::PlaneAxes axes;
  TurningCycle::Manner manner;
  ThreadPlan plan;
  if (!turning_.plane(axes) || !read_end(words, axes, plan.end)) return false;
  plan.home = TurningCycle::place(state_.coordinates, axes);
  if (!read_depths(words, plan) || !moves_.read_lead(words, manner.lead)) return false;
  const Parameters& parameters = state_.parameters;
  plan.least_depth = parameters.thread_least_cut;
  plan.finish = parameters.thread_finish;
  plan.finish_passes = parameters.thread_finish_passes;
  plan.tip_angle_deg = parameters.thread_angle;
  plan.taper *= state_.side_of_x();
  plan.run_out = run_out_of(parameters, manner.lead);
  if (plan.least_depth > plan.height) return state_.alarms.raise(Code::thread_least_cut);
  manner.height = plan.height;
  turning_.begin(Meaning::compound_thread, std::make_unique<ThreadPasses>(plan), axes,
                 std::move(manner));
  return true;
}

// K is a radius to the least increment of X, a diameter: a half one of its own.
bool MultipleCycles::read_height(const Words& words, double& mm) {
  if (!words.has('K')) return true;
  Word diameter = words['K'];
  diameter.value *= 2;
  if (!state_.values.length(diameter, mm)) return false;
  mm /= 2;
  return true;
}

// Two blocks: P, Q and the taper R. One block: K, D, I and the angle A.
bool MultipleCycles::read_depths(const Words& words, ThreadPlan& plan) {
  const bool one_block = words.has('K') || words.has('D');
  const char height = one_block ? 'K' : 'P';
  const char first = one_block ? 'D' : 'Q';
  const char taper = one_block ? 'I' : 'R';
  const auto read = [&](char letter, double& mm) {
    if (!words.has(letter)) return true;
    return one_block ? state_.values.length(words[letter], mm) : in_increments(words[letter], mm);
  };
  const bool good = one_block ? read_height(words, plan.height) : read(height, plan.height);
  if (!good || !read(first, plan.first_depth)) return false;
  if (plan.height <= 0 || plan.first_depth <= 0)
    return state_.alarms.raise(
        Code::thread_height,
        std::string(1, plan.height <= 0 ? height : first) + " is missing, 0 or negative");
  if (words.has(taper) && !state_.values.length(words[taper], plan.taper)) return false;
  return !one_block || tell_infeed(words);
}

// Of the one-block form: A is the angle of the tip, P the manner of the infeed.
bool MultipleCycles::tell_infeed(const Words& words) {
  std::int64_t angle = state_.parameters.thread_angle;
  if (words.has('A') &&
      (!state_.values.integer(words['A'], 0, 180, angle) || !set_tip_angle(angle, words['A'].text)))
    return false;
  std::int64_t manner = 1;
  if (words.has('P') && !state_.values.integer(words['P'], 1, 4, manner)) return false;
  if (manner > 1)
    state_.assume(Assumed::thread_infeed,
                  "G76 cuts with one flank and equal chips (P1) also where P2 to P4 are written");
  return true;
}

}  // namespace kerf::control
