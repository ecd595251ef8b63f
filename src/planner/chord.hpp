#pragma once

// How far the straight way between two set-points leaves a curve of radius R, and how fast the tip
// may go so that it does not leave it by more than a deviation δ. A step counts in two ways:
//
//   chord  the straight distance between the two points:   δ = R - √(R² - chord² / 4)
//   step   along the curve, as an interpolator that goes on by step / R counts:
//                                                          δ = R (1 - cos (step / 2R))
//
// Of equal numbers the step leaves the curve less, so a limit for chords is safe for steps. Radii,
// deviations and periods are > 0. Where R <= δ nothing can leave the curve by more: no limit,
// infinity.
//
// With δ = 0.001 mm and a period of 8 ms the feed limit of chords is F = √(225000 (2R - 0.001))
// mm/min, R in mm. The form 225000 (2R - 1) that is found in print takes its 1 in micrometres:
// safe, but 29 % too low at R = 1 mm, and at R <= 0.5 mm it forbids every motion.

namespace kerf::planner {

/// 0 <= chord <= 2R.
[[nodiscard]] double chord_deviation_mm(double radius_mm, double chord_mm);
/// 0 <= step <= 2πR.
[[nodiscard]] double step_deviation_mm(double radius_mm, double step_mm);

[[nodiscard]] double longest_chord_mm(double radius_mm, double deviation_mm);
[[nodiscard]] double longest_step_mm(double radius_mm, double deviation_mm);

/// Largest feed for set-points that are chords, and for those that are steps, apart.
[[nodiscard]] double chord_feed_mm_s(double radius_mm, double deviation_mm, double period_s);
[[nodiscard]] double step_feed_mm_s(double radius_mm, double deviation_mm, double period_s);

}  // namespace kerf::planner
