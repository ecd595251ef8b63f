// One number for all bits that a function of math/math.hpp gives: the same wherever the room is
// built.
//
//   kerf_math_fingerprint [POINTS]
//
// POINTS arguments a function (default 1000000), by whole numbers alone: any bit patterns, an
// interval around 0, and the neighbourhood of 1. Prints a line for each function. Needs nothing of
// the C++ library but headers, so that it links with every C library.
#include <bit>
#include <cstdint>
#include <cstdio>

#include "math/math.hpp"

namespace {

namespace math = kerf::math;

// Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014.
class Arguments {
 public:
  double next() {
    const std::uint64_t bits = draw();
    switch (draw() >> 62) {
      case 0: return std::bit_cast<double>(bits);
      case 1: return static_cast<double>(static_cast<std::int64_t>(bits)) * 0x1p-56;  // ±128
      case 2: return static_cast<double>(static_cast<std::int64_t>(bits)) * 0x1p-63;  // ±1
      default: return 1 + static_cast<double>(static_cast<std::int64_t>(bits)) * 0x1p-69;
    }
  }

 private:
  std::uint64_t draw() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
    z = (z ^ z >> 27) * 0x94D049BB133111EBU;
    return z ^ z >> 31;
  }
  std::uint64_t state_ = 20260101;
};

// FNV-1a over words. What is not a number has many bit patterns, of which none is said.
class Fingerprint {
 public:
  void add(double value) {
    constexpr std::uint64_t kNoNumber = 0x7FF8000000000000U;
    hash_ = (hash_ ^ (value == value ? std::bit_cast<std::uint64_t>(value) : kNoNumber)) *
            0x100000001B3U;
    hash_ ^= hash_ >> 29;
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

void print(const char* name, const Fingerprint& found) {
  std::printf("%-6s %08x%08x\n", name, static_cast<unsigned>(found.value() >> 32),
              static_cast<unsigned>(found.value()));
}

template <typename Function>
void of_one(const char* name, unsigned points, Function function) {
  Arguments arguments;
  Fingerprint found;
  for (unsigned i = 0; i < points; ++i) found.add(function(arguments.next()));
  print(name, found);
}

template <typename Function>
void of_two(const char* name, unsigned points, Function function) {
  Arguments arguments;
  Fingerprint found;
  for (unsigned i = 0; i < points; ++i) {
    const double x = arguments.next();
    found.add(function(x, arguments.next()));
  }
  print(name, found);
}

// 0: no number.
unsigned points_of(const char* text) {
  unsigned points = 0;
  for (; *text >= '0' && *text <= '9' && points < 100'000'000; ++text)
    points = points * 10 + static_cast<unsigned>(*text - '0');
  return *text == 0 ? points : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned points = argc > 1 ? points_of(argv[1]) : 1'000'000;
  if (points == 0 || argc > 2) {
    std::fprintf(stderr, "usage: kerf_math_fingerprint [POINTS]\n");
    return 2;
  }
  of_one("sin", points, math::sin);
  of_one("cos", points, math::cos);
  of_one("both", points, [](double x) {
    const math::SineCosine at = math::sine_cosine(x);
    return at.sine - at.cosine;
  });
  of_one("tan", points, math::tan);
  of_one("asin", points, math::asin);
  of_one("acos", points, math::acos);
  of_one("atan", points, math::atan);
  of_two("atan2", points, math::atan2);
  of_one("exp", points, math::exp);
  of_one("log", points, math::log);
  of_one("log2", points, math::log2);
  of_one("log10", points, math::log10);
  of_two("pow", points, math::pow);
  of_two("hypot", points, [](double x, double y) { return math::hypot(x, y); });
  of_two("hypot3", points, [](double x, double y) { return math::hypot(x, y, x - y); });
  of_one("cbrt", points, math::cbrt);
  return 0;
}
