#include "stock/dexel/run_work.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace kerf::stock::dexel {
namespace {

// Nodes of fewer strokes are not looked at from afar.
constexpr std::size_t kFewStrokes = 8;
// Cuts that end nearer to each other are both made, in their order: ten times what is no material,
// and some steps of floats far from the middle.
constexpr double kMargin_mm = 1e-4;
constexpr double kMarginOfSize = 1e-6;

std::vector<const Stroke*> strokes_of(std::span<const RunWork::Step> steps) {
  std::vector<const Stroke*> strokes;
  for (const RunWork::Step& step : steps) strokes.push_back(step.stroke);
  return strokes;
}

Bounds widened(const Bounds& box, double by) {
  return {box.low - Vec3{by, by, by}, box.high + Vec3{by, by, by}};
}

}  // namespace

RunWork::RunWork(const TilePlace& place, Tile& tile, const PosedTool& posed,
                 std::span<const Step> steps)
    : place_(place), tile_(tile), posed_(posed), steps_(steps), strokes_(strokes_of(steps)) {
  edges_ = trees(posed.solids, true);
  others_ = trees(posed.touching, false);
}

std::vector<RunWork::Tree> RunWork::trees(const std::vector<PosedSolid>& solids, bool edges) const {
  std::vector<Tree> all;
  for (const PosedSolid& solid : solids) {
    if ((solid.solid.part == ToolPart::edge) != edges) continue;
    const std::size_t size = strokes_.size();
    all.push_back({&solid, std::vector<const Sight*>(size), std::vector<const Sight*>(size),
                   std::vector<std::uint16_t>(steps_.size()), 1});
  }
  return all;
}

Passage RunWork::passage(const Solid& solid, std::size_t node) const {
  const StrokeTree::Node& at = strokes_.node(node);
  return {at.off_mm > 0 ? grown(solid, at.off_mm) : solid, posed_.frame, at.chord.from,
          at.chord.way, place_.lattice.axis};
}

RunWork::Sight RunWork::sight(const PosedSolid& posed, const Passage& passage, std::size_t node,
                              int dexels_apart) const {
  const StrokeTree::Node& at = strokes_.node(node);
  const Bounds reach = widened(posed.reach, at.off_mm);
  const TileWindow window(place_, tile_, swept(reach, at.chord.from, at.chord.way));
  const double grown = at.off_mm * (2 * posed.solid.widest() + at.off_mm);
  return {window.rows(),
          window.is_empty() ? CellRange{} : window.columns(),
          window.low(),
          window.high(),
          static_cast<float>(grown),
          Glance(passage, at.chord.from, window.lines(posed.margin, dexels_apart)),
          nullptr};
}

const RunWork::Sight* RunWork::add_near(const PosedSolid& posed, std::size_t node) {
  Passage passage = this->passage(posed.solid, node);
  if (strokes_.is_stroke(node) && steps_[strokes_.stroke(node)].follows) passage.follow(0);
  Sight& added = sights_.emplace_back(sight(posed, passage, node, 1));
  if (strokes_.is_stroke(node)) added.passage = &passages_.emplace_back(passage);
  return &added;
}

const RunWork::Sight& RunWork::near(Tree& tree, std::size_t node) {
  if (tree.near[node] == nullptr) tree.near[node] = add_near(*tree.solid, node);
  return *tree.near[node];
}

const RunWork::Sight& RunWork::far(Tree& tree, std::size_t node) {
  if (tree.far[node] == nullptr) {
    tree.far[node] = &sights_.emplace_back(
        sight(*tree.solid, passage(tree.solid->around, node), node, Tile::kBlock));
  }
  return *tree.far[node];
}

/// Which of four blocks may be met: bits.
unsigned RunWork::active(Tree& tree, std::size_t node, int column, int row) {
  if (strokes_.node(node).strokes == 0) return 0;
  const Sight& sight = far(tree, node);
  if (!sight.reaches(column, row, Glance::kLines * Tile::kBlock, Tile::kBlock)) return 0;
  const unsigned may = TileWindow::at_blocks(place_, tile_, sight.glance, column, row,
                                             tile_.parts(double{sight.low}, double{sight.high}));
  if (may == 0 || strokes_.node(node).strokes <= kFewStrokes) return may;
  const unsigned first = active(tree, 2 * node, column, row);
  return (may & ~first) == 0 ? first : first | active(tree, 2 * node + 1, column, row);
}

