#pragma once

#include <optional>

#include "lang/teach/mistake.hpp"
#include "lang/teach/record.hpp"

namespace kerf::teach {

/// Whether records make sense one behind the other. Value type: a copy goes on from where it is.
///
///   TEACH 1 is first and stands nowhere else; a cut needs a POINT and a FEED before it; the three
///   points of an ARC or CIRCLE carry one, or lie on a line with the second between the others
///   (ARC alone: geometry::NoArc::straight); nothing follows END.
class Sequence {
 public:
  /// Takes a record over, or says why it cannot stand here: TEACH_VERSION, TEACH_ORDER,
  /// ARC_COLLINEAR, ARC_COINCIDENT. After a mistake the records behind are judged as if it had been
  /// right, as far as that can be known.
  [[nodiscard]] std::optional<Mistake> admit(const Record& record);
  /// A line that is no record stood here, which has been told of: what it might have been is not
  /// missed.
  void pass_over();
  /// Text that follows END.
  [[nodiscard]] static Mistake behind_end();
  /// No more records come. A mistake when END is missing.
  [[nodiscard]] std::optional<Mistake> close() const;

  [[nodiscard]] bool ended() const { return ended_; }
  /// Where the beam is; nothing before the first point and where a mistake hides it.
  [[nodiscard]] const std::optional<Pose>& at() const { return at_; }

 private:
  [[nodiscard]] std::optional<Mistake> objection(const Record& record) const;
  [[nodiscard]] std::optional<Mistake> objection_to_cut(const Record& record) const;
  void follow(const Record& record);

  std::optional<Pose> at_;
  bool begun_ = false;
  bool pointed_ = false;
  bool fed_ = false;
  bool ended_ = false;
};

/// Why the way from `from` through the points of an arc cannot be made.
[[nodiscard]] std::optional<Mistake> objection_to_arc(const Pose& from, const Arc& arc);
[[nodiscard]] std::optional<Mistake> objection_to_circle(const Pose& from, const Circle& circle);

}  // namespace kerf::teach
