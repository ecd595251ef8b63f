#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "output/records/internal/tool_radii.hpp"

namespace kerf::output {

/// Writes motions as JSON Lines (docs/command-line.md): one object a line, in order. mm,
/// degrees, mm/min.
class MotionJson : public motion::MotionSink {
 public:
  /// `sources`: of the motions; those that are not of the first one, the main file, name theirs.
  /// Null: the motions are of one file. All must outlive this.
  struct Origin {
    /// What people call the program. The first record says it where that is not the name of the
    /// record's own program; empty: nobody knows.
    std::string title{};
    /// Whose radii of tools a program may change; null: there are none.
    const control::Memory* memory = nullptr;
  };
  MotionJson(const motion::AxisSetup& axes, const base::SourceSet* sources, base::OutputFile& file,
             Origin origin);
  MotionJson(const motion::AxisSetup& axes, const base::SourceSet* sources, base::OutputFile& file)
      : MotionJson(axes, sources, file, Origin{}) {}
  void take(const motion::Motion& motion) override;

 private:
  void name_file(base::FileId id);
  void name_source(base::ProgramNumber first);
  void begin(const char* kind, const motion::Motion& motion);
  void point(const char* name, const base::TipPoint& at);
  void target(const base::TipPoint& to) { point(",\"to\":{", to); }
  void spindle(const motion::Spindle& spindle);
  void space_arc(const motion::SpaceArc& arc);
  void centre(const motion::Arc& arc);
  [[nodiscard]] bool is_spiral(const motion::Arc& arc) const;
  void surface_arc(const motion::SurfaceMove& move);
  void surface(const motion::SurfaceMove& move);
  void thread(const motion::Thread& thread);
  void flag(bool on, const char* member) {
    if (on) line_ += member;
  }
  void length(const motion::ToolLength& length);
  void state(const motion::Motion& motion);
  void feed(const motion::Feed& feed);
  void write(const motion::Motion& motion);

  const motion::AxisSetup& axes_;
  const base::SourceSet* sources_;
  base::OutputFile& file_;
  base::TipPoint at_;
  motion::ToolLength length_;         // as the records have it
  std::optional<std::string> title_;  // that the first record is to say
  std::optional<ToolRadii> radii_;
  std::vector<std::string> keys_;  // per axis: what stands before its value
  std::string line_;
  std::string program_;  // text of the newest program number
  base::ProgramNumber program_number_{0xffffffffU};
  std::string source_;  // text of the newest file's name; none for the main file
  base::FileId source_id_ = base::kNoFile;
};

}  // namespace kerf::output
