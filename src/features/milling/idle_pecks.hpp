#pragma once

#include <utility>
#include <vector>

#include "features/milling/stroke.hpp"
#include "features/path/blank.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Plunges that have met nothing, while nobody knows whether they are the first pecks of a hole
/// below them: a cycle that begins above the work pecks there, too.
class IdlePecks {
 public:
  /// The recording must outlive this.
  explicit IdlePecks(const Recording& recording) : recording_(recording) {}

  void add(const PlungeRun& plunge) { pecks_.push_back(plunge); }
  /// At the place of the last one, with nothing but rapids between.
  [[nodiscard]] bool go_on_with(const PlungeRun& plunge) const;
  /// All of them, in their order; there are none then.
  [[nodiscard]] std::vector<PlungeRun> take() { return std::exchange(pecks_, {}); }

 private:
  const Recording& recording_;
  std::vector<PlungeRun> pecks_;
};

/// Of feeds that cut nothing and go down to `lowest`: what nobody has described may be higher.
[[nodiscard]] inline Unrecognised::Why why_air(const Blank& blank, double lowest) {
  const bool is_above = lowest >= blank.top - kSameZ_mm;
  return is_above && !blank.is_known ? Unrecognised::Why::above_assumed_stock
                                     : Unrecognised::Why::air;
}

}  // namespace kerf::features
