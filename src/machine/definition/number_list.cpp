#include "machine/definition/number_list.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::machine {
namespace {

std::vector<std::string_view> items_of(std::string_view list) {
  std::vector<std::string_view> items;
  while (true) {
    const std::size_t comma = std::min(list.find(','), list.size());
    items.push_back(list.substr(0, comma));
    if (comma == list.size()) return items;
    list.remove_prefix(comma + 1);
  }
}

}  // namespace

std::optional<std::vector<double>> numbers_in(std::string_view list, std::size_t least,
                                              std::size_t most) {
  const std::vector<std::string_view> items = items_of(list);
  if (items.size() < least || items.size() > most) return std::nullopt;
  std::vector<double> values;
  for (const std::string_view item : items) {
    const auto value = base::read_number(item);
    if (!value || std::fabs(*value) > kFarthest_mm) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

}  // namespace kerf::machine
