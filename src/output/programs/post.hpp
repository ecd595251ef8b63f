#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/motion.hpp"
#include "motion/motion_extent.hpp"
#include "output/programs/internal/arc_blocks.hpp"
#include "output/programs/internal/lost_things.hpp"
#include "output/programs/internal/move_blocks.hpp"
#include "output/programs/internal/tool_lengths.hpp"
#include "output/programs/post_writer.hpp"

namespace kerf::output {

/// Writes motions as G-code of a flavour (PostFlavour), mostly the path of a run for controllers
/// without macros: no variables, no cycles, no compensation, one tool centre path in machine
/// coordinates, mm and degrees (G21 G90 G94), arcs with I, J, K, numbers with a point, dwell in
/// seconds. Arcs in space that lie in XY, ZX or YZ while nothing else moves are arcs as well;
/// others are chords that leave them by at most kChordTolerance_mm, rounding of the coordinates
/// apart, and so are arcs whose radius changes by more than kRadiusTolerance_mm. Whole circles more
/// are full circles before their arc.
///
/// The machine may stand anywhere when the program begins: nothing turns or burns, and before that
/// and the first cut every axis is brought to where the path begins, Z first to the highest level
/// of all rapids (decision 40). Tool lengths are added to the coordinates of their axis, and told:
/// they are those of the machine's axes, not of the tip; where the flavour's controls have lengths
/// of their own, Z is that of the tip, and the first move of Z says which one. A rapid behind a
/// change of length goes up before it goes across, and down behind. The head of a linkage has its
/// own length, which is lost.
///
/// The beam of a laser is its M3 or M4 with S, and M5 - M4 where the power follows the speed, or
/// LaserSettings::post_beam says so; S is percent of full power times
/// LaserSettings::s_of_full_power. It is off in every rapid and at the end. What the flavour
/// cannot say - M codes of the machine, messages, that a move probes or cuts a thread, power on a
/// machine without a laser - is a comment with its source line.
///
/// The head tells what is known only behind the last motion: nothing is in the file before
/// finish().
class Post final : public PostWriter {
 public:
  static constexpr double kChordTolerance_mm = ArcBlocks::kChordTolerance_mm;
  static constexpr double kRadiusTolerance_mm = ArcBlocks::kRadiusTolerance_mm;

  /// Machine and file must outlive this. `program` as people call it.
  Post(const machine::MachineDefinition& machine, std::string program, base::OutputFile& file,
       const PostSettings& settings = {});
  void take(const motion::Motion& motion) override;

  // PostWriter
  void comment(const std::string& text, std::uint32_t line) override { body_.comment(line, text); }
  void frequency(double hz, std::uint32_t line) override;
  void finish() override;
  [[nodiscard]] std::uint64_t lost() const override { return lost_.count(); }
  [[nodiscard]] std::string remark() const override { return lost_.remark(); }
  [[nodiscard]] std::string json() const override;
  [[nodiscard]] std::string tools() const override { return lengths_.table(flavour_); }

 private:
  void act(const motion::Rapid& rapid);
  void act(const motion::Line& line);
  void act(const motion::Arc& arc);
  void act(const motion::SpaceArc& arc);
  void act(const motion::SurfaceMove& move);
  void act(const motion::Dwell& dwell);
  void act(const motion::ToolChange& change);
  void act(const motion::Spindle& spindle);
  void act(const motion::Coolant& coolant);
  void act(const motion::Power& power);
  void act(const motion::Probe& probe);
  void act(const motion::Thread& thread);
  void act(const motion::AuxiliaryCode& code);
  void act(const motion::Stop& stop);
  void act(const motion::Message& message);
  void act(const motion::End& end);

  void end_block();
  void block(std::string_view text) { body_.block(text); }
  void comment(const std::string& text) { body_.comment(source_line_, text); }
  void lose(const std::string& what, const std::string& text);
  [[nodiscard]] bool burns_now() const { return moves_.beam_on() && laser_.fitted(); }
  void tell_override(const motion::Motion& motion);

  void move(const motion::Motion& motion);
  void place(const base::TipPoint& first);
  void stand();
  void begin_place();
  void tell_axes(const base::TipPoint& to);
  void set_length(const motion::ToolLength& length);
  void tell_length(const std::string& where);
  [[nodiscard]] bool control_has(const motion::ToolLength& length) const;
  [[nodiscard]] ControlLength by_control(const motion::ToolLength& length) const;
  void bring_length(base::TipPoint corner);
  void settle_length();
  [[nodiscard]] base::TipPoint as_written(base::TipPoint point) const;
  void need(motion::MotionExtent extent);
  [[nodiscard]] base::TipPoint beyond_tip(base::TipPoint tip) const;
  [[nodiscard]] motion::Motion beyond_tip(const motion::Motion& motion) const;
  void travel(const base::TipPoint& to);

  const machine::MachineDefinition& machine_;
  const motion::AxisSetup& axes_;
  const machine::LaserSettings& laser_;
  std::string program_;
  base::OutputFile& file_;
  const PostFlavour& flavour_;
  base::AxisSet said_;  // axes that are written
  PostBody body_;       // the blocks behind the head
  BlockText block_;
  std::uint32_t source_line_ = 0;
  LostThings lost_;
  bool ended_ = false;

  MoveBlocks moves_;  // where the posted program stands, in its own coordinates
  ArcBlocks arcs_;
  base::TipPoint tip_;                     // of the run
  std::optional<base::TipPoint> first_;    // where every axis is brought first
  bool approaches_ = true;                 // nothing but rapids so far
  std::optional<std::uint64_t> place_at_;  // byte of the body where that is done
  double highest_mm_ = -std::numeric_limits<double>::infinity();  // level of the rapids
  std::optional<motion::MotionExtent> travel_;
  motion::ToolLength length_;
  double added_mm_ = 0;      // of it, where the axis stands beyond the tip
  double left_out_mm_ = 0;   // of that, in the coordinates of Z that are written
  double first_mm_ = 0;      // of that, where the path begins
  std::string first_words_;  // that bring its length
  ToolLengths lengths_;
  std::string told_length_;  // last comment about it
  bool has_lengths_ = false;
  std::uint32_t tool_ = 0;

  double s_ = -1;        // of the laser
  std::string turning_;  // the block that switched spindle or beam on; empty: off
  bool fixed_ = false;   // the last move had a feed without override
  bool css_ = false;     // G96 is on
};

}  // namespace kerf::output
