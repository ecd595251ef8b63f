#pragma once

#include <optional>
#include <string>

#include "kinematics/kinematics.hpp"
#include "machine/run/internal/joint_linkage.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"

namespace kerf::machine {

/// Follows the joints of a linkage along the moves of a run before they are made, and says which
/// one they cannot follow.
///
/// A move is divided until the samples of each stretch agree (motion::Stretch), so whatever the
/// joints do between two of them is as smooth as it looks. Where they jump or turn round at once no
/// stretch is short enough.
///
///   OUT_OF_REACH  no joints hold a sample, the end of the move first of all
///   SINGULAR      a stretch of kShortest_mm is not smooth. At its begin or end a move may come to
///                 a place where the rates of the joints are not determined, if the joints come to
///                 stand there as they must: its last kAtEnd_mm moves none by more than kJump
///   LIMIT         a joint is beyond its range at a sample, or may be so between two: as long as
///                 h²/4 max|q"|, twice what a smooth function can rise above both ends, reaches
///                 beyond it, the stretch is divided on
///
/// Of the places looked at, the one that is farthest beyond a limit is told of.
class Reach {
 public:
  // Shortest stretches, mm, or degrees where only rotary axes move.
  static constexpr double kShortest_mm = 1e-10;
  static constexpr double kAtEnd_mm = 1e-7;
  static constexpr double kJump = 0.01;  ///< mm, degrees

  /// Both must outlive this. `joints`: where they stand when the tip is at the start.
  Reach(const kinematics::Kinematics& kinematics, const motion::AxisSetup& axes,
        const base::JointPoint& joints)
      : kinematics_(kinematics), linkage_(kinematics, joints), curves_(axes), joints_(joints) {}

  /// Why the joints cannot follow a move of the tip from `from`, where they stand at joints().
  /// Nothing when they can: then `end` is where they stand behind it.
  [[nodiscard]] std::optional<kinematics::Fault> objection(const base::TipPoint& from,
                                                           const motion::Motion& move,
                                                           base::JointPoint& end);

  /// Where the last move that could be followed comes near to a singular position, at the first of
  /// the places looked at: what Kinematics::caution() says there.
  struct Caution {
    std::string sentence;
    base::TipPoint tip;
  };
  [[nodiscard]] const std::optional<Caution>& caution() const { return caution_; }

  [[nodiscard]] const base::JointPoint& joints() const { return joints_; }
  void set_joints(const base::JointPoint& joints) { joints_ = joints; }

 private:
  class Follower;

  const kinematics::Kinematics& kinematics_;
  JointLinkage linkage_;
  motion::MoveCurves curves_;
  base::JointPoint joints_;
  std::optional<Caution> caution_;
};

}  // namespace kerf::machine
