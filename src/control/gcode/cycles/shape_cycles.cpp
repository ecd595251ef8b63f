#include "control/gcode/cycles/shape_cycles.hpp"

#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/cycles/pattern_passes.hpp"
#include "control/gcode/cycles/rough_passes.hpp"
#include "control/gcode/cycles/shape_check.hpp"

namespace kerf::control {
namespace {

using base::Code;
using geometry::Vec2;

constexpr std::int64_t kMostSequence = 99999999;
constexpr std::int64_t kMostPasses = 9999;

Travel travel_of(Meaning cycle) {
  return cycle == Meaning::rough_facing ? Travel::along_x : Travel::along_z;
}

Code code_of(ShapeFault::Reason reason) {
  switch (reason) {
    case ShapeFault::Reason::not_monotone_first_axis: return Code::shape_first_axis;
    case ShapeFault::Reason::not_monotone_second_axis: return Code::shape_second_axis;
    case ShapeFault::Reason::outside_start: return Code::shape_beyond_start;
  }
  return Code::shape_first_axis;
}

}  // namespace

bool ShapeCycles::execute(Meaning cycle, const Words& words, bool& moved) {
  motion::PlaneAxes axes;
  if (!turning_.plane(axes) || !stands_alone(words)) return false;
  if (state_.modal[Group::modal_call] != Meaning::modal_call_off)
    return state_.alarms.raise(Code::cycle_state, "a modal macro call is in force");
  const bool sets = !words.has('P') && !words.has('Q') && cycle != Meaning::finishing;
  if (sets && cycle == Meaning::pattern_repeat) return set_pattern(words);
  if (sets) return set_depth(words, cycle == Meaning::rough_turning ? 'U' : 'W');
  moved = true;
  return ask(cycle, words);
}

bool ShapeCycles::stands_alone(const Words& words) {
  if (words.has_any(Words::mask("XZYC")))
    return state_.alarms.raise(Code::cycle_words, "X and Z belong to the shape");
  const Words::G* first = nullptr;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row == nullptr || g->group() != Group::one_shot) continue;
    if (first != nullptr) return state_.alarms.raise(Code::cycle_words, g->word->text);
    first = g;
  }
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (is_call(m->function())) return state_.alarms.raise(Code::cycle_words, m->word->text);
  }
  return true;
}

bool ShapeCycles::read_length(const Words& words, char letter, double& mm) {
  return !words.has(letter) || state_.values.length(words[letter], mm);
}

// The first block of two: G71 U R, G72 W R.
bool ShapeCycles::set_depth(const Words& words, char depth) {
  Parameters& parameters = state_.parameters;
  if (!read_length(words, depth, parameters.rough_depth) ||
      !read_length(words, 'R', parameters.rough_retreat))
    return false;
  if (parameters.rough_retreat < 0)
    return state_.alarms.raise(Code::illegal_minus, words['R'].text);
  return parameters.rough_depth > 0 || state_.alarms.raise(Code::cycle_depth);
}

// G73 U W R.
bool ShapeCycles::set_pattern(const Words& words) {
  Parameters& parameters = state_.parameters;
  if (!read_length(words, 'U', parameters.pattern_x) ||
      !read_length(words, 'W', parameters.pattern_z))
    return false;
  if (!words.has('R')) return true;
  const double count = words['R'].value;
  if (count < 1 || count > kMostPasses || count != std::floor(count))
    return state_.alarms.raise(Code::pattern_count, words['R'].text);
  parameters.pattern_count = static_cast<int>(count);
  return true;
}

bool ShapeCycles::ask(Meaning cycle, const Words& words) {
  Request request{.cycle = cycle};
  if (!words.has('P') || !words.has('Q'))
    return state_.alarms.raise(Code::cycle_p_q, words.has('P') ? "Q is missing" : "P is missing");
  if (!read_number(words, 'P', request.first) || !read_number(words, 'Q', request.last) ||
      !read_one_block(words) || !read_allowance(words))
    return false;
  if (!request.finishes() && !moves_.has_feed(words)) return false;
  request.first_text = words['P'].text;
  request.last_text = words['Q'].text;
  request_ = request;
  if (request.finishes()) {
    state_.count_cycle(cycle);
    state_.cycles.add(1);
  }
  return true;
}

