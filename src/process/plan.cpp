#include "process/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "motion/feed.hpp"
#include "process/along.hpp"
#include "process/layers.hpp"
#include "process/wrapped_surface.hpp"

namespace kerf::process {
namespace {

using drawing::Affine;

Affine copy_in_ring(const Array& array, std::uint32_t number) {
  const Affine turn = Affine::turned(number * array.angle_deg * std::numbers::pi / 180);
  return then(then(Affine::moved(-array.centre), turn), Affine::moved(array.centre));
}

std::vector<Affine> ring_of(const Array& array) {
  std::vector<Affine> copies;
  for (std::uint32_t i = 0; i < array.count; ++i) copies.push_back(copy_in_ring(array, i));
  return copies;
}

/// Row by row, every second one backwards.
std::vector<Affine> copies_of(const Array& array) {
  if (array.count > 0) return ring_of(array);
  std::vector<Affine> copies;
  for (std::uint32_t row = 0; row < array.rows; ++row) {
    for (std::uint32_t i = 0; i < array.columns; ++i) {
      const std::uint32_t column = row % 2 == 0 ? i : array.columns - 1 - i;
      copies.push_back(Affine::moved({column * array.dx, row * array.dy}));
    }
  }
  return copies;
}

Vec2 place_on(const ScanLine& line, double along) { return line.origin + along * line.along; }

Entry entry_of(const Scan& scan) {
  const ScanLine& last = scan.lines.back();
  return {place_on(scan.lines.front(), scan.lines.front().runs.front().from - scan.run_up),
          place_on(last, last.runs.back().to + scan.run_up)};
}

std::vector<Entry> entries_of(const Along& along, const AlongRules& rules) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < entry_count(along); ++i) entries.push_back(entry_of(along, i, rules));
  return entries;
}

/// The ways in which a pass can be made, as the order wants them.
std::vector<Entry> entries_of(const Pass& pass, const AlongRules& rules) {
  if (const auto* scan = std::get_if<Scan>(&pass.what)) return {entry_of(*scan)};
  if (const auto* picture = std::get_if<Picture>(&pass.what)) return {picture->entry};
  if (const auto* spot = std::get_if<Spot>(&pass.what)) return {{spot->at, spot->at}};
  return entries_of(std::get<Along>(pass.what), rules);
}

double start_of(const motion::AxisSetup& axes, char letter) {
  const auto axis = axes.find(letter);
  return axis ? axes.start[*axis] : 0;
}

Vec2 origin_of(const MachineFacts& machine) {
  const motion::AxisSetup& axes = machine.axes;
  return axes.linked ? Vec2{start_of(axes, 'X'), start_of(axes, 'Y')} : Vec2{};
}

class Planner {
 public:
  Planner(const drawing::Drawing& drawing, const Sheet& sheet, const Recipe& recipe,
          const MachineFacts& machine)
      : drawing_(drawing), sheet_(sheet), recipe_(recipe), layers_(drawing, recipe.operations) {
    plan_.machine = machine;
    plan_.copies = copies_of(recipe.array);
    plan_.end = recipe.end;
    plan_.origin = at_ = origin_of(machine);
    plan_.wrap = recipe.wrap;
    plan_.tolerance_mm = recipe.tolerance;
  }

  Plan plan() {
    tell_layers();
    if (!has_plane() || !can_wrap()) return std::move(plan_);
    tell_wrap();
    const std::uint32_t variants =
        has_variants() ? static_cast<std::uint32_t>(plan_.copies.size()) : 1;
    for (copy_ = 0; copy_ < variants; ++copy_) {
      for (std::size_t i = 0; i < recipe_.operations.size(); ++i)
        if (recipe_.operations[i].enabled) add(i);
    }
    if (variants == 1)
      for (PlannedOperation& planned : plan_.operations) planned.copy = drawing::kEveryCopy;
    for (std::size_t i = 0; i < plan_.operations.size(); ++i) put_in_order(i);
    return std::move(plan_);
  }

 private:
  /// Copies that differ, in their texts.
  [[nodiscard]] bool has_variants() const {
    return std::any_of(
        drawing_.entities.begin(), drawing_.entities.end(),
        [](const drawing::Entity& entity) { return entity.copy != drawing::kEveryCopy; });
  }

  void find(base::Severity severity, base::Code code, base::Place place, const std::string& detail,
            drawing::Name layer = {}, drawing::Name entity = {}) {
    base::Diagnostic diagnostic = base::make_error(code, place, detail);
    diagnostic.severity = severity;
    plan_.findings.push_back({std::move(diagnostic), layer, entity});
  }

  /// X and Y of a plane, and no diameters.
  bool has_plane() {
    const motion::AxisSetup& axes = plan_.machine.axes;
    if (axes.find('X') && axes.find('Y') && !axes.turns()) return true;
    find(base::Severity::error, base::Code::process_machine, {},
         fmt::format("a drawing needs the axes X and Y of a plane, {} has others",
                     plan_.machine.name));
    return false;
  }

