#pragma once

#include "stock/dexel/lattice.hpp"
#include "stock/dexel/passage.hpp"

namespace kerf::stock::dexel {

/// What Passage::may_meet() says of four lines at once, with floats. It says no, and yes, only
/// where that does, by a margin for all that floats round: so it costs a fraction and changes
/// nothing.
class Glance {
 public:
  using Four = float __attribute__((vector_size(16)));
  static constexpr int kLines = 4;

  /// The lines that it is asked for, from the middle of the stock.
  struct Lines {
    int axis = 2;
    double step_b = 0;  ///< from one of four to the next
    Bounds box;         ///< holds what is asked of them: the axes are s, b, c
  };

  Glance(const Passage& passage, Vec3 tip, const Lines& lines);

  /// Bit i is that of line i.
  struct Answer {
    unsigned may = 0;     ///< something of the stretch may be met
    unsigned surely = 0;  ///< Passage::may_meet() says so, too
  };
  /// Four lines at b, b + step_b ... and c, and on each a stretch, as offset() counts.
  [[nodiscard]] Answer may_meet(double b, double c, Four low, Four high) const;
  /// The same, and how deep: the least value that the form of the solid may have there, of all
  /// four.
  struct Depths {
    unsigned may = 0;
    float least = 0;
  };
  [[nodiscard]] Depths depths(double b, double c, Four low, Four high) const;
  /// Of places on four lines, as may_meet() counts; not below a limit, or not above it.
  [[nodiscard]] Four offsets(Four s, float limit, bool is_low) const;
  /// Of a place on a line, as may_meet() counts.
  [[nodiscard]] float offset(double s) const { return static_cast<float>(s - tip_s_); }

 private:
  struct Three {
    float x, y, z;
  };
  struct Spans;
  struct At;
  struct Behind {
    bool is_asked = false;
    bool is_clear = false;  ///< what is behind is so on the whole of a line, or along the planes
    bool is_whole = false;
    Three ahead{};
    float start = 0;
    float along = 0;
    float per_along = 0;
    float error = 0;
    float low = 0;
    float high = 0;
  };
  [[nodiscard]] static Three three(Vec3 v);
  void note_behind(const Passage& passage, double reach);
  void cut_by_planes(const At& at, Spans& spans) const;
  void cut_behind(const At& at, Spans& spans) const;
  struct Seen;
  [[nodiscard]] Seen seen(double b, double c, Four low, Four high) const;
  [[nodiscard]] Four least(const At& at, const Spans& spans) const;
  [[nodiscard]] Four least_at(const At& at, const Spans& spans, Four t) const;
  [[nodiscard]] unsigned surely(const At& at, Four s, Four value) const;

  double tip_s_ = 0, tip_b_ = 0, tip_c_ = 0;
  Four steps_{};
  bool is_blind_ = false;  ///< may meet everything
  bool is_short_ = false;  ///< it hardly matters where on its way the solid is
  bool is_sure_ = false;
  Three next_{}, after_{}, along_{}, way_{};
  float bend_ = 0, slope_ = 0, square_ = 0;
  float ss_ = 0, st_ = 0, tt_ = 0, per_ss_ = 0, per_tt_ = 0, per_left_ = 0;
  float most_ = 0;  ///< of the form, for what may be 0
  enum class Planes : std::uint8_t { none, across, level };
  Planes planes_ = Planes::none;
  float low_ = 0, high_ = 0;  ///< of the solid
  float error_ = 0;           ///< of a place
  float per_up_ = 0, slide_low_ = 0, slide_high_ = 0;
  float per_rise_ = 0;
  Behind behind_;
};

}  // namespace kerf::stock::dexel
