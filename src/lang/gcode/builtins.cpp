#include "lang/gcode/builtins.hpp"

#include <cmath>
#include <numbers>

#include "lang/gcode/math_rules.hpp"
#include "lang/gcode/page.hpp"
#include "lang/vm/value.hpp"
#include "math/math.hpp"

namespace kerf::gcode {
namespace {

using vm::BuiltinContext;
using vm::Fault;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSmallestResult = 1e-8;  // MFZ
constexpr double kLargestBcd = 99999999;
constexpr double kLargestLabel = 99999999;

double number(const double* arguments, int i = 0) { return vm::zero_if_null(arguments[i]); }

const MathRules& rules(const BuiltinContext& context) {
  return *static_cast<const MathRules*>(context.rules);
}

double fail(BuiltinContext& context, Fault fault) {
  context.fault = fault;
  return 0;
}

// An angle as quarter turns and a rest in [-45, 45] degrees. Exact: for |angle| < 2^44 the
// remainder of a division by 90 is a double.
struct Quarters {
  int quarter = 0;  // 0 to 3
  double rest_deg = 0;
};

Quarters quarters_of(double angle_deg) {
  if (!(std::fabs(angle_deg) < 0x1p44)) angle_deg = std::fmod(angle_deg, 360.0);
  const double turns = std::nearbyint(angle_deg / 90.0);
  const double rest = angle_deg - turns * 90.0;
  return {static_cast<int>(static_cast<long long>(turns) & 3), rest};
}

// Exact where people expect it: at multiples of 30 and 45 degrees (docs/dialect.md §4.2).
double sin_of_rest(double rest_deg) {
  if (rest_deg == 30) return 0.5;
  if (rest_deg == -30) return -0.5;
  if (std::fabs(rest_deg) == 45) return std::copysign(std::numbers::sqrt2 / 2, rest_deg);
  return math::sin(rest_deg * kDegree);
}

double cos_of_rest(double rest_deg) {
  if (std::fabs(rest_deg) == 45) return std::numbers::sqrt2 / 2;
  return math::cos(rest_deg * kDegree);
}

double sine(double angle_deg) {
  const Quarters q = quarters_of(angle_deg);
  const double value = (q.quarter & 1) != 0 ? cos_of_rest(q.rest_deg) : sin_of_rest(q.rest_deg);
  return (q.quarter & 2) != 0 ? -value : value;
}

double cosine(double angle_deg) {
  const Quarters q = quarters_of(angle_deg);
  const double value = (q.quarter & 1) != 0 ? -sin_of_rest(q.rest_deg) : cos_of_rest(q.rest_deg);
  return (q.quarter & 2) != 0 ? -value : value;
}

double drop_small(double value, const BuiltinContext& context) {
  return rules(context).small_is_zero && std::fabs(value) < kSmallestResult ? 0.0 : value;
}

double call_sin(const double* a, BuiltinContext& c) { return drop_small(sine(number(a)), c); }
double call_cos(const double* a, BuiltinContext& c) { return drop_small(cosine(number(a)), c); }

double call_tan(const double* a, BuiltinContext& c) {
  const double denominator = drop_small(cosine(number(a)), c);
  if (denominator == 0) return fail(c, Fault::zero_divide);
  const double rest = std::fabs(quarters_of(number(a)).rest_deg);
  const double value = sine(number(a)) / denominator;
  return rest == 45 ? std::copysign(1.0, value) : drop_small(value, c);
}

// Degrees of an inverse function, exact at the angles whose sine and cosine are.
double degrees(double angle_rad) {
  const double angle = angle_rad / kDegree;
  const double nearest = std::nearbyint(angle / 15) * 15;
  return std::fabs(angle - nearest) < 1e-13 * 360 ? nearest : angle;
}

double call_asin(const double* a, BuiltinContext& c) {
  if (std::fabs(number(a)) > 1) return fail(c, Fault::domain);
  const double angle = degrees(math::asin(number(a)));
  return angle < 0 && !rules(c).signed_angles ? angle + 360 : angle;
}

double call_acos(const double* a, BuiltinContext& c) {
  if (std::fabs(number(a)) > 1) return fail(c, Fault::domain);
  return degrees(math::acos(number(a)));
}

double call_atan(const double* a, BuiltinContext&) { return degrees(math::atan(number(a))); }

double call_atan2(const double* a, BuiltinContext& c) {
  const double y = number(a);
  const double x = number(a, 1);
  if (y == 0 && x == 0) return 0;
  const double angle = degrees(math::atan2(y + 0.0, x));
  return angle < 0 && !rules(c).signed_angles ? angle + 360 : angle;
}

double call_sqrt(const double* a, BuiltinContext& c) {
  return number(a) < 0 ? fail(c, Fault::domain) : std::sqrt(number(a));
}

double call_abs(const double* a, BuiltinContext&) { return std::fabs(number(a)); }
double call_round(const double* a, BuiltinContext&) { return std::round(number(a)); }
double call_fix(const double* a, BuiltinContext&) { return std::trunc(number(a)); }

double call_fup(const double* a, BuiltinContext&) {
  return number(a) < 0 ? std::floor(number(a)) : std::ceil(number(a));
}

// NUM-14: to the increment, ties away from zero, with a guard of 1e-6 increments because 1.2345 is
// stored as 1.23449999….
double call_round_to(const double* a, BuiltinContext&) {
  const double steps = number(a) / number(a, 1);
  return std::round(steps + std::copysign(1e-6, steps)) * number(a, 1);
}

double call_ln(const double* a, BuiltinContext& c) {
  return number(a) <= 0 ? fail(c, Fault::domain) : math::log(number(a));
}

double call_exp(const double* a, BuiltinContext& c) {
  const double value = math::exp(number(a));
  return vm::is_number(value) ? value : fail(c, Fault::domain);
}

double call_pow(const double* a, BuiltinContext& c) {
  const double value = math::pow(number(a), number(a, 1));
  return vm::is_number(value) ? value : fail(c, Fault::domain);
}

double call_bcd(const double* a, BuiltinContext& c) {
  const double rounded = std::round(number(a));
  if (rounded < 0 || rounded > kLargestBcd) return fail(c, Fault::domain);
  auto rest = static_cast<std::uint32_t>(rounded);
  std::uint32_t result = 0;
  for (int shift = 0; rest != 0; shift += 4, rest /= 10) result |= rest % 10 << shift;
  return result;
}

double call_bin(const double* a, BuiltinContext& c) {
  const double rounded = std::round(number(a));
  if (rounded < 0 || rounded > 4294967295.0) return fail(c, Fault::domain);
  auto rest = static_cast<std::uint32_t>(rounded);
  double result = 0;
  for (double weight = 1; rest != 0; weight *= 10, rest >>= 4) {
    if ((rest & 15U) > 9) return fail(c, Fault::domain);
    result += weight * (rest & 15U);
  }
  return result;
}

double call_adp(const double* a, BuiltinContext& c) { return number(a) * rules(c).adp_factor; }

double call_mod(const double* a, BuiltinContext& c) {
  const double divisor = std::round(number(a, 1));
  if (divisor == 0) return fail(c, Fault::zero_divide);
  return std::fmod(std::round(number(a)), divisor) + 0.0;
}

// Operands of AND, OR, XOR: 32-bit integers in two's complement; 0 to 2^32-1 count as well.
bool to_bits(double value, std::uint32_t& bits, BuiltinContext& c) {
  const double rounded = std::round(value);
  if (rounded < -2147483648.0 || rounded > 4294967295.0) {
    c.fault = Fault::integer_overflow;
    return false;
  }
  bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded));
  return true;
}

