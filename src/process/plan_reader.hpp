#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "base/point.hpp"
#include "motion/motion.hpp"
#include "process/plan.hpp"
#include "process/raster.hpp"
#include "process/wrapping.hpp"

namespace kerf::process {

/// A contour, a group of scan lines or a hole begins: a comment in every text.
struct PassBegins {
  std::size_t operation = 0;
  std::size_t copy = 0;
  std::uint32_t contour = kNoContour;
  drawing::EntityId entity = 0;
};

using Step = std::variant<PassBegins, motion::Motion>;

/// Makes the motions of a plan, a little at a time: never more than a contour or a scan line is
/// held. Both must outlive it.
class PlanReader {
 public:
  PlanReader(const Plan& plan, const drawing::Drawing& drawing);

  /// Appends what comes next; false: nothing comes any more. The last thing is motion::End.
  bool next(std::vector<Step>& steps);

 private:
  struct Cursor {
    std::size_t copy = 0;
    std::size_t operation = 0;
    std::uint32_t round = 0;  // of passes = N
    std::size_t turn = 0;
    std::size_t line = 0;  // of a scan
  };

  [[nodiscard]] const PlannedOperation& operation() const {
    return plan_.operations[cursor_.operation];
  }
  [[nodiscard]] std::uint32_t rounds() const;
  void advance();
  void advance_turn();
  void find_operation();
  void make(const Pass& pass, std::size_t entry);
  void make_way(const Way& way);
  [[nodiscard]] bool make_row(const Picture& picture);
  void make_scan_line(double run_up, const ScanLine& line);
  void make_spot(const Spot& spot);
  void finish();

  void rapid_to(Vec2 to);
  void travel_to(Vec2 to);
  void cut_wrapped(Vec2 to, double bulge);
  void rapid_z(double z);
  void line_to(Vec2 to);
  void leg_to(const Leg& leg);
  void beam(double share);
  void dwell(double seconds);
  void burn(double seconds);
  void emit(const motion::Motion::Action& action);
  void begin_operation();
  [[nodiscard]] double z_of_round() const;
  [[nodiscard]] double safe_z() const;
  [[nodiscard]] base::TipPoint point(Vec2 at) const;

  const Plan& plan_;
  const drawing::Drawing& drawing_;
  Cursor cursor_;
  std::vector<Step>* steps_ = nullptr;
  base::BlockId block_;
  base::TipPoint at_;
  Vec2 flat_;  // the same place in the drawing, where it is wrapped
  std::optional<Wrapping> wrapping_;
  bool is_on_surface_ = false;
  std::optional<Raster> raster_;  // of the picture under way
  ScanLine row_;
  std::optional<motion::Power> power_;
  double frequency_hz_ = 0;
  Air air_ = Air::off;
  bool moves_z_ = false;
  bool began_operation_ = false;
  bool has_ended_ = false;
};

}  // namespace kerf::process