bool ShapeCycles::read_number(const Words& words, char letter, std::uint32_t& number) {
  std::int64_t value = 0;
  if (!state_.values.integer(words[letter], 0, kMostSequence, value)) return false;
  if (value == 0)
    return state_.alarms.raise(Code::shape_not_found, words[letter].text, "no block has N0");
  number = static_cast<std::uint32_t>(value);
  return true;
}

// U of the allowance is a diameter.
bool ShapeCycles::read_allowance(const Words& words) {
  allowance_ = {};
  if (!read_length(words, 'W', allowance_.u) || !read_length(words, 'U', allowance_.v))
    return false;
  const auto x = state_.axes.find('X');
  if (x)
    allowance_.v = base::tidy(state_.side_of_x() * allowance_.v / state_.axes[*x].count_per_mm());
  return true;
}

// The form with D in the same block: the depth of cut, of G73 the number of passes.
bool ShapeCycles::read_one_block(const Words& words) {
  Parameters& parameters = state_.parameters;
  const bool pattern = words.has_g(Meaning::pattern_repeat);
  if (pattern) {
    if (!read_length(words, 'I', parameters.pattern_x) ||
        !read_length(words, 'K', parameters.pattern_z))
      return false;
  } else if (words.has_any(Words::mask("IK"))) {
    state_.assume(Assumed::ignored_allowance,
                  "I and K of a roughing cycle, allowances of a pass in between, are ignored");
  }
  if (!words.has('D')) return true;
  if (!pattern) {
    return state_.values.length(words['D'], parameters.rough_depth) &&
           (parameters.rough_depth > 0 || state_.alarms.raise(Code::cycle_depth, words['D'].text));
  }
  std::int64_t count = 0;
  if (!state_.values.integer(words['D'], 0, kMostPasses, count)) return false;
  if (count < 1) return state_.alarms.raise(Code::pattern_count, words['D'].text);
  parameters.pattern_count = static_cast<int>(count);
  return true;
}

bool ShapeCycles::begin(const TurningShape& shape, std::vector<base::BlockId> blocks) {
  motion::PlaneAxes axes;
  if (!turning_.plane(axes)) return false;
  const Meaning cycle = request_->cycle;
  TurningCycle::Manner manner{.feed = moves_.feed(), .blocks = std::move(blocks)};
  if (cycle != Meaning::pattern_repeat) return rough(shape, std::move(manner), axes);
  const Parameters& parameters = state_.parameters;
  turning_.begin(
      cycle,
      std::make_unique<PatternPasses>(
          shape, PatternSettings{{parameters.pattern_z, parameters.pattern_x * state_.side_of_x()},
                                 static_cast<std::uint32_t>(parameters.pattern_count),
                                 allowance_}),
      axes, std::move(manner));
  return true;
}

// The program stands at the end of the shape.
bool ShapeCycles::refuse(Code code, const base::BlockId& block) {
  return state_.alarms.raise_at(code, base::place_of(block), block, "");
}

// A shape that goes back is an alarm where it is checked; otherwise it is turned as far as it goes.
bool ShapeCycles::rough(const TurningShape& shape, TurningCycle::Manner manner,
                        const motion::PlaneAxes& axes) {
  const Parameters& parameters = state_.parameters;
  const Travel travel = travel_of(request_->cycle);
  const auto fault = check_shape(shape, travel, {parameters.monotone_z, parameters.monotone_x});
  if (fault && parameters.check_shapes)
    return refuse(code_of(fault->reason), manner.blocks[fault->block]);
  if (parameters.check_shapes && shape.both_axes && travel == Travel::along_x)
    return refuse(Code::shape_pockets, state_.path.block());
  if (fault)
    state_.assume(Assumed::shape_not_monotone,
                  "a shape that goes back is cut all the same: parameter MRC is 0");
  if (may_have_pockets(shape, travel) && allowance_.u != 0)
    state_.assume(Assumed::pocket_allowance,
                  "the allowance W of a shape with X and Z in its first block (type II) is lost at "
                  "one wall of each pocket");
  turning_.begin(request_->cycle,
                 rough_passes(shape, {.travel = travel,
                                      .depth_mm = parameters.rough_depth,
                                      .retreat_mm = parameters.rough_retreat,
                                      .allowance = allowance_}),
                 axes, std::move(manner));
  return true;
}

}  // namespace kerf::control
