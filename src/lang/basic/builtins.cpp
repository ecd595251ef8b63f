#include "lang/basic/builtins.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/math.hpp"

namespace kerf::basic {
namespace {

using vm::Builtin;
using vm::BuiltinContext;
using vm::Fault;

double fail(BuiltinContext& context, Fault fault) {
  context.fault = fault;
  return 0;
}

double call_asin(const double* a, BuiltinContext& c) {
  return std::fabs(a[0]) <= 1 ? math::asin(a[0]) : fail(c, Fault::domain);
}
double call_acos(const double* a, BuiltinContext& c) {
  return std::fabs(a[0]) <= 1 ? math::acos(a[0]) : fail(c, Fault::domain);
}
double call_sqr(const double* a, BuiltinContext& c) {
  return a[0] >= 0 ? std::sqrt(a[0]) : fail(c, Fault::domain);
}
double call_log(const double* a, BuiltinContext& c) {
  return a[0] > 0 ? math::log(a[0]) : fail(c, Fault::domain);
}

double call_sgn(const double* a, BuiltinContext&) { return (a[0] > 0) - (a[0] < 0); }

double call_mod(const double* a, BuiltinContext& c) {
  if (a[1] == 0) return fail(c, Fault::zero_divide);
  return a[0] - a[1] * std::floor(a[0] / a[1]);
}

double call_remainder(const double* a, BuiltinContext& c) {
  return a[1] == 0 ? fail(c, Fault::zero_divide) : std::fmod(a[0], a[1]);
}

double call_power(const double* a, BuiltinContext& c) {
  if (a[0] == 0 && a[1] < 0) return fail(c, Fault::zero_divide);
  const double result = math::pow(a[0], a[1]);
  return std::isnan(result) ? fail(c, Fault::domain) : result;
}

double call_distance(const double* a, BuiltinContext&) {
  return math::hypot(a[0] - a[3], a[1] - a[4], a[2] - a[5]);
}

// In the order of Function.
constexpr std::array kTable = {
    Builtin{[](const double* a, BuiltinContext&) { return math::sin(a[0]); }, 1},
    Builtin{[](const double* a, BuiltinContext&) { return math::cos(a[0]); }, 1},
    Builtin{[](const double* a, BuiltinContext&) { return math::tan(a[0]); }, 1},
    Builtin{[](const double* a, BuiltinContext&) { return math::atan(a[0]); }, 1},
    Builtin{call_asin, 1},
    Builtin{call_acos, 1},
    Builtin{call_sqr, 1},
    Builtin{[](const double* a, BuiltinContext&) { return std::fabs(a[0]); }, 1},
    Builtin{[](const double* a, BuiltinContext&) { return std::floor(a[0]); }, 1},
    Builtin{call_sgn, 1},
    Builtin{[](const double* a, BuiltinContext&) { return math::exp(a[0]); }, 1},
    Builtin{call_log, 1},
    Builtin{[](const double* a, BuiltinContext&) { return math::atan2(a[0], a[1]); }, 2},
    Builtin{[](const double* a, BuiltinContext&) { return std::min(a[0], a[1]); }, 2},
    Builtin{[](const double* a, BuiltinContext&) { return std::max(a[0], a[1]); }, 2},
    Builtin{call_mod, 2},
    Builtin{call_distance, 6},
    Builtin{call_remainder, 2},
    Builtin{call_power, 2},
    Builtin{[](const double* a, BuiltinContext&) -> double { return a[0] != 0 && a[1] != 0; }, 2},
    Builtin{[](const double* a, BuiltinContext&) -> double { return a[0] != 0 || a[1] != 0; }, 2}};

static_assert(kTable.size() == static_cast<std::size_t>(Function::or_) + 1);

}  // namespace

const Builtin* builtin_table() { return kTable.data(); }

}  // namespace kerf::basic
