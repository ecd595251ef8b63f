#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic_code.hpp"
#include "base/point.hpp"
#include "motion/motion.hpp"
#include "motion/skip_signal.hpp"

namespace kerf::control {

/// Why a machine cannot make a move: the alarm, and what it says.
struct Refusal {
  base::Code code{};
  std::string sentence;
};

/// What the control needs of the world around it. Implemented by the machine.
class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// Whether the axes have come to rest behind all motions handed out so far, as they must before a
  /// clock or an input is read and before M01 looks at its switch. False: they are on their way
  /// there; who waits for them halts, and asks again when it is run again.
  [[nodiscard]] virtual bool axes_have_arrived() = 0;
  /// Seconds of machine time since power-on, all motions handed out so far finished.
  [[nodiscard]] virtual double seconds() = 0;
  /// Calendar date and time as yyyymmdd and hhmmss.
  [[nodiscard]] virtual double date() = 0;
  [[nodiscard]] virtual double time_of_day() = 0;

  /// What becomes of a move that is asked for.
  enum class Intent : std::uint8_t {
    make,  ///< when nothing speaks against it, it is made: the next one begins where it ends
    ask    ///< it may be made in part, or not at all
  };
  /// Why the machine cannot make this move from `from`, where the last one made ended; or nothing.
  /// Asked before every move that leaves the control, if AxisSetup::linked.
  [[nodiscard]] virtual std::optional<Refusal> refusal(const base::TipPoint& from,
                                                       const motion::Motion& move,
                                                       Intent intent) = 0;

  /// Where on a probing move the skip signal comes on, as SkipSignal has it. Asked when every
  /// motion before it has been handed out.
  [[nodiscard]] virtual std::optional<double> contact(const motion::SkipMove& move) = 0;

  /// Input bits #1000 to #1035 as they stand now; bit words by index 0 to 3.
  [[nodiscard]] virtual std::uint32_t inputs(std::size_t word) = 0;

  /// Output of the program: DPRNT, BPRNT, PRINT.
  virtual void print(std::string_view text) = 0;
  /// Whether input() can be answered now; otherwise as when axes_have_arrived() says no.
  [[nodiscard]] virtual bool input_can_be_read() = 0;
  /// The next line that the operator enters for INPUT, without its end; nothing: there is none any
  /// more.
  [[nodiscard]] virtual std::optional<std::string> input() = 0;
};

}  // namespace kerf::control
