#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace kerf::test {

/// A number as a program writes it: three decimals, always with a point.
inline std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", value + 0.0);
  return text;
}

/// `value` to the thousandth, as decimal() writes it.
inline double thousandths(double value) { return std::round(value * 1000) / 1000; }

/// "X1.000Y2.000"
inline std::string xy(double x, double y) { return "X" + decimal(x) + "Y" + decimal(y); }

}  // namespace kerf::test