RunWork::Window RunWork::window(std::vector<Tree>& trees) {
  Window all;
  for (Tree& tree : trees) {
    const Sight& one = near(tree, 1);
    if (one.rows.first > one.rows.last || one.columns.first > one.columns.last) continue;
    if (all.rows.first > all.rows.last) all = {one.rows, one.columns, {one.low, one.high}};
    all.rows = {std::min(all.rows.first, one.rows.first), std::max(all.rows.last, one.rows.last)};
    all.columns = {std::min(all.columns.first, one.columns.first),
                   std::max(all.columns.last, one.columns.last)};
    all.along = {std::min(all.along.low, one.low), std::max(all.along.high, one.high)};
  }
  return all;
}

/// visit(column, row) for blocks that may be met.
template <class Visit>
void RunWork::each_block(std::vector<Tree>& trees, const Window& window, Visit&& visit) {
  constexpr int kFour = Glance::kLines * Tile::kBlock;
  const auto [rows, columns, along] = window;
  for (int row = rows.first / Tile::kBlock * Tile::kBlock; row <= rows.last; row += Tile::kBlock) {
    for (int four = columns.first / kFour * kFour; four <= columns.last; four += kFour) {
      unsigned met = 0;
      for (Tree& tree : trees) met |= met == 15U ? 0 : active(tree, 1, four, row);
      for (int i = 0; i < Glance::kLines && four + i * Tile::kBlock < tile_.columns(); ++i) {
        if ((met >> static_cast<unsigned>(i) & 1U) != 0) visit(four + i * Tile::kBlock, row);
      }
    }
  }
}

RunWork::Row RunWork::row_at(int column, int row, Tile::Stretch along) const {
  const double margin = kMargin_mm + kMarginOfSize * place_.lattice.half_s;
  return {column, row, place_.b_of(column), place_.c_of(row),
          UncutRest(tile_, column, row, along, static_cast<float>(margin))};
}

RunWork::Depth RunWork::depth(Tree& tree, std::size_t node, const Row& row) {
  if (strokes_.node(node).strokes == 0) return {};
  const Sight& sight = near(tree, node);
  if (!sight.reaches(row.column, row.row, Glance::kLines, 1)) return {};
  Depth depth;
  for (std::size_t k = 0; k < row.rest.layers(); ++k) {
    const Glance::Depths here =
        sight.glance.depths(row.b, row.c, sight.glance.offsets(row.rest.low(k), sight.low, true),
                            sight.glance.offsets(row.rest.high(k), sight.high, false));
    depth.met |= here.may;
    depth.least = std::min(depth.least, here.least);
  }
  depth.least += sight.grown;
  return depth;
}

/// found(node, dexel, low, high) for strokes that meet something which is left; it may shorten
/// that. First is looked where a stroke was found before, then more and more far from there.
template <class Found>
void RunWork::search(Tree& tree, Row& row, Found&& found) {
  const auto look_at = [&](std::size_t node) {
    const Depth here = depth(tree, node, row);
    if (here.met != 0) search(tree, node, here.met, row, found);
  };
  std::size_t node = tree.guess;
  look_at(node);
  for (; node > 1; node /= 2) look_at(node ^ 1U);
}

/// The same of a node whose glance has met some of four dexels.
template <class Found>
void RunWork::search(Tree& tree, std::size_t node, unsigned met, Row& row, Found&& found) {
  if (strokes_.is_stroke(node)) {
    meet(tree, node, met, row, found);
    return;
  }
  std::size_t first = 2 * node;
  std::size_t last = first + 1;
  Depth deep = depth(tree, first, row);
  Depth other = depth(tree, last, row);
  if (other.least < deep.least) {
    std::swap(first, last);
    std::swap(deep, other);
  }
  const unsigned before = row.changes;
  if (deep.met != 0) search(tree, first, deep.met, row, found);
  if (other.met != 0 && row.changes != before) other = depth(tree, last, row);
  if (other.met != 0) search(tree, last, other.met, row, found);
}

