#include "machine/definition/stock_place.hpp"

#include <algorithm>
#include <cmath>

#include "machine/definition/number_list.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kMoves = 3;
constexpr std::size_t kMovesAndTurns = 6;

}  // namespace

std::optional<stock::Placement> placement_of(const std::vector<double>& numbers) {
  if (numbers.size() != kMoves && numbers.size() != kMovesAndTurns) return std::nullopt;
  const bool is_near = std::all_of(numbers.begin(), numbers.end(),
                                   [](double value) { return std::fabs(value) <= kFarthest_mm; });
  if (!is_near) return std::nullopt;
  stock::Placement place{.move = {numbers[0], numbers[1], numbers[2]}, .turn_deg = {}};
  if (numbers.size() == kMovesAndTurns) place.turn_deg = {numbers[3], numbers[4], numbers[5]};
  return place;
}

base::Outcome<stock::Placement> stock_place(std::string_view text, const std::string& option) {
  const auto numbers = numbers_in(text, kMoves, kMovesAndTurns);
  const auto place = numbers ? placement_of(*numbers) : std::nullopt;
  if (place) return *place;
  return base::usage(option + " " + std::string(text) +
                     ": X,Y,Z or X,Y,Z,A,B,C is expected, mm and degrees");
}

}  // namespace kerf::machine