  bool can_wrap() {
    const motion::AxisSetup& axes = plan_.machine.axes;
    if (recipe_.wrap.shape == Wrap::Shape::none) return true;
    if (axes.find('A') && axes.find('C') && axes.find('Z')) return true;
    find(base::Severity::error, base::Code::process_machine, {},
         fmt::format("[wrap] needs the axes X Y Z A C, {} has others", plan_.machine.name));
    return false;
  }

  void tell_missing_layers(std::size_t operation) {
    for (const std::string& layer : layers_.missing(operation))
      find(base::Severity::warning, base::Code::draw_layer, {},
           fmt::format("'{}' of operation '{}'", layer, recipe_.operations[operation].name));
  }

  /// What a surface does to a drawing and does not show in the plane.
  void tell_wrap() {
    double stretch = 1;
    contour::Box box;
    const WrappedSurface surface(recipe_.wrap);
    for (const Outline& outline : sheet_.outlines) {
      box.take(extents(outline.path));
      for (const contour::Vertex& vertex : outline.path.vertices)
        stretch = std::max(stretch, surface.stretch(vertex.point));
    }
    if (stretch > 1.0005)
      plan_.assumed.push_back(
          fmt::format("[wrap] on a sphere stretches the drawing across by up to {:.3f}", stretch));
    if (recipe_.wrap.shape != Wrap::Shape::cylinder || box.is_empty()) return;
    const double way = recipe_.wrap.axis == 'X' ? box.high.v - box.low.v : box.high.u - box.low.u;
    if (way > 2 * std::numbers::pi * recipe_.wrap.radius + 1e-6)
      plan_.assumed.push_back("[wrap] the drawing goes more than once round the cylinder");
  }

  void tell_layers() {
    for (std::size_t i = 0; i < recipe_.operations.size(); ++i) tell_missing_layers(i);
    for (const std::string& layer : layers_.unused())
      find(base::Severity::warning, base::Code::draw_layer_unused, {}, "'" + layer + "'");
  }

  [[nodiscard]] bool is_taken(std::size_t operation, drawing::EntityId entity) const {
    const std::uint32_t copy = drawing_.entities[entity].copy;
    return (copy == drawing::kEveryCopy || copy == copy_) && layers_.takes(operation, entity);
  }

  [[nodiscard]] Taken taken_by(std::size_t operation) const {
    Taken taken;
    for (const Outline& outline : sheet_.outlines)
      if (is_taken(operation, outline.entity)) taken.outlines.push_back(outline);
    for (const drawing::Point& point : sheet_.points)
      if (is_taken(operation, point.entity)) taken.points.push_back(point);
    for (const drawing::Image& image : drawing_.images)
      if (is_taken(operation, image.entity))
        taken.images.push_back({&image, then(image.to_mm, sheet_.placed)});
    return taken;
  }

  [[nodiscard]] Passes passes_of(const Operation& operation, const Settled& settled,
                                 const Taken& taken) const {
    switch (operation.process) {
      case Process::engrave:
      case Process::mark: return engrave_passes(operation, settled, taken);
      case Process::cut: return cut_passes(operation, settled, taken);
      case Process::fill:
      case Process::heat: return fill_passes(operation, settled, taken, run_up(operation, settled));
      case Process::weld: return weld_passes(operation, settled, taken);
      case Process::drill: return drill_passes(operation, taken);
      case Process::raster: break;
    }
    return raster_passes(operation, settled, taken, plan_.machine);
  }

  /// E = P / (v · width).
  [[nodiscard]] double energy_per_mm2(const PlannedOperation& planned) const {
    const double power_w = planned.settled.power_percent / 100 * plan_.machine.max_power_w;
    const double speed = planned.settled.feed / motion::kSecondsPerMinute;
    return power_w / (speed * planned.operation.track_width.value_or(1));
  }

  [[nodiscard]] double run_up(const Operation& operation, const Settled& settled) const {
    const double angle = operation.angle_deg * std::numbers::pi / 180;
    return run_up_mm(plan_.machine, settled.feed, {math::cos(angle), math::sin(angle)});
  }

  void add(std::size_t index) {
    const Operation& operation = recipe_.operations[index];
    PlannedOperation planned;
    planned.operation = operation;
    planned.index = index;
    planned.copy = copy_;
    planned.settled = settle(operation, plan_.machine);
    if (copy_ == 0) tell_assumed(operation, planned.settled);
    if (copy_ == 0) tell_ignored(operation);
    if (copy_ == 0) tell_assumed_of_mill(operation);
    if (is_impossible(operation)) return;
    const Taken taken = taken_by(index);
    Passes passes = passes_of(operation, planned.settled, taken);
    planned.rules = passes.rules;
    planned.passes = std::move(passes.passes);
    planned.scan_lines = passes.scan_lines;
    planned.rasters = std::move(passes.rasters);
    if (operation.process != Process::raster)
      for (const PlacedImage& image : taken.images)
        tell({base::Code::draw_image, true, image.image->entity, ""}, operation);
    if (operation.process == Process::heat) planned.j_mm2 = energy_per_mm2(planned);
    planned.contours = taken.outlines.size() + taken.points.size();
    for (const Remark& remark : passes.remarks) tell(remark, operation);
    plan_.operations.push_back(std::move(planned));
  }

