#include "features/turning/chains.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using stock::ToolKind;

constexpr double kLongestInfeed_mm = 5;  // of a facing cut, along the axis

bool is_rapid(const Recording& recording, std::uint32_t row) {
  return recording.moves[row].kind == Move::Kind::rapid;
}

bool is_wide(ToolKind kind) {
  return kind == ToolKind::grooving || kind == ToolKind::parting || kind == ToolKind::face_grooving;
}

bool stays_on_axis(const Recording& recording, Span rows) {
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (std::fabs(recording.from(row).x) > kSamePoint_mm ||
        std::fabs(recording.moves[row].to.x) > kSamePoint_mm)
      return false;
  }
  return true;
}

bool moves_along(const Recording& recording, Span rows) {
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (recording.moves[row].shape == Move::Shape::arc) return true;
    if (std::fabs(recording.moves[row].to.z - recording.from(row).z) > kSamePoint_mm) return true;
  }
  return false;
}

// Fed in beside the face, then square across to the axis.
bool faces_behind_infeed(const Recording& recording, Span rows) {
  double infeed_mm = 0;
  bool is_across = false;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    const Vec3 way = recording.moves[row].to - recording.from(row);
    const bool goes_in = std::fabs(way.x) <= kSamePoint_mm && way.z <= 0;
    const bool goes_across =
        std::fabs(way.z) <= kSamePoint_mm &&
        std::fabs(recording.moves[row].to.x) < std::fabs(recording.from(row).x);
    if (recording.moves[row].shape != Move::Shape::line || !(goes_in || goes_across)) return false;
    if (goes_in && !goes_across && is_across) return false;
    if (goes_in && !goes_across) infeed_mm -= way.z;
    is_across = is_across || goes_across;
  }
  return is_across && infeed_mm <= kLongestInfeed_mm &&
         std::fabs(recording.moves[rows.last].to.x) <= kSamePoint_mm;
}

template <typename Holds>
bool any(const Recording& recording, Span rows, Holds&& holds) {
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (holds(recording.moves[row])) return true;
  }
  return false;
}

bool is_turned(const Recording& recording, std::uint32_t setup) {
  return !(recording.setups[setup].rotary == base::AxisVector{});
}

Chain::Kind kind_of(const Recording& recording, Span rows, const stock::Tool& tool) {
  const bool is_strange = any(recording, rows, [](const Move& move) {
    return move.kind == Move::Kind::probe || move.shape == Move::Shape::other;
  });
  if (is_strange) return Chain::Kind::other;
  if (any(recording, rows, [](const Move& move) { return move.kind == Move::Kind::thread; }))
    return tool.is_insert() ? Chain::Kind::thread : Chain::Kind::axial;
  if (!tool.is_insert() || stays_on_axis(recording, rows))
    return stays_on_axis(recording, rows) ? Chain::Kind::axial : Chain::Kind::other;
  if (is_wide(tool.kind)) return Chain::Kind::groove;
  if (faces_behind_infeed(recording, rows)) return Chain::Kind::across;
  return moves_along(recording, rows) ? Chain::Kind::along : Chain::Kind::across;
}

// On the other side of the axis it cuts the same.
void mirror(contour::Edge& edge) {
  edge.from.v = -edge.from.v;
  edge.to.v = -edge.to.v;
  edge.bulge = -edge.bulge;
}

}  // namespace

std::vector<Chain> chains_of(const Recording& recording, const Operation& operation,
                             const stock::Tool& tool) {
  std::vector<Chain> chains;
  const std::uint32_t end = operation.rows.last + 1;
  std::uint32_t approach = operation.rows.first;
  for (std::uint32_t row = operation.rows.first; row < end;) {
    if (is_rapid(recording, row)) {
      ++row;
      continue;
    }
    const std::uint32_t first = row;
    while (row < end && !is_rapid(recording, row)) ++row;
    Chain chain{.rows = {first, row - 1}, .visit = {approach, std::min(row, end - 1)}};
    chain.kind = is_turned(recording, operation.setup) ? Chain::Kind::other
                                                       : kind_of(recording, chain.rows, tool);
    chains.push_back(chain);
    approach = chain.visit.last + 1;
    row = std::max(row, approach);
  }
  return chains;
}

std::vector<contour::Edge> edges_of(const Recording& recording, Span rows) {
  std::vector<contour::Edge> edges;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) recording.append_edges(row, edges);
  contour::Box box;
  for (const contour::Edge& edge : edges) box.take(contour::extents(edge));
  if (box.low.v < -kSamePoint_mm && box.high.v <= kSamePoint_mm)
    std::for_each(edges.begin(), edges.end(), mirror);
  return edges;
}

}  // namespace kerf::features
