#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "output/picture/internal/path_recorder.hpp"
#include "output/picture/tool_table.hpp"

namespace kerf::output::plot {

/// A thread as its deepest pass: from end to end along the roots, z and x in mm.
struct ThreadCut {
  Point3 from{}, to{};
  double lead = 0;  ///< mm, along Z
};

/// What a tool of a lathe is, as far as its motions and the control's table say so.
struct TurningTool {
  std::uint32_t number = 0;
  control::Nose nose;
  double radius = 0;    ///< of a drill; 0: not known
  bool driven = false;  ///< the spindle stands as an axis: the tool turns
};

/// Takes what the half section of a lathe needs beside the path: noses, driven tools, threads, and
/// the path of driven tools on the part as it is seen along Z from its face, the first rotary axis
/// at 0. Bounded memory.
class TurningRecorder {
 public:
  static constexpr std::size_t kMostThreads = 64;

  TurningRecorder(const motion::AxisSetup& axes, const ToolTable& table);

  /// Behind `recorded`, which has taken the motion; `from` is where it stood before.
  void take(const motion::Motion& motion, const PathRecorder& recorded, const Point3& from);

  [[nodiscard]] const TurningTool& tool(std::uint32_t number) const;
  [[nodiscard]] const std::vector<ThreadCut>& threads() const { return threads_; }
  /// X, Y, Z of the part, by the tools of the machine; nothing was cut while the spindle stood.
  [[nodiscard]] const PathRecorder& face() const { return face_; }

 private:
  TurningTool& at_work(std::uint32_t number);
  void thread(const motion::Thread& thread, const Point3& from, const Point3& to);
  void on_part(const motion::Motion& motion, const base::TipPoint& from, const TurningTool& tool);
  void way(const base::TipPoint& from, const base::TipPoint& to, bool cuts);
  void go(const base::TipPoint& to, bool cuts);
  void keep(const motion::Motion& motion, TurningTool& tool);
  [[nodiscard]] base::TipPoint place(const base::TipPoint& tip) const;

  // A move of a tool of which it is not known yet whether it is driven.
  struct Early {
    motion::Motion motion;
    base::TipPoint from;
  };

  motion::AxisSetup axes_;
  ToolTable table_;
  std::optional<base::Axis> x_, z_, rotary_;
  base::TipPoint tip_;
  bool threading_ = false;
  std::vector<Early> early_;
  std::vector<TurningTool> tools_;
  std::vector<ThreadCut> threads_;
  std::unique_ptr<const motion::AxisSetup> space_;  // of the part: X Y Z
  PathRecorder face_;
};

}  // namespace kerf::output::plot
