#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "base/result.hpp"
#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"

namespace kerf::kinematics {

/// The kind of a machine file's word: "cartesian", "cartesian-step" (two motors for X and Y: the
/// same kinematics), "x-theta-z", "head-ac", "arm".
[[nodiscard]] std::optional<Kind> kind_named(std::string_view word);

/// The linkage that `settings` describe. Failure `input`: the joints are not those of the kind
/// (docs/kinematics.md), a range is empty, a length is not a number that the linkage can have.
[[nodiscard]] base::Outcome<std::unique_ptr<const Kinematics>> make_kinematics(
    const Settings& settings);

}  // namespace kerf::kinematics
