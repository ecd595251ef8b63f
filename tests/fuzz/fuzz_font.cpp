// Any bytes as a Hershey font, and as one of outlines: a sentence, or letters that draw words in
// finite places.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "drawing/font/layout.hpp"

namespace {

using namespace kerf;

void require(bool condition) {
  if (!condition) std::abort();
}

void draw_with(drawing::Font& font) {
  drawing::Reading reading;
  reading.limit = base::WorkLimit(5);
  drawing::Drawing drawing;
  drawing::Canvas canvas(reading, drawing);
  canvas.begin_file(base::FileId{}, "text");
  drawing::Text text;
  text.words = "AHg 09\nx\xc3\xa9";
  text.height = 5;
  text.upright = drawing::Upright::middle;
  text.entity = canvas.add(drawing::Entity{});
  draw_text(text, font, {}, canvas);
  for (const auto& vertex : drawing.vertices)
    require(std::isfinite(vertex.point.u) && std::isfinite(vertex.point.v));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* name : {"a.jhf", "a.ttf"}) {
    const auto font = drawing::font_of_bytes({reinterpret_cast<const char*>(data), size}, name);
    if (font)
      draw_with(**font);
    else
      require(!font.error().message.empty());
  }
  return 0;
}
