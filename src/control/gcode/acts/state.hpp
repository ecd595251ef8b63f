#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "control/core/alarms.hpp"
#include "control/core/assumptions.hpp"
#include "control/core/control.hpp"
#include "control/core/cycle_counts.hpp"
#include "control/core/memory.hpp"
#include "control/core/parameters.hpp"
#include "control/core/surroundings.hpp"
#include "control/gcode/codes/modal_state.hpp"
#include "control/gcode/frames/coordinates.hpp"
#include "control/gcode/path/toolpath.hpp"
#include "control/gcode/words/word_values.hpp"
#include "control/gcode/words/words.hpp"

namespace kerf::control {

/// Spindle, tool and the other words that stay until they are changed.
struct ModalWords {
  struct SpindleWords {
    double speed = 0;
    motion::Spindle::Turning turning = motion::Spindle::Turning::stopped;
  };
  double feed = 0;             ///< mm/min, mm/rev or 1/min by the active feed mode; 0: none
  double feed_programmed = 0;  ///< as written, in the program's unit (#4109)
  double speed = 0;            ///< S of the chosen spindle
  double max_rpm = 0;          ///< G92 S
  std::int64_t css_axis = 0;   ///< P of G96: number of an axis; 0: that of the parameter
  motion::Spindle::Turning turning = motion::Spindle::Turning::stopped;  ///< of the chosen spindle
  motion::SpindleName spindle = motion::SpindleName::main;               ///< the chosen one
  std::array<SpindleWords, motion::kSpindles> others{};  ///< of those that are not chosen
  double last_speed = 0;                                 ///< S, of whichever spindle
  std::int64_t tool = 0;                                 ///< last T (#4120)
  std::int64_t station = 0;          ///< of a lathe: the tool that the turret has brought
  std::int64_t turning_offset = 0;   ///< of a lathe: the number of the offset that T has brought
  std::int64_t geometry_offset = 0;  ///< likewise, of its geometry
  std::int64_t length_offset = 0;    ///< H (#4111)
  std::int64_t radius_offset = 0;    ///< D (#4107)
  std::int64_t last_m = 0;           ///< #4113
  double second_auxiliary = 0;       ///< B (#4102)
  double e = 0;                      ///< #4108
  std::int64_t extended_work = 1;    ///< P of the last G54.1 (#4130)

  /// `speed` and `turning` are those of this spindle from now on.
  void choose(motion::SpindleName name) {
    others[index(spindle)] = {speed, turning};
    spindle = name;
    speed = others[index(name)].speed;
    turning = others[index(name)].turning;
  }
  [[nodiscard]] motion::Spindle::Turning turning_of(motion::SpindleName name) const {
    return name == spindle ? turning : others[index(name)].turning;
  }
};

/// The state that the parts of the control share. Each part changes what its header says.
struct State {
  State(const CodeTable& codes_in, Parameters& parameters_in, const motion::AxisSetup& axes_in,
        Memory& memory_in, Alarms& alarms_in, Assumptions& assumptions_in,
        Surroundings& surroundings_in, motion::MotionSink& sink)
      : codes(codes_in),
        parameters(parameters_in),
        axes(axes_in),
        memory(memory_in),
        alarms(alarms_in),
        assumptions(assumptions_in),
        surroundings(surroundings_in),
        values(alarms_in),
        modal(codes_in, parameters_in),
        before(codes_in, parameters_in),
        coordinates(axes_in, memory_in),
        strokes(axes_in, parameters_in.stroke_check, &coordinates.length()),
        outlet(alarms_in, surroundings_in,
               axes_in.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, &strokes,
               sink),
        path(alarms_in, outlet, {parameters_in.start_up, parameters_in.corner_arc}, axes_in) {
    refresh_format();
    c_axis_is_on = !parameters_in.machine_codes.switch_c_axis();
  }

