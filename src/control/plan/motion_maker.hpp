#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// Motions from the first to the last, some at a time.
class MotionStream : public base::Interface {
 public:
  /// Appends those that come next, at least one; false: there are none any more.
  [[nodiscard]] virtual bool next(std::vector<motion::Motion>& motions) = 0;
};

/// What a machine shall make, planned beforehand. Every stream of it is the same.
class MotionMaker : public base::Interface {
 public:
  [[nodiscard]] virtual std::unique_ptr<MotionStream> stream() const = 0;
  /// As a program is called: the name of a drawing.
  [[nodiscard]] virtual std::string name() const = 0;
};

}  // namespace kerf::control
