#include "control/core/control.hpp"

#include <algorithm>

namespace kerf::control {

const std::vector<CycleCount>& Control::cycles() const {
  static const std::vector<CycleCount> kNone;
  return kNone;
}

void Control::warn(base::Code code, const base::Place& place, const std::string& detail,
                   const std::string& program) {
  if (warnings_.size() >= kMostWarnings) return;
  const std::string_view number = base::text_of(code).number;
  const bool said =
      std::any_of(warnings_.begin(), warnings_.end(), [&](const base::Diagnostic& warning) {
        return warning.number == number && warning.place.file == place.file &&
               warning.place.line == place.line && warning.place.column == place.column;
      });
  if (said) return;
  warnings_.push_back(base::make_error(code, place, detail));
  warnings_.back().severity = base::Severity::warning;
  warnings_.back().program = program;
}

}  // namespace kerf::control
