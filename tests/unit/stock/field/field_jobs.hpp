#pragma once

#include <vector>

#include "stock/field/height_field.hpp"

namespace kerf::stock::field {

// Tools: diameters, included angles in degrees; edges up to `flutes`, nothing above.
[[nodiscard]] Body flat(double diameter, double flutes = 100);
[[nodiscard]] Body ball(double diameter, double flutes = 100);
[[nodiscard]] Body bull(double diameter, double corner, double flutes = 100);
[[nodiscard]] Body cone(double diameter, double angle_deg, double tip_diameter,
                        double flutes = 100);
/// A tool with a further part above it, from its end up: a cylinder of this diameter.
[[nodiscard]] Body with(Body body, ToolPart part, double diameter, double height);

/// Moves of one tool over one stock, as a program would make them.
class Job {
 public:
  Job(const Bounds& box, double cell_mm, const Body& body, unsigned jobs = 1);

  /// Where the next move begins.
  Job& at(Vec3 place);
  Job& to(Vec3 place);
  Job& rapid(Vec3 place);
  /// Round a centre from where the tool is, counterclockwise > 0, by `rise` up.
  Job& turn(Vec3 centre, double turn_rad, double rise = 0, double radius_change = 0);
  Job& with_tool(const Body& body);

  [[nodiscard]] HeightField& field() { return field_; }
  [[nodiscard]] const Outcome& last() const { return outcomes_.back(); }
  [[nodiscard]] const std::vector<Sweep>& sweeps() const { return sweeps_; }
  /// Sums over all moves.
  [[nodiscard]] double removed() const;
  [[nodiscard]] bool met_nothing() const;

 private:
  Job& make(const Way& way, SweepKind kind);

  HeightField field_;
  BodyId body_;
  Vec3 place_;
  std::vector<Sweep> sweeps_;
  std::vector<Outcome> outcomes_;
};

/// A way round a centre in the level plane.
[[nodiscard]] ArcWay around(Vec3 centre, Vec3 from, double turn_rad, double rise = 0,
                            double radius_change = 0);

}  // namespace kerf::stock::field
