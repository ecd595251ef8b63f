#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "stock/dexel/passage.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::dexel {

/// Tip and axis at both ends of a turning way, in the frame of the dexels.
struct TurnEnds {
  Vec3 from;
  Vec3 to;
  Vec3 from_axis;
  Vec3 to_axis;
};

/// A solid that turns while it goes. It is halved in time until each part is as good as one that
/// goes straight in its mean direction. On the way there a dexel is told what the solid surely
/// passes over (a smaller solid, straight), and is done where even a larger one meets nothing: only
/// near the surface of the sweep is a turn divided to its end.
///
///   whole way      |--------------------|      surely: the solid shrunk by L dphi / 2
///   halves         |---------|----------|      ... by L dphi / 4
///   ...                                        until that is within the tolerance
class Turn {
 public:
  /// One part of the way.
  struct Step {
    Passage exact;                  ///< in its mean direction
    Passage grown;                  ///< holds all that the solid passes over
    std::optional<Passage> shrunk;  ///< all of it is passed over
    bool is_last;
  };

  Turn(const Solid& solid, const TurnEnds& ends, int axis, double tolerance_mm);

  /// Holds all of it, from the tip's way.
  [[nodiscard]] const Bounds& reach() const { return reach_; }
  /// Step 1 is the whole way, 2 n and 2 n + 1 are the halves of n.
  [[nodiscard]] const Step& step(std::size_t number);

  /// Calls pass(meeting, passage) with what the solid passes over, and goes on dividing as long as
  /// meets(meeting) says that there is something to meet in a larger piece.
  template <class Meets, class Pass>
  void over(double b, double c, Meets&& meets, Pass&& pass, std::size_t number = 1) {
    const Step& now = step(number);
    Meeting m;
    if (now.is_last) {
      if (now.exact.meet(b, c, m)) pass(m, now.exact);
      return;
    }
    Meeting around;
    if (!now.grown.meet(b, c, around) || !meets(around)) return;
    if (now.shrunk && now.shrunk->meet(b, c, m)) pass(m, *now.shrunk);
    if (!meets(around)) return;
    over(b, c, meets, pass, 2 * number);
    over(b, c, meets, pass, 2 * number + 1);
  }

 private:
  [[nodiscard]] std::unique_ptr<Step> make(std::size_t number) const;
  [[nodiscard]] Vec3 axis_at(double t) const;
  [[nodiscard]] Vec3 middle_at(double t) const;

  Solid solid_;
  TurnEnds ends_;
  int axis_;
  double tolerance_;
  double angle_;
  Bounds reach_;
  std::vector<std::unique_ptr<Step>> steps_;
};

}  // namespace kerf::stock::dexel
