#include "drawing/dxf/internal/bulges.hpp"
#include "drawing/dxf/internal/kinds.hpp"

namespace kerf::drawing::dxf {

void draw_bulges(const std::vector<BulgeVertex>& vertices, bool is_closed, Pen& pen) {
  if (vertices.empty()) return;
  pen.begin(vertices.front().at);
  double bulge = vertices.front().bulge;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (vertices[i].at != pen.at()) pen.bulge_to(vertices[i].at, bulge);
    bulge = vertices[i].bulge;
  }
  if (!is_closed || vertices.size() == 1) return pen.end();
  if (pen.at() != vertices.front().at) pen.bulge_to(vertices.front().at, bulge);
  pen.close();
}

void draw_lwpolyline(Subject& subject) {
  constexpr int kClosed = 1;
  const Record& record = subject.record();
  std::vector<BulgeVertex> vertices;
  for (const Group& group : record.from(10)) {
    if (group.code == 10)
      vertices.push_back({{group.number, 0}});
    else if (group.code == 20)
      vertices.back().at.v = group.number;
    else if (group.code == 42)
      vertices.back().bulge = group.number;
  }
  if (vertices.empty()) return subject.refuse("has no vertices (group 10)");
  Pen pen(subject.canvas(), subject.entity(), subject.to_mm());
  draw_bulges(vertices, record.flag(70, kClosed), pen);
}

}  // namespace kerf::drawing::dxf
