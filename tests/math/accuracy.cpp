// How far each function of math/math.hpp is from the true value, which MPFR computes with 160 bits.
//
//   kerf_math_accuracy [--points N] [--seed S]
//
// N arguments a function (default 20000): all over its domain, around the places where it is hard,
// and any bit patterns. Prints the worst error in units of the last digit and where it is; exit
// status 1 when one is above what the header promises.
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "math/math.hpp"

namespace {

constexpr mpfr_prec_t kPrecision = 160;
constexpr double kTinyBound = 1.0;  // of results below the smallest normal number

class Number {
 public:
  Number() { mpfr_init2(value_, kPrecision); }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

class Arguments {
 public:
  explicit Arguments(std::uint64_t seed) : engine_(seed) {}

  double in(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  bool one_of(unsigned n) { return engine_() % n == 0; }
  double any() {
    for (;;) {
      const double value = std::bit_cast<double>(engine_());
      if (std::isfinite(value)) return value;
    }
  }
  /// Of any size up to `most`, small ones as often as large ones.
  double sized(double most) {
    const double size = std::exp(in(-40, std::log(most)));
    return one_of(2) ? size : -size;
  }
  double around(double most) {
    return one_of(8) ? any() : one_of(2) ? in(-most, most) : sized(most);
  }
  /// The doubles next to a multiple of a quarter turn.
  double near_quarter() {
    double angle = std::floor(in(0, 2e6)) * 1.5707963267948966;
    const int steps = static_cast<int>(in(0, 5)) - 2;
    for (int i = 0; i < std::abs(steps); ++i)
      angle = std::nextafter(angle, steps < 0 ? -INFINITY : INFINITY);
    return angle;
  }
  double angle() { return one_of(4) ? near_quarter() : around(100); }
  double exponent() { return one_of(2) ? in(-760, 720) : sized(700); }
  double share() { return one_of(3) ? 1 - std::exp(in(-36, 0)) : one_of(2) ? sized(1) : in(-1, 1); }
  double positive() { return one_of(3) ? 1 + in(-0.02, 0.02) : std::fabs(around(100)); }

 private:
  std::mt19937_64 engine_;
};

/// In units of the last digit of the true value, which is `exact`.
double error_of(double got, mpfr_ptr exact) {
  static Number difference;
  const double nearest = mpfr_get_d(exact, MPFR_RNDN);
  if (std::isnan(nearest)) return std::isnan(got) ? 0 : INFINITY;
  if (got == nearest) return 0;  // at most 0.5
  // One beyond the largest double is not what rounding alone decides.
  if (!std::isfinite(nearest) || !std::isfinite(got))
    return std::fabs(got) >= std::numeric_limits<double>::max() &&
                   std::fabs(nearest) >= std::numeric_limits<double>::max()
               ? 0.5
               : INFINITY;
  int exponent = 0;
  std::frexp(nearest, &exponent);
  exponent = std::max(exponent, -1021);
  mpfr_sub_d(difference.get(), exact, got, MPFR_RNDN);
  mpfr_abs(difference.get(), difference.get(), MPFR_RNDN);
  mpfr_mul_2si(difference.get(), difference.get(), 53 - exponent, MPFR_RNDN);
  return mpfr_get_d(difference.get(), MPFR_RNDN);
}

bool is_tiny(double value) { return std::fabs(value) < std::numeric_limits<double>::min(); }

struct Subject {
  const char* name;
  double bound;
  /// Draws arguments, sets the true value, returns ours and writes down the arguments.
  std::function<double(Arguments&, mpfr_ptr exact, std::string& where)> once;
};

std::string shown(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

Subject unary(const char* name, double bound, double (*ours)(double), Unary exact,
              double (Arguments::*draw)()) {
  return {name, bound, [=](Arguments& arguments, mpfr_ptr into, std::string& where) {
            static Number x;
            const double value = (arguments.*draw)();
            mpfr_set_d(x.get(), value, MPFR_RNDN);
            exact(into, x.get(), MPFR_RNDN);
            where = shown(value);
            return ours(value);
          }};
}

Subject binary(const char* name, double bound, double (*ours)(double, double), Binary exact,
               std::function<double(Arguments&)> first, std::function<double(Arguments&)> second) {
  return {name, bound, [=](Arguments& arguments, mpfr_ptr into, std::string& where) {
            static Number x;
            static Number y;
            const double a = first(arguments);
            const double b = second(arguments);
            mpfr_set_d(x.get(), a, MPFR_RNDN);
            mpfr_set_d(y.get(), b, MPFR_RNDN);
            exact(into, x.get(), y.get(), MPFR_RNDN);
            where = shown(a) + " " + shown(b);
            return ours(a, b);
          }};
}

Subject length_in_space(double bound) {
  return {"hypot3", bound, [](Arguments& arguments, mpfr_ptr into, std::string& where) {
            static Number x;
            static Number sum;
            mpfr_set_d(sum.get(), 0, MPFR_RNDN);
            double way[3];
            for (double& part : way) {
              part = arguments.around(100);
              mpfr_set_d(x.get(), part, MPFR_RNDN);
              mpfr_hypot(sum.get(), sum.get(), x.get(), MPFR_RNDN);
              where += shown(part) + " ";
            }
            mpfr_set(into, sum.get(), MPFR_RNDN);
            return kerf::math::hypot(way[0], way[1], way[2]);
          }};
}

double any_size(Arguments& arguments) { return arguments.around(100); }
double base_of_power(Arguments& arguments) { return arguments.positive(); }
double exponent_of_power(Arguments& arguments) {
  return arguments.one_of(3)   ? arguments.in(-10000, 10000)
         : arguments.one_of(2) ? std::floor(arguments.in(-20, 20))
                               : arguments.in(-20, 20);
}

/// False where it is worse than promised.
bool measure(const Subject& subject, std::uint64_t points, std::uint64_t seed) {
  Arguments arguments(seed);
  Number exact;
  double worst = 0;
  double worst_tiny = 0;
  std::string worst_at;
  for (std::uint64_t i = 0; i < points; ++i) {
    std::string where;
    const double got = subject.once(arguments, exact.get(), where);
    const double error = error_of(got, exact.get());
    double& most = is_tiny(mpfr_get_d(exact.get(), MPFR_RNDN)) ? worst_tiny : worst;
    if (error <= most) continue;
    most = error;
    if (error > kTinyBound || &most == &worst) worst_at = where;
  }
  const bool good = worst <= subject.bound && worst_tiny <= kTinyBound;
  std::printf("%-7s %.4f (promised %.2f)  below 2^-1022: %.4f  %s%s\n", subject.name, worst,
              subject.bound, worst_tiny, good ? "at " : "FAILS at ", worst_at.c_str());
  std::fflush(stdout);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t points = 20000;
  std::uint64_t seed = 20260101;
  for (int i = 1; i < argc; i += 2) {
    const bool is_points = std::strcmp(argv[i], "--points") == 0;
    const bool is_known = is_points || std::strcmp(argv[i], "--seed") == 0;
    char* end = nullptr;
    const std::uint64_t value = i + 1 < argc ? std::strtoull(argv[i + 1], &end, 10) : 0;
    if (!is_known || end == nullptr || *end != 0) {
      std::fprintf(stderr, "usage: kerf_math_accuracy [--points N] [--seed S]\n");
      return 2;
    }
    (is_points ? points : seed) = value;
  }
  namespace math = kerf::math;
  using A = Arguments;
  const Subject subjects[] = {
      unary("sin", 0.55, math::sin, mpfr_sin, &A::angle),
      unary("cos", 0.55, math::cos, mpfr_cos, &A::angle),
      unary("tan", 0.53, math::tan, mpfr_tan, &A::angle),
      unary("asin", 0.51, math::asin, mpfr_asin, &A::share),
      unary("acos", 0.51, math::acos, mpfr_acos, &A::share),
      unary("atan", 0.51, math::atan, mpfr_atan, &A::angle),
      binary("atan2", 0.51, math::atan2, mpfr_atan2, any_size, any_size),
      unary("exp", 0.52, math::exp, mpfr_exp, &A::exponent),
      unary("log", 0.51, math::log, mpfr_log, &A::positive),
      unary("log2", 0.51, math::log2, mpfr_log2, &A::positive),
      unary("log10", 0.51, math::log10, mpfr_log10, &A::positive),
      binary("pow", 0.52, math::pow, mpfr_pow, base_of_power, exponent_of_power),
      binary(
          "hypot", 0.51, [](double x, double y) { return math::hypot(x, y); }, mpfr_hypot, any_size,
          any_size),
      length_in_space(0.51),
      unary("cbrt", 0.51, math::cbrt, mpfr_cbrt, &A::angle),
  };
  bool good = true;
  for (const Subject& subject : subjects) good = measure(subject, points, seed) && good;
  return good ? 0 : 1;
}
