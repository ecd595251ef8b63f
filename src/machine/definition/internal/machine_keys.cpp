#include "machine/definition/internal/machine_keys.hpp"

#include <algorithm>
#include <array>

#include "base/decimal.hpp"
#include "machine/definition/internal/program_axes.hpp"

namespace kerf::machine {
namespace {

using drive::ByteOrder;
using drive::PwmTimer;
using drive::TimerSplit;
using kinematics::Kind;
using planner::Sampling;
using std::string_view;

using Machine = MachineDefinition;
using Axis = DrivenAxis;
using Spindle = control::SpindleSettings;

constexpr double kMostNanoseconds = 4294967295;  // 2^32 - 1
constexpr double kMostRpm = 99999;
constexpr double kMostCode = 99999999;  // of M
constexpr double kFastestCrystal_hz = 500'000'000;
constexpr int kTimerWithoutOutput = 4;  // of the chip's five timers

// Each list of words beside what its places mean.
constexpr std::array<string_view, 4> kModes = {"planned", "tail", "equal", "literal"};
constexpr std::array kSamplings = {Sampling::planned, Sampling::tail, Sampling::equal,
                                   Sampling::literal};
constexpr std::array<string_view, 2> kSplits = {"exact", "integer"};
constexpr std::array kTimerSplits = {TimerSplit::exact, TimerSplit::integer};
constexpr std::array<string_view, 4> kDividers = {"2", "4", "8", "16"};
constexpr std::array<std::int64_t, 4> kDividends = {2, 4, 8, 16};
constexpr std::array<string_view, 2> kOutputs = {"active_after_match", "active_before_match"};
constexpr std::array kPwmOutputs = {PwmTimer::Output::active_after_match,
                                    PwmTimer::Output::active_before_match};

constexpr std::array<string_view, 2> kRapids = {"straight", "joint"};
constexpr std::array kRapidWays = {RapidWay::straight, RapidWay::joint};

constexpr std::array<string_view, 2> kBeamWords = {"M3", "M4"};
constexpr std::array kBeams = {LaserSettings::Beam::constant, LaserSettings::Beam::dynamic};

constexpr std::array<string_view, 2> kByteOrders = {"big", "little"};
constexpr std::array kPatternOrders = {ByteOrder::big, ByteOrder::little};
constexpr std::array<string_view, 2> kElbows = {"plus", "minus"};
constexpr std::array<string_view, 2> kHeadings = {"tangent", "program"};
constexpr std::array kWheelHeadings = {PatternSettings::Heading::tangent,
                                       PatternSettings::Heading::program};
constexpr std::array<string_view, 2> kLinks = {"two", "four"};
constexpr std::array kPatternLinks = {PatternSettings::Link::two, PatternSettings::Link::four};

std::int64_t whole(double value) { return static_cast<std::int64_t>(value); }
std::uint32_t code(double value) { return static_cast<std::uint32_t>(value); }

template <typename T, std::size_t N>
T item(const std::array<T, N>& items, double place) {
  return items[static_cast<std::size_t>(place)];
}

bool is_x_theta_z(Kind kind) { return kind == Kind::x_theta_z; }
bool is_head(Kind kind) { return kind == Kind::head_ac; }
bool is_arm(Kind kind) { return kind == Kind::arm; }
bool takes_patterns(Kind kind) { return kind == Kind::arm || kind == Kind::cartesian; }

constexpr AxisKey kAxisKeys[] = {
    {"axis", "velocity", positive(), [](Axis& a, double v) { a.velocity_per_min = v; }},
    {"axis", "acceleration", positive(), [](Axis& a, double v) { a.acceleration = v; }},
    {"axis", "jerk", not_negative(),
     [](Axis& a, double v) { a.jerk = v > 0 ? v : Axis::kNoLimit; }},
    {"axis", "steps_per_unit", any_but_zero(), [](Axis& a, double v) { a.steps_per_unit = v; }},
    {"axis", "max_rate", not_negative(), [](Axis& a, double v) { a.most_rate_hz = v; }},
};

constexpr PointKey kPointKeys[] = {
    {"kinematics", "primary_point", &kinematics::TablePoints::primary},
    {"kinematics", "secondary_point", &kinematics::TablePoints::secondary},
};

constexpr SpindleKey kSpindleKeys[] = {
    {"spindle", "max_rpm", whole_numbers(0, kMostRpm),
     [](Spindle& s, double v) { s.most_rpm = v; }},
    {"spindle", "acceleration", not_negative(),
     [](Spindle& s, double v) { s.acceleration_rpm_s = v; }},
    {"spindle", "clockwise", whole_numbers(0, kMostCode),
     [](Spindle& s, double v) { s.clockwise = code(v); }},
    {"spindle", "counterclockwise", whole_numbers(0, kMostCode),
     [](Spindle& s, double v) { s.counterclockwise = code(v); }},
    {"spindle", "stop", whole_numbers(0, kMostCode),
     [](Spindle& s, double v) { s.stop = code(v); }},
    {"spindle", "orient", whole_numbers(0, kMostCode),
     [](Spindle& s, double v) { s.orient = code(v); }},
};

constexpr MachineKey kMachineKeys[] = {
    {"tip", "velocity", positive(), [](Machine& m, double v) { m.tip.velocity_per_min = v; },
     has_own_tip},
    {"tip", "acceleration", positive(), [](Machine& m, double v) { m.tip.acceleration = v; },
     has_own_tip},
    {"tip", "rapid", one_of(kRapids),
     [](Machine& m, double v) { m.tip.rapid = item(kRapidWays, v); }, is_x_theta_z},
    {"tip", "z_first", flag(), [](Machine& m, double v) { m.tip.z_first = v != 0; }},

    {"kinematics", "x1", any_number(),
     [](Machine& m, double v) { m.kinematics.x_theta_z.x1_mm = v; }, is_x_theta_z},
    {"kinematics", "theta0_deg", any_number(),
     [](Machine& m, double v) { m.kinematics.x_theta_z.theta0_deg = v; }, is_x_theta_z},
    {"kinematics", "z0", any_number(),
     [](Machine& m, double v) { m.kinematics.x_theta_z.z0_mm = v; }, is_x_theta_z},
    {"kinematics", "r_a", any_number(), [](Machine& m, double v) { m.kinematics.head.r_a_mm = v; },
     is_head},
    {"kinematics", "r_c", any_number(), [](Machine& m, double v) { m.kinematics.head.r_c_mm = v; },
     is_head},
    {"kinematics", "upper_arm", positive(),
     [](Machine& m, double v) { m.kinematics.arm.upper_arm_mm = v; }, is_arm},
    {"kinematics", "forearm", positive(),
     [](Machine& m, double v) { m.kinematics.arm.forearm_mm = v; }, is_arm},
    {"kinematics", "forearm_absolute", flag(),
     [](Machine& m, double v) { m.kinematics.arm.forearm_absolute = v != 0; }, is_arm},
    {"kinematics", "elbow", one_of(kElbows),
     [](Machine& m, double v) { m.kinematics.arm.elbow_minus = v != 0; }, is_arm},

    {"interpolator", "period_ms", numbers(0.01, 1000),
     [](Machine& m, double v) { m.interpolator.period_s = v / 1000; }},
    {"interpolator", "mode", one_of(kModes),
     [](Machine& m, double v) { m.interpolator.sampling = item(kSamplings, v); }},
    {"interpolator", "step_mm", numbers(0.0001, 1000),
     [](Machine& m, double v) {
       m.interpolator.step_mm = v;
       if (m.interpolator.sampling != Sampling::literal)
         m.interpolator.sampling = Sampling::equal_steps;
     }},
    {"interpolator", "tolerance", numbers(0, 1000),
     [](Machine& m, double v) { m.interpolator.tolerance_mm = v; }},
    {"interpolator", "chord_tolerance", numbers(0.000001, 1000),
     [](Machine& m, double v) { m.interpolator.chord_tolerance_mm = v; }},

    {"drive", "pulse_width_ns", whole_numbers(1, kMostNanoseconds),
     [](Machine& m, double v) { m.drive.timing.pulse_width_ns = whole(v); }},
    {"drive", "pulse_gap_ns", whole_numbers(1, kMostNanoseconds),
     [](Machine& m, double v) { m.drive.timing.pulse_gap_ns = whole(v); }},
    {"drive", "direction_setup_ns", whole_numbers(0, kMostNanoseconds),
     [](Machine& m, double v) { m.drive.timing.direction_setup_ns = whole(v); }},
    {"drive", "band_steps", numbers(0, 0.25),
     [](Machine& m, double v) { m.drive.timing.band_steps = v; }},

    {"drive", "crystal_hz", whole_numbers(1, kFastestCrystal_hz),
     [](Machine& m, double v) { m.drive.arm.clock = drive::TickClock(whole(v)); }},
    {"drive", "split", one_of(kSplits),
     [](Machine& m, double v) { m.drive.arm.split = item(kTimerSplits, v); }},
    {"drive", "half_period_ticks", whole_numbers(1, drive::kLongestHalfPeriod),
     [](Machine& m, double v) { m.drive.arm.half_period_ticks = whole(v); }},
    {"drive", "fast_rate", positive(), [](Machine& m, double v) { m.drive.arm.fast.rate_hz = v; }},
    {"drive", "fast_start", positive(),
     [](Machine& m, double v) { m.drive.arm.fast.start_hz = v; }},
    {"drive", "fast_acceleration", positive(),
     [](Machine& m, double v) { m.drive.arm.fast.acceleration_hz_s = v; }},

    {"pattern", "byte_order", one_of(kByteOrders),
     [](Machine& m, double v) { m.pattern.byte_order = item(kPatternOrders, v); }, takes_patterns},
    {"pattern", "tolerance", numbers(0.0001, 1000),
     [](Machine& m, double v) { m.pattern.tolerance_mm = v; }, takes_patterns},
    {"pattern", "travel_z", any_number(), [](Machine& m, double v) { m.pattern.travel_z_mm = v; },
     takes_patterns},
    {"pattern", "tangent_jump_deg", numbers(0, 90),
     [](Machine& m, double v) { m.pattern.tangent_jump_deg = v; }, takes_patterns},
    {"pattern", "heading", one_of(kHeadings),
     [](Machine& m, double v) { m.pattern.heading = item(kWheelHeadings, v); }, takes_patterns},
    {"pattern", "link", one_of(kLinks),
     [](Machine& m, double v) { m.pattern.link = item(kPatternLinks, v); }, takes_patterns},
    {"pattern", "cut_speed", not_negative(),
     [](Machine& m, double v) { m.pattern.cut_speed_mm_min = v; }, takes_patterns},

    {"drive", "max_power_w", not_negative(),
     [](Machine& m, double v) { m.drive.laser.max_power_w = v; }},
    {"drive", "pwm_frequency_hz", positive(),
     [](Machine& m, double v) { m.drive.laser.pwm_frequency_hz = v; }},
    {"drive", "spot_mm", positive(), [](Machine& m, double v) { m.drive.laser.spot_mm = v; }},
    {"beam", "kerf", positive(), [](Machine& m, double v) { m.drive.laser.kerf_mm = v; }},
    {"beam", "focus_mm", any_number(), [](Machine& m, double v) { m.drive.laser.focus_mm = v; }},
    {"drive", "burn_j_mm", not_negative(),
     [](Machine& m, double v) { m.drive.laser.burn_j_mm = v; }},
    {"drive", "s_of_full_power", positive(),
     [](Machine& m, double v) { m.drive.laser.s_of_full_power = v; }},
    {"drive", "post_beam", one_of(kBeamWords),
     [](Machine& m, double v) { m.drive.laser.post_beam = item(kBeams, v); }},
    {"drive", "pclk_hz", positive(),
     [](Machine& m, double v) { m.drive.laser.timer.clock_hz = v; }},
    {"drive", "timer", whole_numbers(0, kTimerWithoutOutput),
     [](Machine& m, double v) { m.drive.laser.timer_number = static_cast<int>(v); }},
    {"drive", "prescaler", whole_numbers(0, 255),
     [](Machine& m, double v) { m.drive.laser.timer.prescaler = whole(v); }},
    {"drive", "divider", one_of(kDividers),
     [](Machine& m, double v) { m.drive.laser.timer.divider = item(kDividends, v); }},
    {"drive", "output", one_of(kOutputs),
     [](Machine& m, double v) { m.drive.laser.timer.output = item(kPwmOutputs, v); }},
    {"drive", "hidden_tick", flag(),
     [](Machine& m, double v) {
       m.drive.laser.timer.counting =
           v != 0 ? PwmTimer::Counting::hidden_tick : PwmTimer::Counting::plain;
     }},
};

}  // namespace

const MachineKey* find_machine_key(string_view table, string_view name) {
  for (const MachineKey& key : kMachineKeys) {
    if (key.table == table && key.name == name) return &key;
  }
  return nullptr;
}

const PointKey* find_point_key(string_view table, string_view name) {
  for (const PointKey& key : kPointKeys) {
    if (key.table == table && key.name == name) return &key;
  }
  return nullptr;
}

std::optional<std::array<double, 3>> point_of(string_view text) {
  std::array<double, 3> point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const std::size_t end = std::min(text.find(','), text.size());
    const bool is_last = i + 1 == point.size();
    if (is_last != (end == text.size())) return std::nullopt;
    const auto value = base::read_number(text.substr(0, end));
    if (!value) return std::nullopt;
    point[i] = *value;
    if (!is_last) text.remove_prefix(end + 1);
  }
  return point;
}

