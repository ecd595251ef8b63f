#include "output/part/profile_writer.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::output {
namespace {

using base::number_text;
using base::tidy;
using geometry::Vec2;

std::string pair(double a, double b, const char* between) {
  return number_text(tidy(a)) + between + number_text(tidy(b));
}

/// Upside down: SVG counts downwards.
std::string place(Vec2 p) { return pair(p.u, -p.v, " "); }

std::string arc_to(const contour::Edge& edge) {
  const std::string radius = number_text(tidy(contour::radius(edge)));
  const char* const large = std::fabs(edge.bulge) > 1 ? "1" : "0";
  const char* const sweep = edge.bulge > 0 ? "0" : "1";
  return "A" + radius + " " + radius + " 0 " + large + " " + sweep + " " + place(edge.to);
}

std::string path_of(const contour::Region& region) {
  std::string path;
  for (const contour::Contour& loop : region.loops) {
    if (loop.vertices.empty()) continue;
    path += "M" + place(loop.vertices.front().point);
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      const contour::Edge edge = contour::edge_of(loop, i);
      path += edge.bulge == 0 ? "L" + place(edge.to) : arc_to(edge);
    }
    path += "Z\n";
  }
  return path;
}

void append_pair(std::string& out, int code, const std::string& value) {
  out += std::to_string(code) + "\n" + value + "\n";
}

void append_polyline(std::string& out, const contour::Contour& loop) {
  for (const auto& [code, value] : {std::pair{0, "POLYLINE"}, {8, "PROFILE"}, {66, "1"}, {70, "1"}})
    append_pair(out, code, value);
  for (const contour::Vertex& vertex : loop.vertices) {
    append_pair(out, 0, "VERTEX");
    append_pair(out, 8, "PROFILE");
    append_pair(out, 10, number_text(tidy(vertex.point.u)));
    append_pair(out, 20, number_text(tidy(vertex.point.v)));
    if (vertex.bulge != 0) append_pair(out, 42, number_text(vertex.bulge));
  }
  append_pair(out, 0, "SEQEND");
  append_pair(out, 8, "PROFILE");
}

}  // namespace

std::string profile_csv(const contour::Region& region, ProfileOf of) {
  const double scale = of == ProfileOf::lathe ? 2 : 1;
  std::string out = of == ProfileOf::lathe ? "z,x,bulge\n" : "x,y,bulge\n";
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    if (i > 0) out += "\n";
    for (const contour::Vertex& vertex : region.loops[i].vertices) {
      out += pair(vertex.point.u, scale * vertex.point.v, ",") + "," + number_text(vertex.bulge) +
             "\n";
    }
  }
  return out;
}

std::string profile_svg(const contour::Region& region, ProfileOf of) {
  constexpr double kMargin_mm = 2;
  contour::Box box = contour::extents(region);
  if (box.is_empty()) box = {{0, 0}, {0, 0}};
  if (of == ProfileOf::lathe) box.low.v = 0;
  const std::string size =
      pair(box.high.u - box.low.u + 2 * kMargin_mm, box.high.v - box.low.v + 2 * kMargin_mm, " ");
  const std::string width = size.substr(0, size.find(' '));
  const std::string height = size.substr(size.find(' ') + 1);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "mm\" height=\"" + height +
         "mm\" viewBox=\"" + pair(box.low.u - kMargin_mm, -box.high.v - kMargin_mm, " ") + " " +
         size + "\">\n";
  out +=
      "<path fill=\"#dfe6ee\" stroke=\"#222222\" stroke-width=\"1\" "
      "vector-effect=\"non-scaling-stroke\" d=\"" +
      path_of(region) + "\"/>\n</svg>\n";
  return out;
}

std::string profile_dxf(const contour::Region& region) {
  std::string out;
  for (const auto& [code, value] : {std::pair{0, "SECTION"},
                                    {2, "HEADER"},
                                    {9, "$ACADVER"},
                                    {1, "AC1009"},
                                    {9, "$INSUNITS"},
                                    {70, "4"},
                                    {0, "ENDSEC"},
                                    {0, "SECTION"},
                                    {2, "ENTITIES"}})
    append_pair(out, code, value);
  for (const contour::Contour& loop : region.loops) append_polyline(out, loop);
  append_pair(out, 0, "ENDSEC");
  append_pair(out, 0, "EOF");
  return out;
}

}  // namespace kerf::output
