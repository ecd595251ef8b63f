#include <nlohmann/json.hpp>

#include "drawing/contours/contours_writer.hpp"
#include "drawing/contours/internal/piece_writer.hpp"

namespace kerf::drawing {
namespace {

std::string in_quotes(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void write_points(const contour::Contour& contour, PieceWriter& out) {
  const char* comma = "[";
  for (const contour::Vertex& vertex : contour.vertices) {
    (out << comma << "[").json(vertex.point.u) << ",";
    out.json(vertex.point.v) << ",";
    out.json(vertex.bulge) << "]";
    comma = ",";
  }
  out << (contour.vertices.empty() ? "[]" : "]");
}

void write_layer(const ContourLayer& layer, PieceWriter& out) {
  out << "{\"name\":" << in_quotes(layer.name) << ",\"colour\":\"" << text_of(layer.colour)
      << "\",\"contours\":[";
  const char* comma = "\n";
  for (const contour::Contour& contour : layer.contours) {
    out << comma << "{\"closed\":" << (contour.is_closed ? "true" : "false") << ",\"points\":";
    write_points(contour, out);
    out << "}";
    comma = ",\n";
  }
  out << "]}";
}

}  // namespace

void write_contours_json(const std::vector<ContourLayer>& layers, const WritePiece& write) {
  PieceWriter out(write);
  out << "{\"unit\":\"mm\",\"layers\":[";
  const char* comma = "\n";
  for (const ContourLayer& layer : layers) {
    out << comma;
    write_layer(layer, out);
    comma = ",\n";
  }
  out << "]}\n";
}

}  // namespace kerf::drawing
