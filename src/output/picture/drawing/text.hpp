#pragma once

#include <string>
#include <string_view>

namespace kerf::output::plot {

enum class Weight : bool { regular, bold };

/// Width of a line in DejaVu Sans of the given size; characters beyond ASCII count as wide ones.
[[nodiscard]] double text_width(std::string_view text, double size,
                                Weight weight = Weight::regular);

/// `text` as valid UTF-8 without control characters; what is neither becomes '?'.
[[nodiscard]] std::string printable(std::string_view text);

/// `text` cut short with an ellipsis so that it is no wider than `width`. `text` is valid UTF-8.
[[nodiscard]] std::string fitted(std::string text, double size, Weight weight, double width);

/// `value` > 0 rounded to two digits, if that is not finer than 12 decimals.
[[nodiscard]] std::string significant(double value);

/// A count with its digits in groups of three.
[[nodiscard]] std::string grouped(std::size_t count);

}  // namespace kerf::output::plot
