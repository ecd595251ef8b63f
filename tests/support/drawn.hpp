#pragma once

#include <memory>
#include <string>

#include "base/source_file.hpp"
#include "drawing/canvas.hpp"

namespace kerf::drawing {

/// A text that was read as a drawing.
struct Drawn {
  using Reader = void (*)(const base::SourceFile&, base::FileId, Canvas&);

  explicit Drawn(Reader reader, const std::string& text, Reading how = {})
      : reading(std::move(how)) {
    const auto file = base::SourceFile::from_text("a", text);
    Canvas canvas(reading, drawing);
    reader(*file, base::FileId{0}, canvas);
  }

  [[nodiscard]] const FileFacts& facts() const { return drawing.files.front(); }
  [[nodiscard]] contour::Contour path(std::size_t i) const {
    return contour_of(drawing, drawing.paths.at(i));
  }
  [[nodiscard]] const Entity& entity_of(std::size_t path) const {
    return drawing.entities.at(drawing.vertices.at(drawing.paths.at(path).first).owner);
  }
  [[nodiscard]] std::string_view layer_of(std::size_t path) const {
    return drawing.names[entity_of(path).layer];
  }
  /// "DXF_GROUP:12 …" a line, in the order in which they were told.
  [[nodiscard]] std::string findings() const {
    std::string text;
    for (const Finding& finding : drawing.findings) {
      const base::Diagnostic& told = finding.diagnostic;
      text += told.number + ":" + std::to_string(told.place.line) + " " + told.message + "\n";
    }
    return text;
  }
  [[nodiscard]] std::string codes() const {
    std::string text;
    for (const Finding& finding : drawing.findings)
      text += (text.empty() ? "" : " ") + finding.diagnostic.number;
    return text;
  }
  /// "layer OFF 2" each, parted by commas.
  [[nodiscard]] std::string ignored() const {
    std::string text;
    for (const Ignored& what : facts().ignored)
      text += (text.empty() ? "" : ", ") + what.what + " " + std::to_string(what.count);
    return text;
  }

  Reading reading;
  Drawing drawing;
};

}  // namespace kerf::drawing
