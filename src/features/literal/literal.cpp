#include "features/literal/literal.hpp"

#include <algorithm>
#include <cmath>

#include "features/literal/circle_test.hpp"
#include "features/literal/left_inside.hpp"
#include "features/literal/loops.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;

bool is_level(const Recording& recording, std::uint32_t row) {
  return std::fabs(recording.moves[row].to.z - recording.from(row).z) <= kSameZ_mm;
}

/// Collects the rows of a layer while Z stays.
class LayerFinder {
 public:
  explicit LayerFinder(const Recording& recording) : recording_(recording) {}

  void follow(std::uint32_t row) {
    const Move& move = recording_.moves[row];
    const State& state = recording_.state_of(move);
    if (!rows_.empty() && (!is_level(recording_, row) || state.tool != tool_)) end();
    if (!move.cuts() || !is_level(recording_, row) || !recording_.goes_across(row)) return;
    tool_ = state.tool;
    rows_.push_back(row);
  }

  std::vector<LiteralLayer> done() {
    if (!rows_.empty()) end();
    return std::move(layers_);
  }

 private:
  void end() {
    layers_.push_back({.rows = {rows_.front(), rows_.back()},
                       .z = recording_.moves[rows_.front()].to.z,
                       .tool = tool_,
                       .loops = loops_of(recording_, rows_).loops});
    rows_.clear();
  }

  const Recording& recording_;
  std::vector<std::uint32_t> rows_;
  std::uint32_t tool_ = 0;
  std::vector<LiteralLayer> layers_;
};

std::vector<LiteralLayer> layers_of(const Recording& recording) {
  LayerFinder finder(recording);
  for (std::uint32_t row = 0; row < recording.count(); ++row) finder.follow(row);
  return finder.done();
}

// A plunge between two rapids.
bool is_plunge(const Recording& recording, std::uint32_t row) {
  if (row == 0 || row + 1 >= recording.count()) return false;
  const Move& move = recording.moves[row];
  return move.kind == Move::Kind::feed && move.shape == Move::Shape::line &&
         recording.moves[row - 1].kind == Move::Kind::rapid &&
         recording.moves[row + 1].kind == Move::Kind::rapid && !recording.goes_across(row) &&
         move.to.z < recording.from(row).z - kSameZ_mm;
}

// Pecks are one hole: consecutive plunges of one tool at one place.
std::vector<LiteralHole> holes_of(const Recording& recording) {
  std::vector<LiteralHole> holes;
  for (std::uint32_t row = 0; row < recording.count(); ++row) {
    if (!is_plunge(recording, row)) continue;
    const Move& move = recording.moves[row];
    const std::uint32_t tool = recording.state_of(move).tool;
    const Vec2 at = recording.flat(move.to);
    const bool is_peck = !holes.empty() && holes.back().tool == tool &&
                         geometry::length(holes.back().at - at) <= kSamePoint_mm;
    if (!is_peck) {
      holes.push_back({at, move.to.z, tool, row});
    } else if (move.to.z < holes.back().z) {
      holes.back().z = move.to.z;
      holes.back().row = row;
    }
  }
  return holes;
}

bool are_same(const Recording& recording, const Loop& a, const Loop& b) {
  if (std::fabs(a.perimeter - b.perimeter) > kSamePoint_mm) return false;
  const Contour first = recording.contour_of(a.rows);
  const Contour second = recording.contour_of(b.rows);
  return std::equal(first.vertices.begin(), first.vertices.end(), second.vertices.begin(),
                    second.vertices.end(), [](const auto& v, const auto& w) {
                      return geometry::length(v.point - w.point) <= kSamePoint_mm &&
                             std::fabs(v.bulge - w.bulge) <= kSamePoint_mm;
                    });
}

bool are_same(const Recording& recording, const LiteralLayer& a, const LiteralLayer& b) {
  return a.tool == b.tool &&
         std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(),
                    [&](const Loop& x, const Loop& y) { return are_same(recording, x, y); });
}

Order order_of(const std::vector<Loop>& loops) {
  const double difference = loops.back().perimeter - loops.front().perimeter;
  if (std::fabs(difference) <= kSamePoint_mm) return Order::undefined;
  return difference > 0 ? Order::inside_out : Order::outside_in;
}

// What is inside the smallest loop is cut where the tool's radius reaches all of it; of a circle
// smaller than the tool the offset alone would not say so.
LiteralWord word_of_loops(const Recording& recording, const std::vector<Loop>& loops,
                          double radius) {
  const auto smallest = std::min_element(
      loops.begin(), loops.end(),
      [](const Loop& a, const Loop& b) { return std::fabs(a.area) < std::fabs(b.area); });
  const Contour contour = recording.contour_of(smallest->rows);
  const auto circle = circle_of(contour);
  if (circle && circle->radius <= radius + kSamePoint_mm) return {LiteralWord::Type::pocket, 2};
  if (is_left_inside(contour, radius)) return {LiteralWord::Type::side_milling, 0};
  return {LiteralWord::Type::pocket, 1};
}

std::vector<LiteralFeature> features_of(const Recording& recording,
                                        const std::vector<LiteralLayer>& layers,
                                        Allowance& allowance) {
  std::vector<LiteralFeature> features;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LiteralLayer& layer = layers[i];
    if (allowance.is_over()) break;
    if (layer.loops.empty()) continue;
    const bool goes_on = !features.empty() && features.back().layers.back() + 1 == i &&
                         are_same(recording, layers[features.back().layers.front()], layer);
    if (!goes_on) {
      const double radius = recording.diameter_of(layer.tool) / 2;
      features.push_back(
          {{}, word_of_loops(recording, layer.loops, radius), order_of(layer.loops)});
    }
    features.back().layers.push_back(i);
  }
  return features;
}

}  // namespace

LiteralTree recognise_literally(const Recording& recording, Allowance& allowance) {
  LiteralTree tree;
  tree.layers = layers_of(recording);
  tree.features = features_of(recording, tree.layers, allowance);
  tree.holes = holes_of(recording);
  return tree;
}

}  // namespace kerf::features
