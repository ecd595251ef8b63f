#include "stock/surface/internal/cell_cycles.hpp"

#include <numeric>

namespace kerf::stock::surface {
namespace {

/// Edges and corners of a face in a row around it; edge i leads from corner i to the next.
struct FaceRing {
  std::array<int, 4> corners{};
  std::array<int, 4> edges{};
};

FaceRing ring_of(int face) {
  const int axis = face / 2;
  const int side = face % 2;
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  constexpr std::array<std::array<int, 2>, 4> kRound{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  FaceRing ring;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<int, 3> at{};
    at[static_cast<std::size_t>(axis)] = side;
    at[static_cast<std::size_t>(b)] = kRound[i][0];
    at[static_cast<std::size_t>(c)] = kRound[i][1];
    ring.corners[i] = corner_number(at);
  }
  // Along b the next axes are c and `axis`, along c they are `axis` and b.
  ring.edges = {edge_number(b, 0, side), edge_number(c, side, 1), edge_number(b, 1, side),
                edge_number(c, side, 0)};
  return ring;
}

bool is_inside(std::uint8_t form, int corner) { return ((form >> corner) & 1) != 0; }

class Lines {
 public:
  Lines() { std::iota(parent_.begin(), parent_.end(), std::uint8_t{0}); }
  [[nodiscard]] std::uint8_t root(int edge) const {
    auto at = static_cast<std::uint8_t>(edge);
    while (parent_[at] != at) at = parent_[at];
    return at;
  }
  void join(int a, int b) {
    const std::uint8_t one = root(a);
    const std::uint8_t other = root(b);
    parent_[one > other ? one : other] = one > other ? other : one;
  }

 private:
  std::array<std::uint8_t, kCellEdges> parent_{};
};

int crossed_edges(std::uint8_t form, const FaceRing& ring) {
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    count += is_inside(form, ring.corners[i]) != is_inside(form, ring.corners[(i + 1) % 4]) ? 1 : 0;
  }
  return count;
}

void join_across(std::uint8_t form, const FaceRing& ring, bool is_turned, Lines& lines) {
  const int count = crossed_edges(form, ring);
  if (count == 2) {
    int first = -1;
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_inside(form, ring.corners[i]) == is_inside(form, ring.corners[(i + 1) % 4])) continue;
      if (first >= 0) lines.join(first, ring.edges[i]);
      first = ring.edges[i];
    }
  } else if (count == 4) {
    // Around the corners that stand alone: edges before and behind each.
    const std::size_t alone = is_inside(form, ring.corners[0]) != is_turned ? 0 : 1;
    lines.join(ring.edges[(alone + 3) % 4], ring.edges[alone]);
    lines.join(ring.edges[alone + 1], ring.edges[alone + 2]);
  }
}

}  // namespace

CellCycles make_cycles(std::uint8_t form, std::uint8_t turned) {
  Lines lines;
  for (int face = 0; face < kCellFaces; ++face) {
    join_across(form, ring_of(face), ((turned >> face) & 1) != 0, lines);
  }
  CellCycles cycles;
  std::array<std::uint8_t, kCellEdges> number{};
  number.fill(CellCycles::kNone);
  cycles.of_edge.fill(CellCycles::kNone);
  for (int edge = 0; edge < kCellEdges; ++edge) {
    const int from = corner_number(edge_begin(edge));
    const int to = from + (1 << (edge / 4));
    if (is_inside(form, from) == is_inside(form, to)) continue;
    std::uint8_t& line = number[lines.root(edge)];
    if (line == CellCycles::kNone) line = cycles.count++;
    cycles.of_edge[static_cast<std::size_t>(edge)] = line;
  }
  for (int face = 0; face < kCellFaces; ++face) {
    const FaceRing ring = ring_of(face);
    if (crossed_edges(form, ring) < 4) continue;
    const auto line = [&](std::size_t i) {
      return cycles.of_edge[static_cast<std::size_t>(ring.edges[i])];
    };
    if (line(0) == line(1) && line(1) == line(2) && line(2) == line(3)) {
      cycles.doubled = static_cast<std::uint8_t>(cycles.doubled | (1U << face));
    }
  }
  return cycles;
}

const CellCycles& cycles_of(std::uint8_t form) {
  static const std::array<CellCycles, 256> kTable = [] {
    std::array<CellCycles, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = make_cycles(static_cast<std::uint8_t>(i), 0);
    }
    return table;
  }();
  return kTable[form];
}

}  // namespace kerf::stock::surface
