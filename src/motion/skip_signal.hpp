#pragma once

#include <cstdint>
#include <optional>

#include "base/block_id.hpp"
#include "base/interface.hpp"
#include "base/point.hpp"

namespace kerf::motion {

/// What a move waits for that a signal may end early.
enum class Feeler : std::uint8_t {
  probe,        ///< a touch probe that meets the work (G31)
  tool_setter,  ///< a tool that meets the sensor of the machine (G37 of a lathe)
};

/// A straight move that a skip signal may end early.
struct SkipMove {
  base::TipPoint from;
  base::TipPoint to;
  base::AxisVector length;  ///< of the tool, on the whole way: machine_of() the tip
  base::BlockId block;      ///< that commands it
  Feeler feeler = Feeler::probe;
};

/// Where skip signals come from. Whoever asks has handed out every motion before the move, so that
/// one who watches the motions knows what the world is like when it begins.
class SkipSignal : public base::Interface {
 public:
  /// The share of the move's length, in [0, 1], at which the signal comes on; nullopt: it does not.
  /// The move is made, as far as that; each is asked about once.
  [[nodiscard]] virtual std::optional<double> comes_on(const SkipMove& move) = 0;
};

}  // namespace kerf::motion
