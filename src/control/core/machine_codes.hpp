#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/spindle_name.hpp"

namespace kerf::control {

/// A spindle as its machine's file describes it. Codes that are 0 do not exist.
struct SpindleSettings {
  motion::SpindleName name = motion::SpindleName::main;
  double most_rpm = 0;                 ///< 0: no limit; of the main one Parameters have it
  double acceleration_rpm_s = 0;       ///< 0: a change of its speed takes no time
  std::uint32_t clockwise = 0;         ///< M code
  std::uint32_t counterclockwise = 0;  ///< likewise
  std::uint32_t stop = 0;
  std::uint32_t orient = 0;
  std::vector<std::uint32_t> numbers{};  ///< P beside S and the M codes of the main spindle
};

/// What the builder of a machine has given M codes for, besides spindles. Most are passed on.
enum class BuilderFunction : std::uint8_t {
  c_axis_on,    ///< the spindle is an axis from now on
  c_axis_off,   ///< it is a spindle again
  clamp,        ///< of axes, chuck, tailstock: nothing to tell
  wait,         ///< for the other turret
  bar_feeder,   ///< pushes the bar through the spindle
  catcher,      ///< of parts
  sub_spindle,  ///< its slide, its chuck
};

/// Of the machine file's tables [[spindle]], [m_codes] and [g_codes].
struct MachineCodes {
  /// A G code of the builder that is another name of the control's own. In tenths: G12.1 is 121.
  struct OtherName {
    std::uint16_t code = 0;
    std::uint16_t meant = 0;
  };
  struct Code {
    std::uint32_t number = 0;
    BuilderFunction function{};
  };
  std::vector<SpindleSettings> spindles;
  std::vector<Code> codes;
  std::vector<OtherName> other_names;

  /// The control's own G code of one that is written, in tenths.
  [[nodiscard]] std::uint16_t meant_by(std::uint16_t g_code) const {
    const auto at = std::find_if(other_names.begin(), other_names.end(),
                                 [=](const OtherName& name) { return name.code == g_code; });
    return at == other_names.end() ? g_code : at->meant;
  }
  [[nodiscard]] const SpindleSettings* find(motion::SpindleName name) const {
    const auto at = std::find_if(spindles.begin(), spindles.end(),
                                 [=](const SpindleSettings& s) { return s.name == name; });
    return at == spindles.end() ? nullptr : &*at;
  }
  /// Null: no spindle has this M code.
  [[nodiscard]] const SpindleSettings* spindle_with(std::int64_t code) const {
    const auto at = std::find_if(spindles.begin(), spindles.end(), [=](const SpindleSettings& s) {
      return code != 0 && (code == s.clockwise || code == s.counterclockwise || code == s.stop ||
                           code == s.orient);
    });
    return at == spindles.end() ? nullptr : &*at;
  }
  [[nodiscard]] std::optional<BuilderFunction> function_of(std::int64_t number) const {
    const auto at = std::find_if(codes.begin(), codes.end(),
                                 [=](const Code& code) { return code.number == number; });
    return at == codes.end() ? std::nullopt : std::optional(at->function);
  }
  /// Programs switch the C axis, and it is none until they do.
  [[nodiscard]] bool switch_c_axis() const {
    return std::any_of(codes.begin(), codes.end(), [](const Code& code) {
      return code.function == BuilderFunction::c_axis_on;
    });
  }
};

}  // namespace kerf::control
