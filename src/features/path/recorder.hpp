#pragma once

#include <array>
#include <optional>

#include "features/path/recording.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::features {

/// Makes a recording of the motions of a run. Tools are the caller's to add.
class Recorder final : public motion::MotionSink {
 public:
  /// Both must outlive the recorder. When the recording has so many bytes it is full, and goes on
  /// no more; 0: never.
  Recorder(const motion::AxisSetup& axes, ModeSource& modes, std::size_t most_bytes = 0);

  void take(const motion::Motion& motion) override;
  [[nodiscard]] const Recording& recording() const { return recording_; }
  [[nodiscard]] Recording& recording() { return recording_; }

 private:
  void move(const motion::Rapid& rapid);
  void move(const motion::Line& line);
  void move(const motion::Arc& arc);
  void move(const motion::SpaceArc& arc);
  void move(const motion::SurfaceMove& move);
  void move(const motion::Probe& probe);
  void move(const motion::Thread& thread);
  void note(const motion::ToolChange& change);
  void note(const motion::Spindle& spindle);

  void look(const base::TipPoint& to);
  void straight(Move::Kind kind, const base::TipPoint& to);
  void add(Move row, const base::TipPoint& to);
  void add_other(double length, const base::TipPoint& to, std::uint32_t rows);
  void set_feed(const motion::Feed& feed);
  [[nodiscard]] std::uint32_t setup_at(const Modes& modes, const base::TipPoint& at);
  [[nodiscard]] Vec3 in_setup(const base::TipPoint& tip) const;
  [[nodiscard]] bool turns_rotary(const base::TipPoint& to) const;
  [[nodiscard]] base::AxisVector rotary_of(const base::TipPoint& at) const;

  const motion::AxisSetup& axes_;
  ModeSource& modes_;
  std::size_t most_bytes_;
  std::array<std::optional<base::Axis>, 3> xyz_;
  Recording recording_;
  base::TipPoint at_;
  State state_;
  bool is_state_new_ = true;
  Modes known_;  // those that state_ was made of
  bool knows_modes_ = false;
  base::BlockId block_;
  std::uint32_t rows_ = 0;  // of RowCsv so far
};

}  // namespace kerf::features
