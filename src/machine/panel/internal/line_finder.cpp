#include "machine/panel/internal/line_finder.hpp"

#include <array>
#include <cstring>
#include <optional>

namespace kerf::machine {
namespace {

constexpr std::size_t kLongestShown = 256;

// Behind the `count`th end of line from `offset` on.
std::optional<std::uint64_t> behind_lines(const base::SourceFile& file, std::uint64_t offset,
                                          std::uint32_t count) {
  std::array<char, 1 << 14> buffer;
  while (count > 0) {
    const std::size_t size = file.read(offset, buffer);
    if (size == 0) return std::nullopt;
    const char* at = buffer.data();
    const char* const end = at + size;
    while (count > 0) {
      const auto left = static_cast<std::size_t>(end - at);
      const void* const found = std::memchr(at, '\n', left);
      if (found == nullptr) break;
      at = static_cast<const char*>(found) + 1;
      --count;
    }
    offset += count == 0 ? static_cast<std::uint64_t>(at - buffer.data()) : size;
  }
  return offset;
}

}  // namespace

std::string LineFinder::text(const base::SourceFile& file, base::FileId id, std::uint32_t line) {
  if (line == 0) return {};
  const auto index = static_cast<std::size_t>(id);
  if (files_.size() <= index) files_.resize(index + 1);
  std::vector<std::uint64_t>& offsets = files_[index].offsets;
  const std::uint32_t wanted = (line - 1) / kPitch;
  while (offsets.size() <= wanted) {
    const auto next = behind_lines(file, offsets.back(), kPitch);
    if (!next) return {};
    offsets.push_back(*next);
  }
  const auto begin = behind_lines(file, offsets[wanted], (line - 1) % kPitch);
  return begin ? file.line_at(*begin, kLongestShown) : std::string();
}

}  // namespace kerf::machine
