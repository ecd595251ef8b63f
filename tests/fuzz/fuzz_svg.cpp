// Any bytes as an SVG: what is drawn is finite, near, and within the budget, every finding is a
// sentence, and the same bytes are drawn the same again.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "drawing/font/layout.hpp"
#include "drawing/svg/read_svg.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostEntities = 2000;

void require(bool condition) {
  if (!condition) std::abort();
}

void read(const std::string& text, drawing::Drawing& drawing, drawing::Font* font) {
  drawing::Reading reading;
  reading.max_entities = kMostEntities;
  reading.limit = base::WorkLimit(5);
  drawing::Canvas canvas(reading, drawing);
  const auto file = base::SourceFile::from_text("-", text);
  drawing::read_svg(*file, base::FileId{}, canvas);
  if (font != nullptr)
    for (const drawing::Text& words : drawing.texts) draw_text(words, *font, {}, canvas);
}

void check(const drawing::Drawing& drawing) {
  require(drawing.entities.size() <= kMostEntities + 1);
  require(std::isfinite(drawing.error_mm) && drawing.error_mm <= 0.01);
  for (const drawing::Path& path : drawing.paths) {
    require(path.count > 0 && path.first + path.count <= drawing.vertices.size());
    for (const auto& vertex : contour_of(drawing, path).vertices) {
      require(std::abs(vertex.point.u) <= drawing::kFarthest_mm);
      require(std::abs(vertex.point.v) <= drawing::kFarthest_mm && std::isfinite(vertex.bulge));
      require(vertex.owner < drawing.entities.size());
    }
  }
  for (const drawing::Finding& finding : drawing.findings)
    require(!finding.diagnostic.message.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto font = drawing::line_font();
  const std::string text(reinterpret_cast<const char*>(data), size);
  drawing::Drawing first;
  read(text, first, font.get());
  check(first);
  drawing::Drawing again;
  read(text, again, font.get());
  require(first.vertices == again.vertices && first.findings.size() == again.findings.size());
  return 0;
}
