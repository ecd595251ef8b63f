#include "output/programs/basic_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "geometry/arc.hpp"
#include "motion/feed.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

using geometry::Vec2;

constexpr double kDegree = 180 / std::numbers::pi;

/// To what the rounding of a way back from degrees does not reach.
double rounded(double value) {
  constexpr double kDigits = 1e7;
  return base::tidy(std::round(value * kDigits) / kDigits);
}

double coordinate(const motion::AxisSetup& axes, const base::TipPoint& at, char letter) {
  const auto axis = axes.find(letter);
  return axis ? at[*axis] : 0;
}

Vec2 flat(const motion::AxisSetup& axes, const base::TipPoint& at) {
  return {coordinate(axes, at, 'X'), coordinate(axes, at, 'Y')};
}

}  // namespace

BasicProgram::BasicProgram(const motion::AxisSetup& axes, const std::string& title,
                           base::OutputFile& file)
    : axes_(axes), file_(file), at_(axes.start) {
  comment(title);
  comment("mm from the work origin, speeds in mm/s, power in percent");
}

void BasicProgram::comment(const std::string& text) {
  file_.write("REM " + printable(text) + "\n");
}

void BasicProgram::statement(const char* name, const std::vector<double>& values) {
  std::string text = name;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "(" : ",") + base::number_text(rounded(values[i]));
  file_.write(text + (values.empty() ? "\n" : ")\n"));
}

void BasicProgram::lose(const std::string& what) {
  if (std::find(lost_.begin(), lost_.end(), what) != lost_.end()) return;
  lost_.push_back(what);
  comment("LOST: " + what);
}

void BasicProgram::go(const char* name, const base::TipPoint& to) {
  std::vector<double> values{coordinate(axes_, to, 'X'), coordinate(axes_, to, 'Y')};
  if (coordinate(axes_, to, 'Z') != coordinate(axes_, at_, 'Z'))
    values.push_back(coordinate(axes_, to, 'Z'));
  statement(name, values);
}

void BasicProgram::cut_at(const motion::Feed& feed) {
  if (feed.value != written_feed_) {
    written_feed_ = feed.value;
    statement("SPEED", {feed.value / motion::kSecondsPerMinute});
  }
  const double percent = power_.beam_percent();
  if (percent == written_percent_) return;
  written_percent_ = percent;
  statement("POWER", {percent});
}

void BasicProgram::act(const motion::Rapid& rapid) { go("MOVE", rapid.to); }

void BasicProgram::act(const motion::Line& line) {
  cut_at(line.feed);
  go("LINE", line.to);
}

void BasicProgram::act(const motion::Arc& arc) {
  cut_at(arc.feed);
  const Vec2 from = flat(axes_, at_);
  const Vec2 to = flat(axes_, arc.to);
  const Vec2 centre{arc.center[0], arc.center[1]};
  const bool is_clockwise = arc.direction == motion::Direction::clockwise;
  const double radius = geometry::length(from - centre);
  const double sweep = geometry::sweep_rad(from, to, centre, is_clockwise);
  if (sweep < std::numbers::pi - 1e-3) {
    statement("ARC", {to.u, to.v, radius, is_clockwise ? -1.0 : 1.0});
    return;
  }
  const double begin = math::atan2(from.v - centre.v, from.u - centre.u) * kDegree;
  const double turn = (is_clockwise ? -sweep : sweep) * kDegree;
  statement("ARC", {centre.u, centre.v, radius, begin, begin + turn});
}

void BasicProgram::act(const motion::Dwell& dwell) {
  if (power_.beam_percent() > 0) {
    if (power_.beam_percent() != written_percent_)
      statement("POWER", {written_percent_ = power_.beam_percent()});
    statement("BURN", {dwell.seconds});
  } else {
    statement("WAIT", {dwell.seconds});
  }
}

void BasicProgram::act(const motion::Coolant& coolant) {
  statement("AIR", {coolant.state == motion::Coolant::State::off ? 0.0 : 1.0});
}

void BasicProgram::act(const motion::Power& power) {
  constexpr double kMilliseconds = 1000;
  if (power.beam_percent() > 0 && power.frequency_hz != power_hz_) {
    power_hz_ = power.frequency_hz;
    const double period_ms = power_hz_ > 0 ? kMilliseconds / power_hz_ : 0;
    const double on_ms = period_ms * power.percent / 100;
    statement("PULSE", {on_ms, period_ms - on_ms});
    written_percent_ = power_hz_ > 0 ? power.percent : -1;
  }
  power_ = power;
  if (power.follows_speed) lose("power that follows the speed: it is constant");
}

void BasicProgram::act(const motion::Message& message) {
  comment(std::string(message.text.view()));
}

void BasicProgram::act(const motion::End& /*end*/) {
  has_ended_ = true;
  statement("END", {});
}

void BasicProgram::take(const motion::Motion& motion) {
  std::visit([this](const auto& action) { act(action); }, motion.action);
  if (const base::TipPoint* const to = motion::target_of(motion)) at_ = *to;
}

void BasicProgram::finish() {
  if (!has_ended_) act(motion::End{});
}

}  // namespace kerf::output
