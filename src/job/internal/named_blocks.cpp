#include "job/internal/named_blocks.hpp"

#include <algorithm>
#include <charconv>

namespace kerf::job {

std::vector<std::uint32_t> named_blocks(std::string_view text) {
  std::vector<std::uint32_t> names;
  for (std::size_t at = text.find_first_of("PQOpqo"); at != std::string_view::npos;
       at = text.find_first_of("PQOpqo", at + 1)) {
    const std::size_t digits = text.find_first_not_of("0 ", at + 1);
    if (digits == std::string_view::npos) break;
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + digits, end, number);
    if (read.ec == std::errc() && number > 0) names.push_back(number);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace kerf::job