  const CodeTable& codes;
  Parameters& parameters;
  const motion::AxisSetup& axes;
  Memory& memory;
  Alarms& alarms;
  Assumptions& assumptions;
  Surroundings& surroundings;
  WordValues values;
  ModalState modal;
  ModalState before;  ///< as the previous block left it (#4001…)
  ModalWords words;
  Meaning one_shot = Meaning::none;  ///< of the executing block
  Coordinates coordinates;
  StrokeLimits strokes;
  base::AxisSet commanded = 0;  ///< that have been told to move since power-on
  Outlet outlet;                ///< of `path`
  Toolpath path;
  std::uint32_t line = 0;                          ///< of the executing block
  base::MachinePoint skip_position;                ///< #5061
  std::uint32_t outputs[4] = {};                   ///< #1100 to #1135
  std::optional<base::ProgramPoint> intermediate;  ///< of the last G28 or G30
  base::AxisSet intermediate_axes = 0;
  double wanted_length = 0;  ///< offset that G43 or G44 asks for; in force from the next move on
  base::AxisVector wanted_offset;  ///< that T of a lathe asks for, mm; likewise, axis by axis
  base::Axis length_axis{};        ///< its axis
  CycleCounts cycles;
  base::AxisSet radius_words = 0;  ///< G10.9: axes with a diameter whose words are radii
  bool c_axis_is_on = true;        ///< what switches it is the builder's
  bool rigid_tapping = false;      ///< M29
  bool moved_since_m29 = false;
  bool parameter_entry = false;  ///< between G10 L50 and G11
  bool reads_shape = false;      ///< of a cycle, whose blocks command nothing
  double block_control = 0;      ///< #3003
  double feed_control = 0;       ///< #3004, bits of FeedControl

  /// What turns now, of the chosen spindle.
  [[nodiscard]] motion::Spindle spindle() const;
  /// The most that the chosen spindle can; 0: no limit.
  [[nodiscard]] double most_rpm() const;
  /// S of the chosen spindle is a surface speed; a driven tool has none.
  [[nodiscard]] bool has_surface_speed() const {
    return modal[Group::speed] == Meaning::surface_speed &&
           words.spindle != motion::SpindleName::live;
  }
  /// A spindle turns.
  [[nodiscard]] bool turns() const {
    for (std::size_t i = 0; i < motion::kSpindles; ++i) {
      if (motion::Spindle::turns(words.turning_of(static_cast<motion::SpindleName>(i))))
        return true;
    }
    return false;
  }
  /// Where a tool is driven, that spindle is the chosen one.
  void choose_driven_tool() {
    if (motion::Spindle::turns(words.turning_of(motion::SpindleName::live)))
      words.choose(motion::SpindleName::live);
  }
  /// The work turns: the surface speed is that at the diameter, from the zero of the work system.
  void measure_radius(motion::Spindle& spindle) const {
    spindle.most_rpm = most_rpm();
    const auto number = words.css_axis != 0 ? static_cast<std::size_t>(words.css_axis)
                                            : static_cast<std::size_t>(parameters.css_axis);
    if (number <= axes.count())
      spindle.radius_axis = base::Axis{static_cast<std::uint8_t>(number - 1)};
    if (spindle.radius_axis) spindle.centre = coordinates.origin()[*spindle.radius_axis];
  }
  /// The plane of arcs, corners and compensation; nothing: the machine lacks one of its axes.
  [[nodiscard]] std::optional<motion::PlaneAxes> plane() const;
  /// The program goes on in the plane of a surface, whose rotary axis has `mm_per_degree`
  /// (Coordinates::unroll()). Precondition: no move is held.
  void enter_surface(const motion::Surface& surface, double mm_per_degree);
  void leave_surface();
  /// The reset button: modes as at power-on. The tool stays where it is, offsets and the shift of
  /// G92 stay.
  void reset();
  /// The modes as whoever shows them gets them.
  [[nodiscard]] ModalView modal_view() const;
  /// The tool length of an axis is in force from the next move on.
  void set_length(base::Axis axis, double mm) {
    coordinates.set_length(axis, mm);
    if (axis != length_axis) return;
    const std::int64_t number = codes.habits().tool_brings_offset ? words.turning_offset
                                : mm != 0                         ? words.length_offset
                                                                  : 0;
    path.set_length({.mm = mm, .offset = static_cast<std::uint32_t>(number), .axis = axis});
  }
  /// A rapid as parameter LRP wants it.
  [[nodiscard]] motion::Rapid rapid(const base::TipPoint& to) const {
    return {to, parameters.linear_rapid};
  }
  /// After a change of the unit or of the parameters.
  void refresh_format() { values.set_format({modal.inch(), parameters.calculator_point}); }
  /// -1 where X is mirrored, for the second turret.
  [[nodiscard]] double side_of_x() const {
    const auto x = axes.find('X');
    return x && base::contains(coordinates.transform().mirrored(), *x) ? -1 : 1;
  }
  /// A cycle begins: passes count for it from now on.
  void count_cycle(Meaning cycle) {
    cycles.begin(name_of(codes.with(cycle).number), path.block().line);
  }
  /// Says once per `key` that something was accepted without effect or read in a surprising way.
  void assume(std::uint32_t key, const char* what) {
    if (assumptions.is_new(key)) assumptions.add(line, what);
  }
};

}  // namespace kerf::control
