#pragma once

#include <string>
#include <vector>

#include "features/plan/edit_plan.hpp"

namespace kerf::features {

/// Under which name a layer is found behind an edit.
struct RenamedLayer {
  std::string was{};
  std::size_t was_layer = 0;
  std::string is{};
  std::size_t is_layer = 0;
};

/// How an edited program compares with what was asked (features-contract §9).
struct VerifiedEdit {
  bool recognised = false;
  bool others_unchanged = false;
  double contour_error_mm = 0;
  double difference_mm3 = 0;   ///< by how much more is removed than before
  double outside_mm3 = 0;      ///< of it, outside of what was asked
  double corner_rest_mm2 = 0;  ///< that no disc of the tool reaches in sharp corners
  std::vector<std::string> new_findings{};
  std::string findings_skipped{};  ///< why findings were not compared; empty: they were
  double time_before_s = 0;
  double time_after_s = 0;
};

/// Compares what an edited program machines with what was asked: layers that were edited come back
/// with their contours, all others, and all holes, as they were. Times and findings are others'.
[[nodiscard]] VerifiedEdit compare_edited(const Recording& recording, const Tree& before,
                                          const Tree& after, const EditPlan& plan);

/// Whether an edited program is fed as the plan has it, one cut behind the other, and pecks so
/// deep. `edited`: what it has moved, `after`: what was recognised in that.
[[nodiscard]] bool has_wanted_feeds(const Recording& recording, const EditPlan& plan,
                                    const Recording& edited, const Tree& after);

/// Under which names the edited layers are found again.
[[nodiscard]] std::vector<RenamedLayer> renamed_layers(const Tree& after, const EditPlan& plan);

}  // namespace kerf::features
