#include "process/internal/nearest_name.hpp"

#include <algorithm>
#include <vector>

namespace kerf::process {
namespace {

constexpr std::size_t kShown = 40;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Changes of letters that make `b` of `a`: row by row of the table over both words' beginnings.
std::size_t changes_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) table[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      std::size_t least = std::min(table[i - 1][j], table[i][j - 1]) + 1;
      least = std::min(least, table[i - 1][j - 1] + (same ? 0U : 1U));
      const bool exchanged = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                             lower(a[i - 2]) == lower(b[j - 1]);
      table[i][j] = exchanged ? std::min(least, table[i - 2][j - 2] + 1) : least;
    }
  }
  return table[a.size()][b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
  word = word.substr(0, kShown);
  std::string_view nearest;
  std::size_t least = word.size() / 2 + 1;
  for (const std::string_view name : names) {
    const std::size_t changes = changes_between(word, name);
    if (changes < least) least = changes, nearest = name;
  }
  return nearest;
}

std::string nearest_hint(std::string_view word, std::span<const std::string_view> names) {
  const std::string_view nearest = nearest_name(word, names);
  return nearest.empty() ? std::string{} : std::string(nearest) + " is the nearest name";
}

std::string shown(std::string_view word) {
  return std::string(word.substr(0, kShown)) + (word.size() > kShown ? "…" : "");
}

}  // namespace kerf::process