  void tell_assumed_of_mill(const Operation& operation) {
    if (plan_.machine.has_beam || plan_.machine.makes_patterns) return;
    if (!operation.depth)
      plan_.assumed.push_back(fmt::format("operation '{}' says no depth: 0 mm", operation.name));
    if (!operation.spindle)
      plan_.assumed.push_back(
          fmt::format("operation '{}' says no spindle: it is not switched on", operation.name));
  }

  static bool is_hatch(const Operation& operation) { return operation.process == Process::fill; }

  /// Keys that are read and change nothing are told: nobody shall wait for them.
  void tell_ignored(const Operation& operation) {
    const auto tell = [&](bool is_said, const char* key) {
      if (is_said)
        plan_.assumed.push_back(
            fmt::format("operation '{}': {} has no effect yet", operation.name, key));
    };
    tell(operation.dashes, "dashes");
    tell(operation.overlaps == Overlaps::once, "overlaps = \"once\"");
    tell(operation.trepan, "trepan");
    tell(!operation.gas.empty(), "gas (air switches it)");
    tell(operation.min_power_percent && operation.process != Process::raster, "min_power");
    tell(recipe_.array.is_mixed && recipe_.array.copies() > 1, "array.order = \"travel\"");
  }

  bool is_impossible(const Operation& operation) {
    const bool goes_along = operation.process == Process::engrave ||
                            operation.process == Process::mark || operation.process == Process::cut;
    const bool sets_power = plan_.machine.has_beam && !plan_.machine.makes_patterns;
    if (goes_along || sets_power || (plan_.machine.makes_patterns && is_hatch(operation)))
      return false;
    find(base::Severity::error, base::Code::process_machine, {},
         fmt::format(
             "operation '{}': {} needs a beam, {} has none: it engraves and cuts along contours",
             operation.name, word_of(operation.process), plan_.machine.name));
    return true;
  }

  void tell_assumed(const Operation& operation, const Settled& settled) {
    if (plan_.machine.makes_patterns) return;
    if (settled.power_is_assumed && plan_.machine.has_beam)
      plan_.assumed.push_back(fmt::format("operation '{}' says no power: {:.6g} %", operation.name,
                                          settled.power_percent));
    if (settled.feed_is_assumed)
      plan_.assumed.push_back(
          fmt::format("operation '{}' says no feed: {:.6g} mm/min, half of the machine's fastest",
                      operation.name, settled.feed));
  }

  void tell(const Remark& remark, const Operation& operation) {
    const drawing::Entity& entity = drawing_.entities[remark.entity];
    const std::string detail = remark.detail.empty() ? "" : ": " + remark.detail;
    find(remark.is_error ? base::Severity::error : base::Severity::warning, remark.code,
         {entity.file, entity.line, 1},
         fmt::format("{} on layer {} in operation '{}'{}", drawing_.names[entity.kind],
                     drawing_.names[entity.layer], operation.name, detail),
         entity.layer, entity.kind);
  }

  void put_in_order(std::size_t index) {
    PlannedOperation& planned = plan_.operations[index];
    std::vector<Item> items;
    for (const Pass& pass : planned.passes)
      items.push_back({entries_of(pass, planned.rules), pass.before});
    const bool is_last = index + 1 == plan_.operations.size();
    const bool comes_back = is_last && plan_.end.kind != EndKind::stay;
    const Ends ends{at_, comes_back,
                    plan_.end.kind == EndKind::point ? plan_.end.at : plan_.origin};
    Order order = recipe_.by_travel ? find_order(items, ends) : file_order(items, ends);
    planned.turns = std::move(order.turns);
    plan_.travel_order_mm += order.travel_mm;
    plan_.travel_file_mm += order.travel_file_mm;
    plan_.travel_nearest_mm += order.travel_nearest_mm;
    if (!planned.turns.empty()) {
      const Turn& last = planned.turns.back();
      at_ = items[last.item].entries[last.entry].end;
    }
  }

  const drawing::Drawing& drawing_;
  const Sheet& sheet_;
  const Recipe& recipe_;
  Layers layers_;
  Plan plan_;
  Vec2 at_;
  std::uint32_t copy_ = 0;  // that is planned
};

}  // namespace

Plan plan_of(const drawing::Drawing& drawing, const Sheet& sheet, const Recipe& recipe,
             const MachineFacts& machine) {
  return Planner(drawing, sheet, recipe, machine).plan();
}

}  // namespace kerf::process
