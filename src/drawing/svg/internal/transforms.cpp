#include "drawing/svg/internal/transforms.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "drawing/svg/internal/scanner.hpp"
#include "math/math.hpp"

namespace kerf::drawing::svg {
namespace {

using Numbers = std::span<const double>;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Quarters exactly.
Affine turned(double degrees) {
  constexpr std::array<Vec2, 4> kQuarters{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
  const double quarters = degrees / 90;
  if (quarters != std::floor(quarters) || std::abs(quarters) > 1e6)
    return Affine::turned(radians(degrees));
  const Vec2 x = kQuarters[static_cast<std::size_t>(static_cast<long>(quarters) & 3)];
  return {x, geometry::left_of(x), {}};
}

std::optional<Affine> rotate(Numbers n) {
  if (n.size() == 1) return turned(n[0]);
  if (n.size() != 3) return std::nullopt;
  const Vec2 centre{n[1], n[2]};
  return then(then(Affine::moved(-centre), turned(n[0])), Affine::moved(centre));
}

std::optional<Affine> matrix(Numbers n) {
  if (n.size() != 6) return std::nullopt;
  return Affine{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
}

std::optional<Affine> one_of(std::string_view name, Numbers n) {
  if (name == "matrix") return matrix(n);
  if (name == "rotate") return rotate(n);
  if (n.empty() || n.size() > 2) return std::nullopt;
  if (name == "translate") return Affine::moved({n[0], n.size() == 2 ? n[1] : 0});
  if (name == "scale") return Affine::scaled(n[0], n.back());
  if (n.size() != 1) return std::nullopt;
  if (name == "skewX") return Affine{{1, 0}, {math::tan(radians(n[0])), 1}, {}};
  if (name == "skewY") return Affine{{1, math::tan(radians(n[0]))}, {0, 1}, {}};
  return std::nullopt;
}

/// Numbers up to the bracket that closes, which is taken.
std::optional<std::vector<double>> arguments(Scanner& in) {
  std::vector<double> numbers;
  for (in.skip_blanks(); !in.take(')'); in.skip_comma()) {
    const auto number = in.number();
    if (!number) return std::nullopt;
    if (in.rest().starts_with("deg")) in.advance(3);
    if (in.rest().starts_with("px")) in.advance(2);
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

std::optional<Affine> transform_of(std::string_view text) {
  Affine all;
  Scanner in(text);
  in.skip_blanks();
  if (in.rest() == "none") return all;
  while (!in.is_done()) {
    const std::string_view name = in.word();
    in.skip_blanks();
    if (name.empty() || !in.take('(')) return std::nullopt;
    const auto numbers = arguments(in);
    if (!numbers) return std::nullopt;
    const auto next = one_of(name, *numbers);
    if (!next) return std::nullopt;
    all = then(*next, all);
    in.skip_comma();
  }
  return all;
}

}  // namespace kerf::drawing::svg
