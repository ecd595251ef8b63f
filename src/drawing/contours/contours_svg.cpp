#include <cmath>
#include <numbers>

#include "drawing/contours/contours_writer.hpp"
#include "drawing/contours/internal/piece_writer.hpp"

namespace kerf::drawing {
namespace {

contour::Box page_of(const std::vector<ContourLayer>& layers) {
  contour::Box page{{0, 0}, {0, 0}};
  for (const ContourLayer& layer : layers) {
    for (const contour::Contour& contour : layer.contours) {
      page.take(contour.vertices.empty() ? Vec2{} : contour.vertices.front().point);
      if (edge_count(contour) > 0) page.take(extents(contour));
    }
  }
  return page;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '"': result += "&quot;"; break;
      default: result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

/// Writes path data on a page whose Y goes down from its top.
class PathData {
 public:
  PathData(const contour::Box& page, PieceWriter& out) : page_(page), out_(out) {}

  void write(const contour::Contour& contour);

 private:
  void go_to(std::string_view command, Vec2 point) {
    out_ << command << (point.u - page_.low.u) << " " << (page_.high.v - point.v);
  }
  void write(const contour::Edge& edge);

  const contour::Box& page_;
  PieceWriter& out_;
};

void PathData::write(const contour::Contour& contour) {
  go_to("M", contour.vertices.front().point);
  const std::size_t edges = edge_count(contour);
  for (std::size_t i = 0; i < edges; ++i) write(edge_of(contour, i));
  if (edges == 0) go_to("L", contour.vertices.front().point);
  if (contour.is_closed && edges > 0) out_ << "Z";
}

void PathData::write(const contour::Edge& edge) {
  constexpr double kMost = 1.5 * std::numbers::pi;
  if (edge.bulge == 0) return go_to("L", edge.to);
  const double sweep = std::abs(sweep_rad(edge));
  if (sweep > kMost + 1e-9) {
    // Of nearly a whole turn the ends do not say where its centre is.
    write(part(edge, 0, 0.5));
    return write(part(edge, 0.5, 1));
  }
  const double r = radius(edge);
  out_ << "A" << r << " " << r << " 0 " << (sweep > std::numbers::pi ? "1" : "0") << " "
       << (edge.bulge > 0 ? "0" : "1");
  go_to(" ", edge.to);
}

void write_layer_group(const ContourLayer& layer, const contour::Box& page, PieceWriter& out) {
  const std::string name = escaped(layer.name);
  out << "<g inkscape:groupmode=\"layer\" inkscape:label=\"" << name << "\" stroke=\""
      << text_of(layer.colour) << "\">\n";
  PathData data(page, out);
  for (const contour::Contour& contour : layer.contours) {
    if (contour.vertices.empty()) continue;
    out << "<path d=\"";
    data.write(contour);
    out << "\"/>\n";
  }
  out << "</g>\n";
}

}  // namespace

void write_contours_svg(const std::vector<ContourLayer>& layers, const WritePiece& write) {
  const contour::Box page = page_of(layers);
  const double wide = page.high.u - page.low.u;
  const double high = page.high.v - page.low.v;
  PieceWriter out(write);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\""
      << wide << "mm\" height=\"" << high << "mm\" viewBox=\"0 0 " << wide << " " << high
      << "\" fill=\"none\" stroke-width=\"0.1\">\n";
  for (const ContourLayer& layer : layers) write_layer_group(layer, page, out);
  out << "</svg>\n";
}

}  // namespace kerf::drawing
