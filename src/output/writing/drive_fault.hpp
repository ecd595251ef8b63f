#pragma once

#include <functional>

#include "base/diagnostic.hpp"
#include "motion/mark.hpp"

namespace kerf::output {

/// Gets what a drive or a format cannot do, without a place, and the motion under way: the run ends
/// there.
using DriveFault = std::function<void(const base::Diagnostic&, const motion::Mark&)>;

}  // namespace kerf::output
