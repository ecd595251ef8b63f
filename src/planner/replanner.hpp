#pragma once

#include <cstdint>
#include <optional>

#include "motion/mark.hpp"
#include "planner/look_ahead.hpp"
#include "planner/overrides.hpp"
#include "planner/path_state.hpp"
#include "planner/profile.hpp"
#include "planner/way_ahead.hpp"

namespace kerf::planner {

/// Makes the plan anew from where the tool is.
///
/// A new plan begins with the speed of the old one and without acceleration. The old one is always
/// possible; the new one may not be, because it asks for braking that can no longer be done. So it
/// is tried beside the old one, which stays until adopt().
class Replanner {
 public:
  /// `ahead` must outlive this.
  explicit Replanner(WayAhead& ahead) : ahead_(ahead), trial_(ahead.limits.jerk_limited()) {}

  /// A stretch in which the acceleration goes to 0, and how the tool moves behind it.
  struct Leveling {
    Profile profile;
    Section section;
    PathState behind;
  };
  /// Nothing where limits, or a stop, come too soon for it. Precondition: the jerk is limited, and
  /// `from` has an acceleration.
  [[nodiscard]] std::optional<Leveling> level_off(const PathState& from) const;

  // Plans, from a place without acceleration. False: there is none.

  /// To rest on the shortest way, to one part in a thousand.
  [[nodiscard]] bool to_rest(const PathState& from);
  /// To rest at the first end of a block where that can be done. False also where that block ends
  /// in a standstill anyway.
  [[nodiscard]] bool to_block_end(const PathState& from);
  /// Under other overrides, which the cells have then.
  [[nodiscard]] bool to_overrides(const PathState& from, const Overrides& wanted);
  /// Puts the plan that was made last in the place of the old one.
  void adopt() { std::swap(ahead_.plan, trial_); }

  /// Gives cells from number `first` on other overrides.
  void override_cells(std::uint64_t first, const Overrides& wanted);
  /// At rest, `offset` behind the begin of the first cell: nothing of the block of `mark` follows.
  [[nodiscard]] bool is_over(const motion::Mark& mark, double offset) const;

 private:
  [[nodiscard]] bool can_stop_within(const PathState& from, double way);
  [[nodiscard]] std::optional<double> way_to(const PathMark& mark, const PathState& from) const;
  [[nodiscard]] bool ends_in_standstill(const PathMark& mark) const;
  [[nodiscard]] bool is_limit_kept(const Cell& cell, const PathState& from, double speed) const;
  [[nodiscard]] std::optional<double> cells_under(Section& stretch, const PathState& from) const;
  void put_back_overrides(std::uint64_t first);
  void set_overrides_of(std::uint64_t cell, const Overrides& overrides);

  WayAhead& ahead_;
  LookAhead trial_;
};

}  // namespace kerf::planner
