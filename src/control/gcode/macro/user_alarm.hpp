#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.hpp"

namespace kerf::control {

/// The alarm of #3000 = n (text): MC 3000 + n with n up to 200, or n itself up to 4095
/// (`number_itself`, parameter MCA). Nothing: n is none of these.
[[nodiscard]] std::optional<base::Diagnostic> user_alarm(double number, bool number_itself,
                                                         const base::Place& place,
                                                         const std::string& text);

/// Largest n.
[[nodiscard]] int most_user_alarm(bool number_itself);

}  // namespace kerf::control
