#pragma once

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

/// A run of the loaded program as it would be if nobody touched the panel: without stops of the
/// operator, overrides at 100 %. M00 is passed.
class Forecast {
 public:
  explicit Forecast(RunStart start);

  /// On to a time of the run, or to where it ends.
  void go_to(double time_s);
  [[nodiscard]] double time_s() const { return core_.time_s(); }
  [[nodiscard]] LiveCore& core() { return core_; }

 private:
  LiveCore core_;
};

}  // namespace kerf::machine
