#pragma once

#include <optional>
#include <string>
#include <vector>

#include "features/plan/edit_plan.hpp"
#include "features/rewrite/old_ways.hpp"

namespace kerf::features {

/// What edits are applied to, and what has come of them so far.
struct EditScene {
  const Recording& recording;
  const Tree& tree;
  OldWays& ways;
  bool allows_collision = false;
  bool allows_rest = false;  ///< material that the tool could reach may stay
  EditPlan plan{};
  std::size_t edit = 0;  ///< that is being applied

  [[nodiscard]] tl::unexpected<EditFault> refuse(base::Code code, std::string sentence,
                                                 std::string hint = "") const;
  /// With the number of the edit in it.
  [[nodiscard]] tl::unexpected<EditFault> refuse(EditFault fault) const;
  /// What rows shall be, as far as is known by now; they are no longer part of the plan. All of the
  /// stretches that they meet must lie within them: else nothing.
  [[nodiscard]] std::optional<std::vector<PlannedRow>> take_rows(Span rows);
  void add(Stretch stretch) { plan.rows.push_back(std::move(stretch)); }

  // By id or key.
  [[nodiscard]] std::optional<std::size_t> feature_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> hole_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> pattern_of(const std::string& target) const;
};

using Done = Editing<void>;

}  // namespace kerf::features
