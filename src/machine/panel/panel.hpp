#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace kerf::machine {

/// What the mode switch of a panel can be turned to.
enum class Mode : std::uint8_t {
  edit,       ///< the program is written; nothing runs
  mdi,        ///< blocks are entered and executed
  automatic,  ///< "auto": the program runs
  jog,        ///< axes are moved by hand
  reference,  ///< "ref": axes go to their reference points
  teach       ///< axes are moved by hand, and points are captured
};

/// The switches that are on or off.
enum class Switch : std::uint8_t {
  single_block,   ///< the axes come to rest behind each block, until cycle start
  optional_stop,  ///< M01 stops
  dry_run,        ///< moves go at the jog speed instead of their feed
  machine_lock    ///< the control's position counts, the axes do not move
};
inline constexpr std::size_t kSwitches = 4;

/// What the three override dials say, percent.
struct OverrideDials {
  int feed = 100;     ///< 0 to 200
  int rapid = 100;    ///< 0 to 100
  int spindle = 100;  ///< 50 to 120; a laser's: of its power, up to full power
  friend bool operator==(const OverrideDials&, const OverrideDials&) = default;
};

/// All that stays as the operator has set it until he sets it otherwise.
struct PanelSettings {
  Mode mode = Mode::automatic;
  std::array<bool, kSwitches> switches{};
  std::uint32_t skip_levels = 0;  ///< bit n: blocks with /n are skipped, n = 1 to 9
  OverrideDials dials;
  [[nodiscard]] bool operator[](Switch which) const {
    return switches[static_cast<std::size_t>(which)];
  }
  friend bool operator==(const PanelSettings&, const PanelSettings&) = default;
};

/// What a panel says of its machine.
enum class Status : std::uint8_t {
  idle,     ///< nothing has run since power-on or reset
  running,  ///< axes move, or a program executes
  held,     ///< feed hold, anywhere on the way
  stopped,  ///< between two blocks: M00, M01, a message, single block
  step,     ///< between two blocks: a step is over, or a breakpoint was met
  end,      ///< M02, M30, END
  alarm
};

// Words of files and protocols: "auto", "single-block", "running".
[[nodiscard]] std::string_view name_of(Mode mode);
[[nodiscard]] std::string_view name_of(Switch which);
[[nodiscard]] std::string_view name_of(Status status);
[[nodiscard]] std::vector<std::string_view> mode_names();
[[nodiscard]] std::vector<std::string_view> switch_names();
[[nodiscard]] std::optional<Mode> mode_named(std::string_view name);
[[nodiscard]] std::optional<Switch> switch_named(std::string_view name);

}  // namespace kerf::machine
