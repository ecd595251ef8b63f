#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "base/output_file.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/motion.hpp"
#include "motion/motion_extent.hpp"
#include "output/programs/internal/arc_blocks.hpp"
#include "output/programs/internal/lost_things.hpp"
#include "output/programs/internal/move_blocks.hpp"
#include "output/programs/internal/surface_blocks.hpp"
#include "output/programs/post_writer.hpp"

namespace kerf::output {

/// Writes the executed path of a lathe as plain G-code of system A: no variables, no cycles, no
/// nose compensation, the tip in machine coordinates, X as a diameter, arcs with I and K, feeds per
/// minute and per revolution as they were (G98, G99), threads as G32 and G34, constant surface
/// speed as G96 with G50 S, moves on the face and on the mantle between G12.1 and G13.1 or G7.1. T
/// brings the offset that it brought in the run: coordinates leave it out, so the control's table
/// must be that of the run (decision 80).
///
/// The machine may stand anywhere when the program begins: before the spindle turns and the first
/// move X goes out alone to the largest diameter of all rapids, then Z to their largest, then the
/// others. What plain G-code cannot say is a comment with its source line. Nothing is in the file
/// before finish().
class LathePost final : public PostWriter {
 public:
  /// Machine and file must outlive this. `program` as people call it.
  LathePost(const machine::MachineDefinition& machine, std::string program, base::OutputFile& file,
            const PostSettings& settings = {});
  void take(const motion::Motion& motion) override;

  // PostWriter
  void comment(const std::string& text, std::uint32_t line) override { body_.comment(line, text); }
  void frequency(double hz, std::uint32_t line) override;
  void finish() override;
  [[nodiscard]] std::uint64_t lost() const override { return lost_.count(); }
  [[nodiscard]] std::string remark() const override { return lost_.remark(); }
  [[nodiscard]] std::string json() const override;
  [[nodiscard]] std::string tools() const override { return {}; }

 private:
  void act(const motion::Rapid& rapid);
  void act(const motion::Line& line) { moves_.straight(line.to, line.feed); }
  void act(const motion::Arc& arc) { arcs_.write(arc); }
  void act(const motion::SpaceArc& arc) { arcs_.write(arc); }
  void act(const motion::SurfaceMove& move);
  void act(const motion::Dwell& dwell);
  void act(const motion::ToolChange& change);
  void act(const motion::Spindle& spindle);
  void act(const motion::Coolant& coolant);
  void act(const motion::Power& power);
  void act(const motion::Probe& probe);
  void act(const motion::Thread& thread) { moves_.thread(thread); }
  void act(const motion::AuxiliaryCode& code);
  void act(const motion::Stop& stop) { block(stop.optional ? "M1" : "M0"); }
  void act(const motion::Message& message);
  void act(const motion::End& end);

  void move(const motion::Motion& motion);
  void begin();
  void reach(const base::TipPoint& corner);
  void bring_tool();
  void in_chords(const motion::SurfaceMove& move);
  void turn(const motion::Spindle& spindle);
  void block(std::string_view text) { body_.block(text); }
  void lose(const std::string& what, const std::string& text);

  const machine::MachineDefinition& machine_;
  const motion::AxisSetup& axes_;
  std::string program_;
  base::OutputFile& file_;
  const PostFlavour& flavour_;
  PostBody body_;  // the blocks behind the head
  MoveBlocks moves_;
  ArcBlocks arcs_;
  SurfaceBlocks surfaces_;
  LostThings lost_;
  base::TipPoint tip_;                     // of the run
  std::optional<base::TipPoint> corner_;   // where every axis is brought first
  std::optional<std::uint64_t> place_at_;  // byte of the body where that is done
  std::optional<motion::MotionExtent> travel_;
  motion::ToolLength length_;
  std::uint32_t tool_ = 0;
  std::pair<std::uint32_t, std::uint32_t> brought_{};  // tool and offset, in the file
  std::uint32_t source_line_ = 0;
  bool turns_ = false;
  bool css_ = false;
  bool fixed_ = false;
  bool ended_ = false;
};

}  // namespace kerf::output
