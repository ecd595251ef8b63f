#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

using Reader = void (*)(const base::SourceFile&, base::FileId, drawing::Canvas&);

/// All vertices are where a machine may be, each path has some, each belongs to an entity.
inline void check(const drawing::Drawing& drawing) {
  constexpr double kFarthest_mm = 1e6;
  for (const contour::Vertex& vertex : drawing.vertices) {
    require(std::abs(vertex.point.u) <= kFarthest_mm && std::abs(vertex.point.v) <= kFarthest_mm);
    require(std::isfinite(vertex.bulge) && vertex.owner < drawing.entities.size());
  }
  for (const drawing::Path& path : drawing.paths)
    require(path.count > 0 && path.first + path.count <= drawing.vertices.size());
  for (const drawing::Text& text : drawing.texts) require(text.entity < drawing.entities.size());
  for (const drawing::Finding& finding : drawing.findings)
    require(!finding.diagnostic.message.empty());
}

/// Reads any bytes within a small budget.
inline void read(Reader reader, const std::uint8_t* data, std::size_t size) {
  const auto file =
      base::SourceFile::from_text("-", std::string(reinterpret_cast<const char*>(data), size));
  drawing::Reading reading;
  reading.max_entities = 5000;
  reading.limit = base::WorkLimit(5);
  drawing::Drawing drawing;
  drawing::Canvas canvas(reading, drawing);
  reader(*file, base::FileId{0}, canvas);
  check(drawing);
  require(drawing.entities.size() <= reading.max_entities + 1);
}

}  // namespace kerf::fuzz
