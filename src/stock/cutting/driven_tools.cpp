#include "stock/cutting/driven_tools.hpp"

#include <algorithm>

namespace kerf::stock {
namespace {

bool is_described(const CuttingTool& tool) {
  return tool.tool.source != ToolSource::assumed && tool.tool.source != ToolSource::offset;
}

std::optional<Driven> by_plane(std::optional<motion::Plane> plane) {
  if (plane == motion::Plane::xy) return Driven::face;
  if (plane == motion::Plane::yz) return Driven::side;
  return {};
}

}  // namespace

DrivenTools::DrivenTools(const motion::AxisSetup& axes, ToolRack& rack, double centre_mm)
    : axes_(axes), rack_(rack), centre_mm_(centre_mm), spindles_(axes, true), at_(axes.start) {}

void DrivenTools::look(const motion::Motion& motion, std::optional<motion::Plane> plane) {
  if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    spindles_.take(*spindle);
  } else if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    tool_ = change->tool;
  } else if (const base::TipPoint* const to = motion::target_of(motion)) {
    spindles_.move(at_, *to);
    if (motion::is_cut_at_feed(motion) && is_driven(motion, *to)) note(motion, *to, plane);
    at_ = *to;
  }
}

bool DrivenTools::turns_work(const base::TipPoint& to) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (axes_.axes[i].rotary && to[axis] != at_[axis]) return true;
  }
  return false;
}

bool DrivenTools::is_driven(const motion::Motion& motion, const base::TipPoint& to) {
  const CuttingTool& tool = rack_.tool(tool_);
  const bool is_said = is_described(tool);
  if (is_said && tool.tool.is_insert()) return false;
  if (spindles_.drive_tool()) return true;
  if (spindles_.turning(Spindles::Of::work) != Turning::stopped) return false;
  const bool is_on_surface = std::holds_alternative<motion::SurfaceMove>(motion.action);
  return is_said || is_on_surface || turns_work(to);
}

void DrivenTools::note(const motion::Motion& motion, const base::TipPoint& to,
                       std::optional<motion::Plane> plane) {
  if (!first_) first_ = motion.block;
  Signs& signs = signs_[tool_];
  signs.said = rack_.tool(tool_).tool.driven;
  if (const auto* const move = std::get_if<motion::SurfaceMove>(&motion.action)) {
    const bool is_face = move->surface.kind == motion::Surface::Kind::face;
    signs.surfaces.add(is_face ? Driven::face : Driven::side);
  } else if (const auto by = by_plane(plane)) {
    signs.planes.add(*by);
  }
  note_way(signs, to);
}

double DrivenTools::way(const base::TipPoint& to, char letter) const {
  const auto axis = axes_.find(letter);
  return axis ? to[*axis] - at_[*axis] : 0;
}

void DrivenTools::note_way(Signs& signs, const base::TipPoint& to) const {
  const double x = way(to, 'X');
  const double z = way(to, 'Z');
  const auto x_axis = axes_.find('X');
  if (signs.x_sign == 0 && x_axis) signs.x_sign = at_[*x_axis] < centre_mm_ ? -1 : 1;
  const bool is_aside = turns_work(to) || way(to, 'Y') != 0;
  if (is_aside || (x == 0) == (z == 0)) {
    signs.along_other = signs.along_other || is_aside || x != 0;
    return;
  }
  const Driven along = z != 0 ? Driven::face : Driven::side;
  if (signs.first_z == 0) signs.first_z = z;
  signs.ways.add(along);
  signs.first = signs.first.value_or(along);
}

DrivenTool DrivenTools::tool_of(const Signs& signs) {
  const auto shown = signs.surfaces.one() ? signs.surfaces.one() : signs.planes.one();
  const auto by_way = signs.ways.one() ? signs.ways.one() : signs.first;
  const Driven stands = signs.said.value_or(shown.value_or(by_way.value_or(Driven::face)));
  DrivenTool tool;
  tool.is_guess = !signs.said && !shown && !signs.ways.one();
  tool.is_axial = !signs.along_other && signs.ways.one() == stands;
  if (stands == Driven::side) {
    tool.axis = {signs.x_sign < 0 ? -1.0 : 1.0, 0, 0};
  } else if (tool.is_axial && signs.first_z > 0) {
    tool.axis = {0, 0, -1};  // on the other side of what it cuts
  }
  return tool;
}

std::map<std::uint32_t, DrivenTool> DrivenTools::tools() const {
  std::map<std::uint32_t, DrivenTool> tools;
  for (const auto& [number, signs] : signs_) tools.emplace(number, tool_of(signs));
  return tools;
}

}  // namespace kerf::stock
