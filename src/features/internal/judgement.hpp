#pragma once

#include "features/recognition.hpp"

namespace kerf::features {

/// Compares the methods, and says how sure each feature is, and why.
void judge(const Recording& recording, const Blank& blank, Method method, Tree& tree);

}  // namespace kerf::features
