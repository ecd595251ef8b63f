#include "drawing/svg/internal/lengths.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/svg/internal/scanner.hpp"
#include "drawing/units.hpp"

namespace kerf::drawing::svg {
namespace {

double whole_of(Along along, Vec2 viewport) {
  if (along == Along::x) return viewport.u;
  if (along == Along::y) return viewport.v;
  return std::sqrt(0.5 * geometry::dot(viewport, viewport));
}

}  // namespace

std::optional<Length> length_of(std::string_view text) {
  Scanner in(text);
  in.skip_blanks();
  const auto number = in.number();
  if (!number) return std::nullopt;
  Length length{*number, trimmed(in.rest())};
  if (length.unit.size() > 3) return std::nullopt;
  return length;
}

std::optional<double> in_units(const Length& length, Along along, const Measures& measures) {
  constexpr double kExOfEm = 0.5;
  if (length.unit.empty() || same_letters(length.unit, "px")) return length.number;
  if (length.unit == "%") return 0.01 * length.number * whole_of(along, measures.viewport);
  if (same_letters(length.unit, "em")) return length.number * measures.font_size;
  if (same_letters(length.unit, "ex")) return length.number * kExOfEm * measures.font_size;
  for (const std::string_view unit : {"mm", "cm", "in", "pt", "pc", "q"})
    if (same_letters(length.unit, unit))
      return length.number * *mm_of_unit(unit) * measures.dpi / kMmAnInch;
  return std::nullopt;
}

std::vector<double> lengths_of(std::string_view text, Along along, const Measures& measures) {
  constexpr std::size_t kMostLengths = 1000;
  std::vector<double> found;
  while (!(text = trimmed(text)).empty() && found.size() < kMostLengths) {
    const std::size_t end = std::min(text.find_first_of(", \t\n\r"), text.size());
    const auto length = length_of(text.substr(0, end));
    const auto units = length ? in_units(*length, along, measures) : std::nullopt;
    if (!units) break;
    found.push_back(*units);
    text.remove_prefix(end);
    text = trimmed(text);
    if (text.starts_with(',')) text.remove_prefix(1);
  }
  return found;
}

}  // namespace kerf::drawing::svg
