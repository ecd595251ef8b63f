#include "drawing/font/font.hpp"

#include "base/source_file.hpp"
#include "drawing/font/internal/hershey.hpp"
#include "drawing/font/internal/outline_font.hpp"
#include "drawing/small_letters.hpp"

namespace kerf::drawing {
namespace {

constexpr std::uint64_t kMostFontBytes = 64U << 20U;

bool ends_with_jhf(const std::string& name) { return in_small_letters(name).ends_with(".jhf"); }

}  // namespace

base::Outcome<std::unique_ptr<Font>> font_of_bytes(std::string bytes, const std::string& name) {
  if (ends_with_jhf(name)) return read_hershey(bytes, name);
  return read_outlines(std::move(bytes), name);
}

base::Outcome<std::unique_ptr<Font>> open_font(const std::string& name) {
  if (name == "kerf-line") return line_font();
  auto bytes = base::read_whole(name, kMostFontBytes, "a font");
  if (!bytes) return tl::unexpected(bytes.error());
  return font_of_bytes(std::move(*bytes), name);
}

}  // namespace kerf::drawing
