#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lang/teach/sequence.hpp"

namespace kerf::teach {

/// A program as it is taught, record by record. What could not be read back is refused when it is
/// taught: the answer says why, and nothing has changed. Value type.
class Recorder {
 public:
  /// Begins with TEACH 1, UNITS, PERIOD and, for a head, RADII.
  Recorder(const Period& period, const std::optional<Radii>& radii);

  /// Adds a record: the reason why it is refused, or nothing. TEACH_COUNT never; TEACH_RANGE and
  /// TEACH_NUMBER for a value, TEACH_ORDER for a place, ARC_COLLINEAR and ARC_COINCIDENT for
  /// points.
  [[nodiscard]] std::optional<Mistake> teach(const Record& record);
  /// Takes the last record back; false when only the head is left.
  bool take_back();

  /// Where the beam is behind what has been taught; nothing before the first point.
  [[nodiscard]] const std::optional<Pose>& at() const { return sequence_.at(); }
  [[nodiscard]] bool ended() const { return sequence_.ended(); }
  [[nodiscard]] std::span<const Record> records() const { return records_; }
  /// The file: a line for each record.
  [[nodiscard]] std::string text() const;

 private:
  void admit_all();

  std::vector<Record> records_;
  std::size_t head_ = 0;
  Sequence sequence_;
};

}  // namespace kerf::teach