template <typename Operation>
double bitwise(const double* a, BuiltinContext& c, Operation operation) {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  if (!to_bits(number(a), x, c) || !to_bits(number(a, 1), y, c)) return 0;
  return static_cast<std::int32_t>(operation(x, y));
}

double call_and(const double* a, BuiltinContext& c) {
  return bitwise(a, c, [](std::uint32_t x, std::uint32_t y) { return x & y; });
}
double call_or(const double* a, BuiltinContext& c) {
  return bitwise(a, c, [](std::uint32_t x, std::uint32_t y) { return x | y; });
}
double call_xor(const double* a, BuiltinContext& c) {
  return bitwise(a, c, [](std::uint32_t x, std::uint32_t y) { return x ^ y; });
}

double call_label(const double* a, BuiltinContext& c) {
  const double rounded = std::round(number(a));
  return rounded < 1 || rounded > kLargestLabel ? fail(c, Fault::label_range) : rounded;
}

double call_parameter(const double* a, BuiltinContext& c) {
  const double parameter = std::round(number(a));
  const double suffix = std::round(number(a, 1));
  if (parameter < 0 || parameter > 99999 || suffix < 0 || suffix > 99)
    return fail(c, Fault::domain);
  return kParameter + 100 * parameter + suffix;
}

// In the order of Function.
constexpr vm::Builtin kBuiltins[] = {
    {call_sin, 1},  {call_cos, 1},   {call_tan, 1},      {call_asin, 1},  {call_acos, 1},
    {call_atan, 1}, {call_atan2, 2}, {call_sqrt, 1},     {call_abs, 1},   {call_bin, 1},
    {call_bcd, 1},  {call_round, 1}, {call_round_to, 2}, {call_fix, 1},   {call_fup, 1},
    {call_ln, 1},   {call_exp, 1},   {call_pow, 2},      {call_adp, 1},   {call_mod, 2},
    {call_and, 2},  {call_or, 2},    {call_xor, 2},      {call_label, 1}, {call_parameter, 2}};

}  // namespace

const vm::Builtin* builtin_table() { return kBuiltins; }

}  // namespace kerf::gcode
