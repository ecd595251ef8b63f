#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "machine/definition/drive_settings.hpp"
#include "motion/axis_point.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "output/picture/tool_table.hpp"

namespace kerf::output {

namespace plot {
class PathRecorder;
class CutRecorder;
class EnergyOfCut;
class TurningRecorder;
struct DisplayList;
}  // namespace plot

/// What the colour of a cut means: its tool, or how fast it was really made.
enum class PlotColors : std::uint8_t { tools, speeds };

/// The picture of a tool path: one sheet with an isometric view, the view from above with ruled
/// axes, the holes, the extents and a legend of the tools. A machine without a Y axis gets one view
/// instead, Z to the right and X upward, and a lathe, whose X is a diameter, a half section: the
/// path above the axis of rotation, below it what its cuts have left of the part (TurnedProfile),
/// inserts in the shape that the tools' ways and noses tell, and, where the spindle was an axis,
/// the face.
///
/// Coloured by tools it needs the motions alone; coloured by speeds it shows how fast the tool went
/// as the set-points have it, and those are its way where it cuts. Coloured by energies likewise,
/// where the beam is on.
///
/// Takes motions in order, from where the axes start. Memory and the size of the picture are
/// bounded however long the program is (SVG: about 2 MB at most): a path of more than some ten
/// thousand corners is simplified as it comes, finer than the picture shows unless the path is a
/// tangle. Axes other than X, Y and Z are not drawn. Coordinates that are not finite are ignored,
/// those beyond 1e9 mm are drawn there.
///
/// The same motions give the same bytes.
class PathPlot : public motion::MotionSink, public motion::AxisPointSink {
 public:
  /// `title` is UTF-8; what is not is shown as '?'. Of a lathe the noses are those that `tools`
  /// says while they are at work.
  PathPlot(const motion::AxisSetup& axes, std::string title, PlotColors colors = PlotColors::tools,
           const ToolTable& tools = {});
  /// Coloured by the energies of this laser. Precondition: it is fitted.
  PathPlot(const motion::AxisSetup& axes, std::string title, const machine::LaserSettings& laser);
  ~PathPlot() override;
  PathPlot(const PathPlot&) = delete;
  PathPlot& operator=(const PathPlot&) = delete;

  void take(const motion::Motion& motion) override;
  /// A place on the way of a rapid that is about to be taken and is no straight line.
  void travel_through(const base::TipPoint& place);
  /// Precondition: not coloured by tools.
  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;

  /// For people, coloured by energies: the largest and its line, the median, and the sum, where the
  /// beam rested too; indented lines, or nothing.
  [[nodiscard]] std::string remark() const;
  /// The same as a JSON object; empty where energies are not drawn.
  [[nodiscard]] std::string energy_json() const;
  /// The whole SVG document of what was taken so far.
  [[nodiscard]] std::string svg() const;
  /// The whole PNG file of what was taken so far. Text is set in DejaVu Sans.
  [[nodiscard]] std::string png() const;

 private:
  [[nodiscard]] plot::DisplayList sheet() const;

  std::unique_ptr<plot::PathRecorder> recorder_;
  std::unique_ptr<plot::TurningRecorder> turning_;  // of a lathe
  std::unique_ptr<plot::CutRecorder> cuts_;         // null: coloured by tools
  const plot::EnergyOfCut* energy_ = nullptr;
  std::string title_;
};

}  // namespace kerf::output
