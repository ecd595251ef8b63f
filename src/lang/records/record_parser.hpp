#pragma once

#include <tl/expected.hpp>

#include "lang/records/json_line.hpp"
#include "lang/records/members.hpp"
#include "lang/records/mistake.hpp"
#include "lang/records/record.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::records {

/// Most that a coordinate may be, mm or degrees.
inline constexpr double kMostCoordinate = 1e6;
/// Most that a feed, a speed or a time may be.
inline constexpr double kMostNumber = 1e9;
/// Least feed.
inline constexpr double kLeastFeed = 1e-6;

/// Makes a motion of a line of --motion (docs/motions.md), as far as the line alone shows it:
/// whether an arc is one depends on where it begins. All that --motion always writes must be there.
class RecordParser {
 public:
  /// They must outlive this.
  explicit RecordParser(const motion::AxisSetup& axes) : axes_(axes) {}

  /// The record views into `line`. Mistakes: MJ0001, MJ0002, MJ0003. Precondition: there is more
  /// than blanks.
  [[nodiscard]] tl::expected<Record, Mistake> parse(std::string_view line);

 private:
  using Action = motion::Motion::Action;

  void head(Members& members, Record& record);
  Action action(std::string_view kind, Members& members, Record& record);
  Action line_or_surface(Members& members);
  Action arc_or_surface(Members& members, Record& record);
  Action arc(Members& members, Record& record);
  Action space_arc(Members& members);
  Action spindle(Members& members);
  Action thread(Members& members);
  Action surface_move(Members& members, std::size_t object, bool is_arc);
  void state(Members& members, Record& record);
  void read_radii(Members& members, Record& record);
  void read_length(Members& members, Record& record);
  [[nodiscard]] base::TipPoint point(const char* name, Members& members);
  [[nodiscard]] base::Axis axis(std::string_view letter, const JsonValue& at, Members& members);
  [[nodiscard]] bool is_arm_of(motion::Plane plane, Members& members);

  const motion::AxisSetup& axes_;
  JsonLine line_;
};

}  // namespace kerf::records
