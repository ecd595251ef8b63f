#pragma once

#include <span>
#include <vector>

#include "stock/tool/profile.hpp"

namespace kerf::stock::field {

/// Higher than any stock: no material is met. Within the range of a float.
inline constexpr float kNowhere = 1e30F;

/// A piece of a lower envelope over s in [s0, s1], mm: rising and convex, so that what it leaves
/// behind along a straight way has one lowest place. Below s0 it counts as level: its value there
/// is never below the envelope's.
struct EnvelopePiece {
  enum class Kind {
    face,  ///< z
    cone,  ///< z + slope (s - s0)
    arc,  ///< z - √(radius² - (s - core)²): the lower outer quarter of a circle about (core, z)
  };
  Kind kind = Kind::face;
  double s0 = 0;
  double s1 = 0;
  double z = 0;
  double slope = 0;
  double core = 0;
  double radius = 0;

  [[nodiscard]] double at(double s) const;  ///< s <= s1
};

/// f(s): the lowest height of a body of revolution over its tip at the distance s from its axis,
/// that is the lowest height at which its radius is s or more. Rises with s; none beyond reach().
class LowerEnvelope {
 public:
  LowerEnvelope() = default;  ///< of nothing
  /// Of the edges of one part. Concave arcs become chords that leave them by at most `within` mm.
  LowerEnvelope(const Profile& profile, ToolPart part, double within);

  /// The body made smaller by `by` mm on all sides: moved inwards and upwards, which is by no more
  /// than √2 times that across an oblique face.
  [[nodiscard]] LowerEnvelope shrunk(double by) const;
  /// The part of it within this distance from the axis.
  [[nodiscard]] LowerEnvelope within(double reach) const;

  [[nodiscard]] bool is_empty() const { return pieces_.empty(); }
  [[nodiscard]] std::span<const EnvelopePiece> pieces() const { return pieces_; }
  /// Largest s; of nothing -1.
  [[nodiscard]] double reach() const { return pieces_.empty() ? -1 : pieces_.back().s1; }
  /// f(0); kNowhere of nothing.
  [[nodiscard]] double lowest() const { return at(0); }
  /// f(s), for s < 0 as for 0; kNowhere beyond reach().
  [[nodiscard]] double at(double s) const;

  /// All of it is a face of the radius `core` (or none) and one arc about (core, z), or the face
  /// alone (radius 0): mills that are flat, bull-nosed, or balls.
  struct Round {
    double core = 0;
    double radius = 0;
    double z = 0;
  };
  [[nodiscard]] const Round* round() const { return is_round_ ? &round_ : nullptr; }

 private:
  void add(const ProfileEdge& edge, double within);
  void add_cone(ProfilePoint from, ProfilePoint to);
  void add_arc(const ProfileEdge& edge, double within);
  void see_round();

  std::vector<EnvelopePiece> pieces_;  // by rising s, without gaps
  bool is_round_ = false;
  Round round_;
};

}  // namespace kerf::stock::field
