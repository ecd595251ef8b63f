#pragma once

#include <optional>
#include <string>

#include "features/plan/edit_plan.hpp"

namespace kerf::features {

/// What edits are applied to, and what has come of them so far.
struct EditScene {
  const Recording& recording;
  const Tree& tree;
  bool allows_collision = false;
  EditPlan plan{};
  std::size_t edit = 0;  ///< that is being applied

  [[nodiscard]] tl::unexpected<EditFault> refuse(base::Code code, std::string sentence,
                                                 std::string hint = "") const;
  /// With the number of the edit in it.
  [[nodiscard]] tl::unexpected<EditFault> refuse(EditFault fault) const;
  void add(Stretch stretch) { plan.rows.push_back(std::move(stretch)); }

  // By id or key.
  [[nodiscard]] std::optional<std::size_t> feature_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> hole_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> pattern_of(const std::string& target) const;
};

using Done = Editing<void>;

}  // namespace kerf::features
