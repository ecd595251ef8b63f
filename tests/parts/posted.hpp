#pragma once

#include <cstdint>
#include <string>

#include "geometry/vec2.hpp"

namespace kerf::parts {

using geometry::Vec2;

/// How a program is written.
struct TextStyle {
  bool has_numbers = false;     ///< N words
  bool has_blanks = true;       ///< between words
  bool repeats_g = true;        ///< in each block
  bool is_incremental = false;  ///< G91 for moves at feed
  bool has_radius = false;      ///< R words, where an arc is not near to a half circle
  bool is_inch = false;
  Vec2 zero{};  ///< of G55, machine coordinates; (0, 0): G54 is used, and is there
};

/// Writes a program of a mill the way a post-processor does: moves in, text out. What was rounded
/// is where the next word begins, so that increments do not add up what was rounded away.
class Posted {
 public:
  explicit Posted(const TextStyle& style);

  void tool(int number, double rpm);
  void rapid(Vec2 to);
  void rapid_z(double z);
  void plunge(double z);
  void line(Vec2 to) { line(to, z_); }
  void line(Vec2 to, double z);
  /// About `centre`, counterclockwise or not; to where it is: a whole circle.
  void arc(Vec2 to, Vec2 centre, bool is_counterclockwise) {
    arc(to, z_, centre, is_counterclockwise);
  }
  void arc(Vec2 to, double z, Vec2 centre, bool is_counterclockwise);
  /// A drilling cycle at one place. `peck` 0: in one go.
  void drill(Vec2 at, double z, double peck);
  /// What is written until the end goes into a program of its own that a block here calls.
  void begin_subprogram();
  void end_subprogram();

  [[nodiscard]] Vec2 at() const { return at_; }
  /// How far a point is at most from where it was meant to be, arcs included.
  [[nodiscard]] double rounding_mm() const { return 1.5 * step_mm(); }
  [[nodiscard]] std::string text() const;

 private:
  void block(const std::string& words);
  [[nodiscard]] std::string word(char letter, double value) const;
  [[nodiscard]] std::string g(int number);
  [[nodiscard]] std::string targets(Vec2 to, double z, bool is_feed);
  void set_incremental(bool wanted);
  [[nodiscard]] double rounded(double value) const;
  [[nodiscard]] double step_mm() const { return style_.is_inch ? 25.4e-4 : 1e-3; }
  [[nodiscard]] Vec2 rounded(Vec2 at) const { return {rounded(at.u), rounded(at.v)}; }

  TextStyle style_;
  std::string main_;
  std::string subprograms_;
  std::string* out_ = &main_;
  int subprogram_ = 100;
  int number_ = 0;
  int g_ = -1;
  bool incremental_ = false;
  bool feed_is_said_ = false;
  Vec2 at_{};
  double z_ = 100;
};

}  // namespace kerf::parts
