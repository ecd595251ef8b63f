#pragma once

#include <functional>
#include <vector>

#include "machine/definition/machine_definition.hpp"
#include "motion/move_curves.hpp"
#include "training/cut.hpp"

namespace kerf::training {

/// Cuts are kept in pieces of at most this length.
inline constexpr double kPiece_mm = 0.2;

/// Keeps where a run cuts and where it goes at rapid (cut.hpp).
class CutRecorder : public motion::MotionSink {
 public:
  /// What cuts: a beam where it is on; a mill at feed wherever it is in the work, whose top is Z0;
  /// a turning tool at feed wherever it is in the bar, whose face is Z0.
  enum class Process : std::uint8_t { beam, milling, turning };
  struct Work {
    Process process{};
    geometry::Vec3 zero;    ///< on the machine
    double bar_radius = 0;  ///< mm, of what is turned
  };

  /// Behind `most_mm` of moves at feed nothing
  /// is kept any more, and `full` is called once. The machine must outlive the recorder.
  CutRecorder(const machine::MachineDefinition& machine, const Work& work, double most_mm,
              std::function<void()> full);

  void take(const motion::Motion& motion) override;

  [[nodiscard]] const std::vector<Cut>& cuts() const { return cuts_; }
  [[nodiscard]] const std::vector<Stroke>& strokes() const { return strokes_; }
  /// Of all cuts, mm.
  [[nodiscard]] double length() const { return length_mm_; }
  /// Of all moves at feed, in the air as well.
  [[nodiscard]] double fed() const { return fed_mm_; }
  [[nodiscard]] bool is_full() const { return fed_mm_ > most_mm_; }

 private:
  void move(const motion::Motion& motion);
  void feed_along(const motion::Curve& curve, const base::TipPoint& from,
                  const motion::Motion& motion);
  [[nodiscard]] bool cuts(geometry::Vec3 from, geometry::Vec3 to) const;
  [[nodiscard]] geometry::Vec3 in_work(const base::TipPoint& at) const;

  Work work_;
  double most_mm_;
  std::function<void()> full_;
  motion::MoveCurves curves_;
  std::array<std::size_t, 3> linear_{};
  std::vector<std::size_t> rotary_;
  base::TipPoint at_;
  CutWith with_;
  std::vector<Cut> cuts_;
  std::vector<Stroke> strokes_;
  double length_mm_ = 0;
  double fed_mm_ = 0;
};

}  // namespace kerf::training
