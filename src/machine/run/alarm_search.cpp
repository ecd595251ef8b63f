#include "machine/run/alarm_search.hpp"

#include <algorithm>

namespace kerf::machine {

bool AlarmSearch::add(const base::Diagnostic& alarm) {
  const auto same = [&](const base::Diagnostic& known) {
    return known.place.file == alarm.place.file && known.place.line == alarm.place.line &&
           known.number == alarm.number;
  };
  const bool is_full = findings_.size() >= kMostFindings || passed_ >= kMostPassed;
  is_cut_short_ |= is_full;
  if (is_full) return false;
  ++passed_;
  if (std::none_of(findings_.begin(), findings_.end(), same)) findings_.push_back(alarm);
  return true;
}

}  // namespace kerf::machine
