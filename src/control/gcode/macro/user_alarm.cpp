#include "control/gcode/macro/user_alarm.hpp"

#include <cmath>

#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

constexpr int kMostBehind3000 = 200;
constexpr int kMostItself = 4095;
constexpr std::size_t kDigits = 4;

std::string digits_of(int number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < kDigits ? kDigits - digits.size() : 0, '0') + digits;
}

}  // namespace

int most_user_alarm(bool number_itself) { return number_itself ? kMostItself : kMostBehind3000; }

std::optional<base::Diagnostic> user_alarm(double number, bool number_itself,
                                           const base::Place& place, const std::string& text) {
  const double rounded = std::round(vm::zero_if_null(number));
  if (vm::is_null(number) || rounded < 0 || rounded > most_user_alarm(number_itself))
    return std::nullopt;
  base::Diagnostic alarm = base::make_error(base::Code::user_alarm, place);
  alarm.number = "MC" + digits_of(static_cast<int>(rounded) + (number_itself ? 0 : 3000));
  alarm.message = text.empty() ? "macro alarm without a text" : text;
  return alarm;
}

}  // namespace kerf::control
