#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "machine/definition/machine_definition.hpp"
#include "motion/axis_point.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "motion/spindle_set.hpp"
#include "output/picture/drawing/space.hpp"
#include "output/picture/tip_in_space.hpp"

namespace kerf::output {

/// What a segment of the picture is; the numbers of the binary chunk.
enum class SegmentKind : std::uint8_t { rapid = 0, cut = 1, dwell = 2, thread = 3, probe = 4 };

/// What a path amounts to so far.
struct PathTotals {
  std::uint64_t motions = 0;  ///< all that were taken, moves or not
  std::uint64_t vertices = 0;
  double time_s = 0;  ///< at the last vertex
  std::array<double, 3> low{}, high{};
};

/// The path of a run as vertices of a picture, in binary chunks (docs/panel-protocol.md), with the
/// times at which the axes really are there.
///
/// Takes the motions of a run and its set-points. Lines and the legs of rapids end in a vertex; an
/// arc is cut into chords that leave it by at most kChordError_mm. A vertex gets its time from the
/// two set-points around it, in proportion to the way, so the speed of a segment is the one that
/// was reached. Rounded corners keep the programmed point.
///
/// Bounded memory: one chunk, and the motions between control and servo.
class PathChunks : public motion::MotionSink, public motion::AxisPointSink {
 public:
  static constexpr std::size_t kMostVertices = 65'536;  ///< of a chunk
  static constexpr double kChordError_mm = 0.01;

  enum class Source : std::uint16_t { preview = 0, live_trace = 1 };
  using Emit = std::function<void(std::string chunk)>;

  /// `run` is written into every chunk.
  PathChunks(const machine::MachineDefinition& machine, Source source, std::uint32_t run,
             Emit emit);

  void take(const motion::Motion& motion) override;
  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;

  /// Emits what there is, if it is at least one segment.
  void flush();
  /// The run is over and all that was taken is made: the rest goes out.
  void finish();
  /// The run broke off: what the servo has not made is no part of the path.
  void abandon();

  [[nodiscard]] PathTotals totals() const;

 private:
  // What a vertex says besides where and when.
  struct Attributes {
    std::uint64_t number = 0;  // of the motion
    std::uint32_t line = 0;
    std::uint16_t file = 0;
    SegmentKind kind = SegmentKind::cut;
    std::uint8_t tool = 0;
    std::uint8_t power_percent = 0;
    float feed_mm_min = 0;
  };
  // A curve that is cut into chords.
  struct Chords {
    motion::Curve curve;
    std::uint32_t count = 1;
  };
  // A move between control and servo. Curves are kept only of what has more than one vertex.
  struct Move {
    Attributes attributes;
    base::TipPoint end;
    std::vector<Chords> curves{};
  };
  // A vertex that the tool has passed since the last set-point.
  struct Passed {
    base::TipPoint at;
    double way = 0;  // from the last set-point
    Attributes attributes;
  };
  struct Arrays {
    std::vector<float> xyz, time_s, feed_mm_min, speed_mm_min, rotary;
    std::vector<std::uint32_t> motion, line;
    std::vector<std::uint16_t> file;
    std::vector<std::uint8_t> kind, tool, power_percent;

    void clear();
    [[nodiscard]] std::size_t count() const { return time_s.size(); }
  };

  void add_move(const motion::Motion& motion, const base::TipPoint& to);
  [[nodiscard]] std::uint32_t chords_of(const motion::Curve& curve) const;
  void add_dwell(const motion::Motion& motion, double seconds);
  [[nodiscard]] Attributes attributes_of(const motion::Motion& motion, SegmentKind kind) const;
  void pass_motions_before(std::uint64_t number, double time_s);
  void pass_vertices_of_current(const motion::AxisPoint& point);
  void pass(const base::TipPoint& at, double time_s);
  [[nodiscard]] bool next_vertex_of_front(base::TipPoint& at) const;
  void advance_front();
  void place_passed(const base::TipPoint& at, double time_s);
  void add_vertex(const base::TipPoint& at, double time_s, const Attributes& attributes);
  void begin_chunk();
  void append(const base::TipPoint& at, double time_s, double speed_mm_min,
              const Attributes& attributes);
  [[nodiscard]] double distance(const base::TipPoint& from, const base::TipPoint& to) const;
  [[nodiscard]] std::string header() const;

  const motion::AxisSetup axes_;
  motion::AxisNorms norms_;
  plot::TipInSpace space_;
  std::vector<std::size_t> rotary_axes_;  // at most two
  Source source_;
  std::uint32_t run_;
  Emit emit_;
  motion::MoveCurves curves_;

  // Of the motions.
  base::TipPoint commanded_;
  std::uint64_t motions_ = 0;
  motion::SpindleSet spindles_;
  double power_percent_ = 0;
  std::uint32_t tool_ = 0;
  std::deque<Move> moves_;

  // Of the first of them: the next vertex of it.
  std::size_t curve_ = 0;
  std::uint32_t chord_ = 0;

  // Of the set-points.
  base::TipPoint reached_;
  double reached_s_ = 0;
  double way_ = 0;  // of the set-points from the last vertex
  std::vector<Passed> passed_;

  // Of the vertices.
  Arrays arrays_;
  base::TipPoint last_;
  double last_s_ = 0;
  double last_speed_ = 0;
  Attributes last_attributes_;
  double time_base_s_ = 0;
  std::uint32_t chunk_ = 0;
  std::uint64_t vertices_ = 0;
  plot::Point3 drawn_{};
  plot::Box3 bounds_;
};

}  // namespace kerf::output
