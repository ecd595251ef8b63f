#include "control/gcode/cycles/single_cycles.hpp"

#include <utility>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/cycles/thread_cut.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using geometry::Vec2;
using Kind = TurningMove::Kind;

// Moves 2 and 3 are a contour of their own: move 1 leads to it, move 4 away from it.
std::vector<TurningMove> turning_moves(Vec2 home, Vec2 end, double taper) {
  return {{.kind = Kind::rapid, .to = {home.u, base::tidy(end.v + taper)}, .has_nose = true},
          {.kind = Kind::feed, .to = end, .has_nose = true},
          {.kind = Kind::feed, .to = {end.u, home.v}, .has_nose = true},
          {.kind = Kind::rapid, .to = home}};
}

std::vector<TurningMove> facing_moves(Vec2 home, Vec2 end, double taper) {
  return {{.kind = Kind::rapid, .to = {base::tidy(end.u + taper), home.v}, .has_nose = true},
          {.kind = Kind::feed, .to = end, .has_nose = true},
          {.kind = Kind::feed, .to = {home.u, end.v}, .has_nose = true},
          {.kind = Kind::rapid, .to = home}};
}

}  // namespace

bool SingleCycles::begin(const Words& words, bool& moved) {
  motion::PlaneAxes axes;
  if (!turning_.plane(axes)) return false;
  if (state_.before[Group::motion] != state_.modal[Group::motion]) has_run_ = false;
  if (!is_one(state_.before[Group::motion])) forget();
  if (!words.has_any(targets_.letters() | Words::mask('R'))) {
    if (words.g_begin() != words.g_end())
      state_.assume(Assumed::lone_cycle,
                    "a turning cycle without X and Z is chosen and waits for them (G90 of system "
                    "A is one: X and Z are always absolute there)");
    return true;
  }
  moved = true;
  return read(words, axes) && make(words, axes);
}

bool SingleCycles::read(const Words& words, const motion::PlaneAxes& axes) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = targets_.word_of(words, axis);
    if (word != nullptr && !axes.contains(axis))
      return state_.alarms.raise(base::Code::cycle_other_axis, word->text);
  }
  return read_word(words, axes.second, data_.x) && read_word(words, axes.first, data_.z) &&
         (!words.has('R') || state_.values.length(words['R'], data_.taper));
}

bool SingleCycles::read_word(const Words& words, Axis axis, std::optional<Word>& word) {
  const gcode::Word* const written = targets_.word_of(words, axis);
  if (written == nullptr) return true;
  Word read;
  if (!targets_.value(*written, axis, read.value)) return false;
  read.is_way = state_.modal.incremental() || targets_.is_way(*written, axis);
  word = read;
  return true;
}

// The point that X and Z name, on the programmed path in the machine's coordinates.
Vec2 SingleCycles::corner(const motion::PlaneAxes& axes) const {
  base::ProgramPoint point = state_.coordinates.program();
  const auto put = [&](Axis axis, const std::optional<Word>& word) {
    if (word) point[axis] = word->is_way ? base::tidy(point[axis] + word->value) : word->value;
  };
  put(axes.second, data_.x);
  put(axes.first, data_.z);
  return axes.project(state_.coordinates.path_of(point));
}

bool SingleCycles::make(const Words& words, const motion::PlaneAxes& axes) {
  const Vec2 home = TurningCycle::place(state_.coordinates, axes);
  const Vec2 end = corner(axes);
  TurningCycle::Manner manner;
  std::vector<TurningMove> moves;
  const bool faces = state_.modal[Group::motion] == Meaning::facing_cycle;
  const double taper = faces ? data_.taper : data_.taper * state_.side_of_x();
  if (state_.modal[Group::motion] == Meaning::thread_cycle) {
    if (!moves_.read_lead(words, manner.lead)) return false;
    moves = thread_cut(home, {home.u, base::tidy(end.v + taper)}, end,
                       run_out_of(state_.parameters, manner.lead));
  } else {
    if (!moves_.has_feed(words)) return false;
    if (!state_.path.interrupt_compensation()) return false;
    moves = faces ? facing_moves(home, end, taper) : turning_moves(home, end, taper);
  }
  manner.feed = moves_.feed();
  manner.repeats = std::exchange(has_run_, true);
  turning_.begin(state_.modal[Group::motion], std::make_unique<ListedMoves>(moves), axes,
                 std::move(manner));
  return true;
}

}  // namespace kerf::control
