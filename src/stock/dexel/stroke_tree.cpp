#include "stock/dexel/stroke_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kerf::stock::dexel {
namespace {

constexpr double kRounding_mm = 1e-9;

double off_chord(const Stroke& chord, Vec3 place) {
  const Vec3 v = place - chord.from;
  const double square = dot(chord.way, chord.way);
  const double t = square > 0 ? std::clamp(dot(v, chord.way) / square, 0.0, 1.0) : 0.0;
  const Vec3 off = v - t * chord.way;
  return std::sqrt(dot(off, off));
}

Vec3 end_of(const Stroke& stroke) { return stroke.from + stroke.way; }

/// What is within its distance of a half's chord is within so much more of the whole one.
double off_chord(const Stroke& chord, const StrokeTree::Node& half) {
  return half.off_mm + kRounding_mm +
         std::max(off_chord(chord, half.chord.from), off_chord(chord, end_of(half.chord)));
}

StrokeTree::Node joined(const StrokeTree::Node& a, const StrokeTree::Node& b) {
  if (b.strokes == 0) return a;
  const Stroke chord{a.chord.from, end_of(b.chord) - a.chord.from};
  return {chord, std::max(off_chord(chord, a), off_chord(chord, b)), a.strokes + b.strokes};
}

}  // namespace

StrokeTree::StrokeTree(const std::vector<const Stroke*>& strokes)
    : leaves_(std::bit_ceil(strokes.size())), nodes_(2 * leaves_) {
  for (std::size_t i = 0; i < strokes.size(); ++i) nodes_[leaves_ + i] = {*strokes[i], 0, 1};
  for (std::size_t n = leaves_ - 1; n > 0; --n)
    nodes_[n] = joined(nodes_[2 * n], nodes_[2 * n + 1]);
}

}  // namespace kerf::stock::dexel
