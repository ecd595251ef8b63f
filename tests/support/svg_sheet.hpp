#pragma once

#include <gtest/gtest.h>

#include <string>

#include "drawing/svg/read_svg.hpp"

namespace kerf::drawing {

/// What becomes of an SVG file.
struct Svg {
  Reading reading;
  Drawing drawing;

  explicit Svg(const std::string& text, const Reading& how = {}, const std::string& folder = {})
      : reading(how) {
    Canvas canvas(reading, drawing);
    const auto file = base::SourceFile::from_text("drawing.svg", text);
    read_svg(*file, base::FileId{}, canvas, folder);
  }
  [[nodiscard]] contour::Contour contour(std::size_t index) const {
    return contour_of(drawing, drawing.paths.at(index));
  }
  [[nodiscard]] contour::Box extents() const {
    contour::Box box;
    for (const Path& path : drawing.paths) box.take(contour::extents(contour_of(drawing, path)));
    return box;
  }
  [[nodiscard]] std::string layer(std::size_t entity) const {
    return std::string(drawing.names[drawing.entities.at(entity).layer]);
  }
  /// Codes of all findings, parted by blanks.
  [[nodiscard]] std::string codes() const {
    std::string all;
    for (const Finding& finding : drawing.findings) all += finding.diagnostic.number + " ";
    return all.empty() ? all : all.substr(0, all.size() - 1);
  }
  [[nodiscard]] std::string message(std::size_t index) const {
    return drawing.findings.at(index).diagnostic.message;
  }
  [[nodiscard]] std::size_t ignored(const std::string& what) const {
    for (const Ignored& one : drawing.files[0].ignored)
      if (one.what == what) return one.count;
    return 0;
  }
};

/// 40 mm square, a unit a mm; Y of the file is 40 - y.
inline std::string page(const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"40mm\" "
         "height=\"40mm\" viewBox=\"0 0 40 40\">\n" +
         inside + "\n</svg>";
}

inline std::string root(const std::string& attributes, const std::string& inside) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + inside + "</svg>";
}

inline void expect_box(const contour::Box& box, Vec2 low, Vec2 high, double within = 1e-9) {
  EXPECT_NEAR(box.low.u, low.u, within);
  EXPECT_NEAR(box.low.v, low.v, within);
  EXPECT_NEAR(box.high.u, high.u, within);
  EXPECT_NEAR(box.high.v, high.v, within);
}

}  // namespace kerf::drawing