const AxisKey* find_axis_key(string_view name) {
  for (const AxisKey& key : kAxisKeys) {
    if (key.name == name) return &key;
  }
  return nullptr;
}

const SpindleKey* find_spindle_key(string_view name) {
  for (const SpindleKey& key : kSpindleKeys) {
    if (key.name == name) return &key;
  }
  return nullptr;
}

void limit_main_spindle(MachineDefinition& machine) {
  const Spindle* const main = machine.parameters.machine_codes.find(motion::SpindleName::main);
  if (main != nullptr && main->most_rpm > 0)
    machine.parameters.spindle_max_rpm = static_cast<int>(main->most_rpm);
}

std::string drive_objection(const DriveSettings& drive) {
  const drive::FastRamp& fast = drive.arm.fast;
  if (fast.start_hz <= fast.rate_hz) return {};
  return "fast_start, " + base::number_text(fast.start_hz) + ", is above fast_rate, " +
         base::number_text(fast.rate_hz);
}

std::string timer_objection(const DriveSettings& drive) {
  if (drive.laser.timer_number != kTimerWithoutOutput) return {};
  return "timer 4 has no output: the laser is at 0, 1, 2 or 3";
}

bool is_gas(string_view text) {
  constexpr std::size_t kLongest = 60;
  const auto shows = [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != 0x7F; };
  return !text.empty() && text.size() <= kLongest && std::all_of(text.begin(), text.end(), shows);
}

std::string type_in_words(const MachineDefinition& machine) {
  return "a machine of the type " + machine.linkage;
}

}  // namespace kerf::machine
