#pragma once

#include <vector>

#include "stock/sweep/sweep.hpp"

namespace kerf::stock::dexel {

/// A straight piece of the way of a tip.
struct Stroke {
  Vec3 from;
  Vec3 way;
};

/// Appends the pieces of a way, moved by -`origin`: one of a straight or turning way; chords of an
/// arc whose ends lie on it and that are nowhere further than `tolerance_mm` from it (or a million
/// of them, if that is coarser).
void append_strokes(const Way& way, Vec3 origin, double tolerance_mm, std::vector<Stroke>& out);

}  // namespace kerf::stock::dexel
