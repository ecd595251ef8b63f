#include "stock/sheet/internal/piece_finder.hpp"

#include <algorithm>

namespace kerf::stock::sheet {
namespace {

enum Edge : std::size_t { kLowX, kHighX, kLowY, kHighY };

// So many pieces may wait until all but the largest are forgotten.
constexpr std::size_t kMostWaiting = 4 * Pieces::kMost;

bool comes_before(const auto& a, const auto& b) {
  return a.left != b.left ? a.left > b.left : a.first < b.first;
}

}  // namespace

PieceFinder::PieceFinder(const Sheet& sheet)
    : sheet_(sheet),
      grid_(sheet.grid()),
      tiles_x_(static_cast<std::size_t>(grid_.tiles_x())),
      of_untouched_(grid_.tiles(), kNone) {}

int PieceFinder::width(std::size_t tile) const {
  return std::min(kTileSide, grid_.nx - column(tile) * kTileSide);
}

int PieceFinder::height(std::size_t tile) const {
  return std::min(kTileSide, grid_.ny - row(tile) * kTileSide);
}

Pieces PieceFinder::find() {
  for (std::size_t tile = 0; tile < grid_.tiles(); ++tile) {
    if (const Sheet::Coverage* const cells = sheet_.coverage(tile)) {
      take_touched(tile, *cells);
    } else {
      take_untouched(tile);
    }
    join_behind(tile);
  }
  for (const Rest& rest : rests_) settle(rest);
  for (Node node = 0; node < parents_.size(); ++node) {
    if (root(node) == node) close(parts_[node]);
  }
  keep_largest();
  Pieces pieces;
  pieces.count = count_;
  for (const Part& part : closed_) {
    Piece piece;
    piece.area_mm2 = static_cast<double>(part.left) / 255 * grid_.cell_mm2();
    const Vec2 low = grid_.box.low;
    piece.extents.take(low + Vec2{part.i0 * grid_.cell_x(), part.j0 * grid_.cell_y()});
    piece.extents.take(low + Vec2{(part.i1 + 1) * grid_.cell_x(), (part.j1 + 1) * grid_.cell_y()});
    piece.is_held = part.is_held;
    piece.first_cell = part.first;
    pieces.largest.push_back(piece);
  }
  return pieces;
}

PieceFinder::Part PieceFinder::part_of(std::size_t tile, const TilePart& part) const {
  const int i = column(tile) * kTileSide;
  const int j = row(tile) * kTileSide;
  Part whole{.left = part.left,
             .i0 = i + part.i0,
             .i1 = i + part.i1,
             .j0 = j + part.j0,
             .j1 = j + part.j1};
  whole.first = static_cast<std::uint64_t>(j + part.first / kTileSide) *
                    static_cast<std::uint64_t>(grid_.nx) +
                static_cast<std::uint64_t>(i + part.first % kTileSide);
  whole.is_held =
      whole.i0 == 0 || whole.j0 == 0 || whole.i1 + 1 == grid_.nx || whole.j1 + 1 == grid_.ny;
  return whole;
}

PieceFinder::Node PieceFinder::add(const Part& part) {
  parents_.push_back(static_cast<Node>(parents_.size()));
  parts_.push_back(part);
  return parents_.back();
}

// Most of a large sheet is untouched: tiles beside each other share a node.
void PieceFinder::take_untouched(std::size_t tile) {
  const int nx = width(tile);
  const int ny = height(tile);
  TilePart all{.left = static_cast<std::uint64_t>(255 * nx * ny)};
  all.i0 = all.j0 = 0;
  all.i1 = nx - 1;
  all.j1 = ny - 1;
  const Part part = part_of(tile, all);
  const Node before = column(tile) > 0 ? of_untouched_[tile - 1] : kNone;
  const Node node = before != kNone ? before : add(part);
  of_untouched_[tile] = node;
  if (before != kNone) {
    Part& whole = parts_[root(node)];
    whole.left += part.left;
    whole.i1 = std::max(whole.i1, part.i1);
    whole.is_held = whole.is_held || part.is_held;
  }
}

void PieceFinder::take_touched(std::size_t tile, const Sheet::Coverage& cells) {
  const int nx = width(tile);
  const int ny = height(tile);
  const TileParts found(cells, nx, ny, sheet_.cut_from());
  std::vector<Node> nodes;
  std::vector<Part> whole;
  for (const TilePart& part : found.parts()) {
    whole.push_back(part_of(tile, part));
    nodes.push_back(part.is_closed ? kNone : add(whole.back()));
  }
  share_rests(tile, cells, found, nodes, whole);
  Edges& edges = edges_[tile];
  const auto node = [&](int i, int j) {
    const std::uint16_t part = found.at(j * kTileSide + i);
    return part == TileParts::kNone ? kNone : nodes[part];
  };
  for (int n = 0; n < kTileSide; ++n) {
    const auto place = static_cast<std::size_t>(n);
    edges[kLowX][place] = n < ny ? node(0, n) : kNone;
    edges[kHighX][place] = n < ny ? node(nx - 1, n) : kNone;
    edges[kLowY][place] = n < nx ? node(n, 0) : kNone;
    edges[kHighY][place] = n < nx ? node(n, ny - 1) : kNone;
  }
  for (std::size_t part = 0; part < whole.size(); ++part) {
    if (nodes[part] == kNone) close(whole[part]);
  }
}

void PieceFinder::share_rests(std::size_t tile, const Sheet::Coverage& cells,
                              const TileParts& parts, const std::vector<Node>& nodes,
                              std::vector<Part>& whole) {
  const int nx = width(tile);
  const int ny = height(tile);
  for (int cell = 0; cell < ny * kTileSide; ++cell) {
    const int i = cell % kTileSide;
    const int j = cell / kTileSide;
    const std::uint8_t covered = cells[static_cast<std::size_t>(cell)];
    if (i >= nx || covered == 255 || parts.at(cell) != TileParts::kNone) continue;
    const auto left = static_cast<std::uint8_t>(255 - covered);
    Rest rest{.tile = tile, .cell = cell, .left = left};
    std::uint16_t best = TileParts::kNone;
    const auto look = [&](bool is_there, int other) {
      if (!is_there || parts.at(other) == TileParts::kNone) return;
      const std::uint8_t of_other = cells[static_cast<std::size_t>(other)];
      if (best != TileParts::kNone && of_other >= rest.covered) return;
      rest.covered = of_other;
      best = parts.at(other);
    };
    look(i > 0, cell - 1);
    look(i + 1 < nx, cell + 1);
    look(j > 0, cell - kTileSide);
    look(j + 1 < ny, cell + kTileSide);
    const bool at_edge = i == 0 || j == 0 || i + 1 == nx || j + 1 == ny;
    if (best != TileParts::kNone) rest.node = nodes[best];
    if (best != TileParts::kNone && rest.node == kNone) {
      whole[best].left += left;
    } else if (at_edge) {
      rests_.push_back(rest);
    } else if (best != TileParts::kNone) {
      parts_[rest.node].left += left;
    }
  }
}

PieceFinder::Node PieceFinder::node_at(std::size_t tile, std::size_t edge, int place) const {
  if (of_untouched_[tile] != kNone) return of_untouched_[tile];
  return edges_.at(tile)[edge][static_cast<std::size_t>(place)];
}

void PieceFinder::join_behind(std::size_t tile) {
  if (column(tile) > 0) join(tile, tile - 1, kLowX, kHighX, height(tile));
  if (row(tile) > 0) join(tile, tile - tiles_x_, kLowY, kHighY, width(tile));
}

void PieceFinder::join(std::size_t tile, std::size_t other, std::size_t edge,
                       std::size_t edge_of_other, int length) {
  if (of_untouched_[tile] != kNone && of_untouched_[other] != kNone) {
    return unite(of_untouched_[tile], of_untouched_[other]);
  }
  for (int n = 0; n < length; ++n) {
    const Node a = node_at(tile, edge, n);
    const Node b = node_at(other, edge_of_other, n);
    if (a != kNone && b != kNone) unite(a, b);
  }
}

void PieceFinder::settle(Rest rest) {
  const int i = rest.cell % kTileSide;
  const int j = rest.cell / kTileSide;
  const auto look = [&](bool is_there, std::size_t tile, std::size_t edge, int place, int cell) {
    if (!is_there) return;
    const Node node = node_at(tile, edge, place);
    if (node == kNone) return;
    const Sheet::Coverage* const cells = sheet_.coverage(tile);
    const std::uint8_t covered = cells != nullptr ? (*cells)[static_cast<std::size_t>(cell)] : 0;
    if (rest.node != kNone && covered >= rest.covered) return;
    rest.covered = covered;
    rest.node = node;
  };
  constexpr int kLast = kTileSide - 1;
  const int column_here = column(rest.tile);
  const int row_here = row(rest.tile);
  look(i == 0 && column_here > 0, rest.tile - 1, kHighX, j, j * kTileSide + kLast);
  look(i == kLast && column_here + 1 < grid_.tiles_x(), rest.tile + 1, kLowX, j, j * kTileSide);
  look(j == 0 && row_here > 0, rest.tile - tiles_x_, kHighY, i, kLast * kTileSide + i);
  look(j == kLast && row_here + 1 < grid_.tiles_y(), rest.tile + tiles_x_, kLowY, i, i);
  if (rest.node != kNone) parts_[root(rest.node)].left += rest.left;
}

PieceFinder::Node PieceFinder::root(Node node) {
  while (parents_[node] != node) {
    parents_[node] = parents_[parents_[node]];
    node = parents_[node];
  }
  return node;
}

// The older node stays, so that what comes out does not depend on the order of joining.
void PieceFinder::unite(Node a, Node b) {
  a = root(a);
  b = root(b);
  if (a == b) return;
  if (b < a) std::swap(a, b);
  parents_[b] = a;
  Part& whole = parts_[a];
  const Part& part = parts_[b];
  whole.left += part.left;
  whole.first = std::min(whole.first, part.first);
  whole.i0 = std::min(whole.i0, part.i0);
  whole.i1 = std::max(whole.i1, part.i1);
  whole.j0 = std::min(whole.j0, part.j0);
  whole.j1 = std::max(whole.j1, part.j1);
  whole.is_held = whole.is_held || part.is_held;
}

void PieceFinder::close(const Part& part) {
  ++count_;
  closed_.push_back(part);
  if (closed_.size() >= kMostWaiting) keep_largest();
}

void PieceFinder::keep_largest() {
  std::sort(closed_.begin(), closed_.end(),
            [](const Part& a, const Part& b) { return comes_before(a, b); });
  if (closed_.size() > Pieces::kMost) closed_.resize(Pieces::kMost);
}

}  // namespace kerf::stock::sheet