template <class Found>
void RunWork::meet(Tree& tree, std::size_t node, unsigned met, Row& row, Found&& found) {
  const Sight& sight = *tree.near[node];
  for (int i = 0; i < Glance::kLines; ++i) {
    const int column = row.column + i;
    if ((met >> static_cast<unsigned>(i) & 1U) == 0 || column < sight.columns.first ||
        column > sight.columns.last) {
      continue;
    }
    const Passage::Line line = sight.passage->line(place_.b_of(column), row.c);
    const auto may_meet = [&](double low, double high) {
      return sight.passage->may_meet(line, low, high);
    };
    Meeting m;
    const auto dexel = static_cast<std::size_t>(i);
    if (row.rest.has_piece(dexel, may_meet) && sight.passage->meet(line, m)) {
      found(node, dexel, static_cast<float>(m.low.along), static_cast<float>(m.high.along));
    }
  }
}

bool RunWork::may_collide() {
  bool met = false;
  const Window all = window(others_);
  each_block(others_, all, [&](int column, int row) {
    for (int r = row; r < std::min(row + Tile::kBlock, tile_.rows()) && !met; ++r) {
      Row four = row_at(column, r, all.along);
      if (four.rest.layers() == 0) continue;
      for (Tree& tree : others_) {
        search(tree, four, [&](std::size_t, std::size_t i, float low, float high) {
          met |= four.rest.reaches(i, low, high);
        });
      }
    }
  });
  return met;
}

void RunWork::cut(LateNormals& normals) {
  normals.reserve(edges_.size() * steps_.size());
  const Window all = window(edges_);
  each_block(edges_, all, [&](int column, int row) { cut_block(column, row, all, normals); });
}

void RunWork::cut_block(int column, int row, const Window& window, LateNormals& normals) {
  bool changed = false;
  for (int r = row; r < std::min(row + Tile::kBlock, tile_.rows()); ++r) {
    Row four = row_at(column, r, window.along);
    if (four.rest.layers() == 0) continue;
    cuts_.clear();
    for (std::size_t t = 0; t < edges_.size(); ++t) {
      search(edges_[t], four, [&](std::size_t node, std::size_t i, float low, float high) {
        if (!four.rest.reaches(i, low, high)) return;
        cuts_.push_back({i, strokes_.stroke(node), t, low, high});
        four.rest.take_away(i, low, high);
        ++four.changes;
        edges_[t].guess = node;
      });
    }
    changed |= cut_row(four, normals);
  }
  if (!changed) return;
  tile_.mark_changed();
  tile_.refresh_block(column, row);
}

/// As if stroke by stroke, and of each the solids upwards.
bool RunWork::cut_row(const Row& row, LateNormals& normals) {
  std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
    return std::tie(a.dexel, a.stroke, a.tree) < std::tie(b.dexel, b.stroke, b.tree);
  });
  bool changed = false;
  for (const Cut& cut : cuts_) {
    const std::uint32_t motion = steps_[cut.stroke].motion;
    const auto end = [&](float at) { return DexelEnd{at, {}, cut_of(cut, row, normals), motion}; };
    const std::size_t dexel = tile_.index(row.column + static_cast<int>(cut.dexel), row.row);
    changed |= tile_.subtract(dexel, cut.low, cut.high, end, end) > 0;
  }
  return changed;
}

std::uint16_t RunWork::cut_of(const Cut& cut, const Row& row, LateNormals& normals) {
  std::uint16_t& number = edges_[cut.tree].cuts[cut.stroke];
  if (number == 0) {
    number = normals.begin(posed_.frame, *edges_[cut.tree].solid, *steps_[cut.stroke].stroke);
  }
  normals.note(row.column, row.row);
  return number;
}

}  // namespace kerf::stock::dexel
