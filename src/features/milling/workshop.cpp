#include "features/milling/workshop.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "features/milling/contour_shapes.hpp"
#include "features/milling/plunge_step.hpp"
#include "features/milling/thread_milling.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;

constexpr std::size_t kMostWaterlines = 20;  // levels of a ball, above which they are a surface
constexpr std::uint32_t kLeastSurface = 8;   // rows that make a surface of their own

/// The length of the border that two regions share which have no area in common.
double shared_border(const Region& a, const Region& b) {
  return (contour::length(a) + contour::length(b) - contour::length(contour::unite(a, b))) / 2;
}

Share* share_of(Draft& draft, std::size_t operation) {
  const auto found = std::find_if(draft.shares.begin(), draft.shares.end(),
                                  [&](const Share& share) { return share.operation == operation; });
  return found == draft.shares.end() ? nullptr : &*found;
}

template <typename Spans>
void append(Spans& to, const Spans& more) {
  to.insert(to.end(), more.begin(), more.end());
}

bool is_waterlines(const stock::Tool& tool, const Strokes& strokes) {
  if (!is_round_ended(tool) || strokes.levels.size() <= kMostWaterlines) return false;
  std::vector<double> heights;
  for (const LevelRun& run : strokes.levels) heights.push_back(run.z);
  std::sort(heights.begin(), heights.end());
  const auto end = std::unique(heights.begin(), heights.end(),
                               [](double a, double b) { return std::fabs(a - b) <= kSameZ_mm; });
  return static_cast<std::size_t>(end - heights.begin()) > kMostWaterlines;
}

}  // namespace

/// Something of an operation, by its first row.
struct Workshop::Event {
  std::uint32_t row = 0;
  std::variant<Level*, const PlungeRun*, const HelixRun*, const FreeRun*> what;
};

Workshop::Workshop(const Recording& recording, const Blank& blank, Allowance& allowance)
    : recording_(recording), allowance_(allowance), idle_(recording) {
  for (const SetUp& setup : recording.setups) materials_.emplace_back(blank_in(blank, setup));
}

const stock::Tool& Workshop::tool_of(const Operation& operation) const {
  return recording_.tools.at(operation.tool);
}

void Workshop::follow(std::size_t number, const Operation& operation) {
  air_mm_.resize(number + 1);
  if (allowance_.is_over()) return leave(operation.rows, Unrecognised::Why::budget);
  if (tool_of(operation).kind == stock::ToolKind::thread_mill)
    return follow_threads(number, operation);
  const double top = materials_[operation.setup].blank().top;
  Strokes strokes = strokes_of(recording_, operation, top);
  const bool slopes = strokes.sloping_mm > strokes.level_mm;
  if (slopes || is_waterlines(tool_of(operation), strokes)) {
    return add_surface(number, operation, recording_.spans_at_feed(operation.rows), operation.rows);
  }
  follow_strokes(number, operation, std::move(strokes));
}

void Workshop::follow_strokes(std::size_t number, const Operation& operation, Strokes strokes) {
  const Material& material = materials_[operation.setup];
  const ToolReach reach = reach_of(tool_of(operation));
  auto levels = levels_of(recording_, number, operation, reach, strokes.levels,
                          material.blank().top, allowance_);
  if (!levels) return leave(operation.rows, Unrecognised::Why::budget);
  std::vector<Event> events;
  for (Level& level : *levels) events.push_back({level.first_row, &level});
  for (const PlungeRun& run : strokes.plunges) events.push_back({run.rows.first, &run});
  for (const HelixRun& run : strokes.helices) events.push_back({run.rows.first, &run});
  for (const FreeRun& run : strokes.frees) events.push_back({run.rows.first, &run});
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.row < b.row; });
  for (const Event& event : events) {
    if (allowance_.is_over()) {
      leave(event);
    } else {
      take(number, operation, event);
    }
  }
  leave_idle_pecks();
}

void Workshop::take(std::size_t number, const Operation& operation, const Event& event) {
  const auto take_it = [&](auto* run) {
    if constexpr (requires { take(number, operation, *run); }) {
      take(number, operation, *run);
    } else {
      take(operation, *run);
    }
  };
  std::visit(take_it, event.what);
}

void Workshop::leave(const Event& event) {
  const auto leave_it = [&](const auto* run) {
    if constexpr (requires { run->rows.first; }) {
      leave(run->rows, Unrecognised::Why::budget);
    } else {
      leave(*run);
    }
  };
  std::visit(leave_it, event.what);
}

void Workshop::leave(const Level& level) {
  for (const LevelRun& run : level.runs) {
    for (const Span& span : run.entries) leave(span, Unrecognised::Why::budget);
    leave(run.rows, Unrecognised::Why::budget);
  }
}

// What a level leaves behind in the material and in the tree.
void Workshop::keep(const ShapedLevel& shaped) {
  constexpr std::size_t kCopies = 4;  // of what it removed: the region, contours, nominal ones
  const std::size_t vertices = contour::vertex_count(shaped.level.sweep) +
                               kCopies * contour::vertex_count(shaped.layer.removed);
  allowance_.keep(vertices * sizeof(contour::Vertex) + sizeof(Draft) +
                  shaped.loops.loops.size() * sizeof(Loop));
}

// Rows straight down count above what stands there, rows beside all that is cut as a whole.
void Workshop::count_air(std::size_t number, Span rows) {
  const std::size_t setup = recording_.state_of(recording_.moves[rows.first]).setup;
  const Material& material = materials_[setup];
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    const double from_z = recording_.from(row).z;
    const double to_z = recording_.moves[row].to.z;
    const double high = std::max(from_z, to_z);
    const double low = std::min(from_z, to_z);
    if (high - low <= kSameZ_mm) {
      if (low >= material.blank().top - kSameZ_mm) air_mm_[number] += recording_.length_of(row);
      continue;
    }
    const double top = to_z > from_z ? low : material.top_at(recording_.flat_to(row));
    const double share = std::clamp((high - std::max(low, top)) / (high - low), 0.0, 1.0);
    air_mm_[number] += share * recording_.length_of(row);
  }
}

// In a hole, or where material is only outside of the helix, it is a step of a hole.
void Workshop::follow_threads(std::size_t number, const Operation& operation) {
  const double reach = reach_of(tool_of(operation)).radius;
  for (const ThreadRun& run : thread_runs_of(recording_, operation)) {
    const HelixRun& helix = run.helix;
    if (!run.is_found) {
      take(operation, FreeRun{helix.rows, helix.visit});
      continue;
    }
    const bool is_inside = holes_.find(operation.setup, helix.centre) != nullptr ||
                           materials_[operation.setup].top_at(helix.centre) < helix.top - kSameZ_mm;
    if (is_inside) {
      HoleStep step{.how = HoleStep::How::helix, .tool = operation.tool, .operation = number};
      step.diameter = 2 * (helix.radius + reach);
      step.top = std::min(helix.top, materials_[operation.setup].blank().top);
      step.bottom = std::min(helix.bottom, step.top);
      step.thread_pitch = helix.pitch;
      step.rows = {helix.rows};
      step.visits = {helix.visit};
      holes_.add(operation.setup, helix.centre, std::move(step));
    } else {
      add_thread(number, operation, helix, 2 * (helix.radius - reach));
    }
  }
}

// Round a piece that stands.
void Workshop::add_thread(std::size_t number, const Operation& operation, const HelixRun& helix,
                          double diameter) {
  Draft draft{.middle = helix.centre, .first_row = helix.rows.first};
  Feature& feature = draft.feature;
  feature.type = FeatureType::thread;
  feature.setup = operation.setup;
  feature.tool = operation.tool;
  feature.entry = {.kind = features::Entry::Kind::helix, .pitch = helix.pitch};
  feature.measures.round = FeatureMeasures::Round{diameter, helix.centre};
  Layer layer{.z = helix.bottom, .top = helix.top, .cuts = {helix.rows}, .visits = {helix.visit}};
  layer.entry = feature.entry;
  feature.layers.push_back(std::move(layer));
  draft.shares.push_back({.operation = number, .visits = {helix.visit}});
  Box box{helix.centre, helix.centre};
  boxes_.add(box.grown(std::max(diameter / 2, 0.0)));
  drafts_.push_back(std::move(draft));
}

void Workshop::leave_idle_pecks() {
  for (const PlungeRun& peck : idle_.take()) {
    const State& state = recording_.state_of(recording_.moves[peck.rows.first]);
    leave(peck.rows, why_air(materials_[state.setup].blank(), peck.bottom));
  }
}

void Workshop::take(std::size_t number, const Operation& operation, const PlungeRun& plunge) {
  Material& material = materials_[operation.setup];
  const stock::Tool& tool = tool_of(operation);
  if (!idle_.go_on_with(plunge)) leave_idle_pecks();
  if (!material.stands_over(plunge.at, reach_of(tool).radius, plunge.bottom)) {
    air_mm_[number] += recording_.length_of(plunge.rows);
    return idle_.add(plunge);
  }
  count_air(number, plunge.rows);
  HoleStep step = step_of(recording_, material, tool, plunge);
  step.operation = number;
  std::vector<PlungeRun> pecks = idle_.take();
  pecks.push_back(plunge);
  for (const PlungeRun& peck : pecks) {
    step.rows.push_back(peck.rows);
    step.visits.push_back(peck.visit);
  }
  if (!is_conical(tool) && step.how != HoleStep::How::tap)
    material.cut(contour::disc(plunge.at, step.diameter / 2), plunge.bottom);
  holes_.add(operation.setup, plunge.at, std::move(step));
}

void Workshop::add_hole(std::size_t number, const Operation& operation, const HelixRun& helix,
                        std::vector<Span> rows) {
  Material& material = materials_[operation.setup];
  const double radius = helix.radius + reach_of(tool_of(operation)).radius;
  const Region disc = contour::disc(helix.centre, radius);
  HoleStep step{.how = HoleStep::How::helix, .tool = operation.tool, .operation = number};
  step.diameter = 2 * radius;
  step.bottom = helix.bottom;
  step.top = material.top_over(disc, helix.bottom);
  step.rows = std::move(rows);
  step.visits = {helix.visit};
  material.cut(disc, helix.bottom);
  holes_.add(operation.setup, helix.centre, std::move(step));
}

void Workshop::take(std::size_t number, const Operation& operation, const HelixRun& helix) {
  if (helix.radius <= reach_of(tool_of(operation)).radius + kSamePoint_mm)
    return add_hole(number, operation, helix, {helix.rows});
  take(operation, FreeRun{helix.rows, helix.visit});
}

void Workshop::take(const Operation& operation, const FreeRun& run) {
  const Blank& blank = materials_[operation.setup].blank();
  const Move& first = recording_.moves[run.rows.first];
  double lowest = recording_.from(run.rows.first).z;
  for (std::uint32_t row = run.rows.first; row <= run.rows.last; ++row)
    lowest = std::min(lowest, recording_.moves[row].to.z);
  if (first.kind == Move::Kind::probe) return leave(run.rows, Unrecognised::Why::probing);
  if (recording_.setups[operation.setup].is_turned())
    return leave(run.rows, Unrecognised::Why::rotary);
  if (lowest >= blank.top - kSameZ_mm) return leave(run.rows, why_air(blank, lowest));
  if (run.rows.last - run.rows.first + 1 >= kLeastSurface)
    return add_surface(air_mm_.size() - 1, operation, {run.rows}, run.visit);
  leave(run.rows, Unrecognised::Why::free_motion);
}

void Workshop::leave(Span rows, Unrecognised::Why why) {
  Unrecognised rest{.why = why, .rows = rows};
  for (std::uint32_t row = rows.first; row <= rows.last; ++row)
    rest.moves += static_cast<std::uint32_t>(recording_.is_at_feed(row));
  rest.cut_mm = recording_.length_of(rows);
  unrecognised_.push_back(rest);
}

void Workshop::add_surface(std::size_t number, const Operation& operation, std::vector<Span> rows,
                           Span visit) {
  Draft draft{.first_row = rows.front().first};
  draft.feature.type = FeatureType::surface;
  draft.feature.setup = operation.setup;
  draft.feature.tool = operation.tool;
  Layer layer{.cuts = std::move(rows), .visits = {visit}};
  layer.top = materials_[operation.setup].blank().top;
  Box box;
  layer.z = layer.top;
  for (const Span& span : layer.cuts) {
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      layer.z = std::min(layer.z, recording_.moves[row].to.z);
      box.take(recording_.flat_to(row));
    }
  }
  draft.middle = box.middle();
  draft.shares.push_back({.operation = number, .visits = {visit}});
  draft.feature.layers.push_back(std::move(layer));
  drafts_.push_back(std::move(draft));
  boxes_.add(box);
}

bool Workshop::is_helical_hole(const ShapedLevel& shaped) const {
  if (shaped.level.runs.size() != 1 || shaped.loops.loops.size() != 1) return false;
  if (!shaped.loops.links.empty() || shaped.layer.entry.kind != features::Entry::Kind::helix)
    return false;
  const auto disc = disc_of(normal_form(recording_.contour_of(shaped.loops.loops.front().rows)));
  return disc && disc->radius <= shaped.level.radius + kSamePoint_mm;
}

void Workshop::take(const Operation& operation, Level& level) {
  Material& material = materials_[operation.setup];
  const std::size_t number = level.operation;
  auto found =
      shaped(recording_, material, reach_of(tool_of(operation)), std::move(level), allowance_);
  if (!found) return leave(level);
  ShapedLevel& its = *found;
  keep(its);
  for (const Span& span : its.layer.entries) count_air(number, span);
  if (its.layer.removed.is_empty()) {
    for (const Span& span : its.layer.cuts) air_mm_[number] += recording_.length_of(span);
  }
  if (is_helical_hole(its)) {
    const Disc disc = *disc_of(normal_form(recording_.contour_of(its.loops.loops.front().rows)));
    std::vector<Span> rows = its.layer.cuts;
    append(rows, its.layer.entries);
    std::sort(rows.begin(), rows.end(),
              [](const Span& a, const Span& b) { return a.first < b.first; });
    HelixRun helix{.centre = disc.centre, .radius = disc.radius, .bottom = its.level.z};
    helix.visit = its.layer.visits.front();
    return add_hole(number, operation, helix, std::move(rows));
  }
  put(std::move(its), material, !is_conical(tool_of(operation)));
}

// What a cone has cut is left standing: how wide it is at each height nobody asks.
void Workshop::put(ShapedLevel shaped, Material& material, bool is_mill) {
  const Region sweep = shaped.level.sweep;
  const double z = shaped.layer.z;
  Draft* draft = layer_above(shaped);
  if (draft != nullptr) {
    add_layer(*draft, std::move(shaped));
  } else if (!is_mill || !join(shaped)) {
    draft = &begin_feature(std::move(shaped));
  }
  if (is_mill) material.cut(sweep, z);
  if (draft != nullptr) draft->cuts_before = material.cuts();
}

// The feature of the same operation whose last layer has this shape, with nothing cut there since.
Draft* Workshop::layer_above(const ShapedLevel& shaped) {
  if (shaped.layer.contour.vertices.empty()) return nullptr;
  const Material& material = materials_[shaped.level.setup];
  const std::vector<std::size_t> places = boxes_.at(contour::extents(shaped.layer.contour));
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    Draft& draft = drafts_[*place];
    if (draft.shares.empty() || draft.shares.back().operation != shaped.level.operation) continue;
    const Layer& last = draft.feature.layers.back();
    if (draft.feature.setup != shaped.level.setup || last.z <= shaped.layer.z + kSameZ_mm) continue;
    if (!has_levels(draft.feature.type) || draft.shares.size() > 1) continue;
    if (are_one_shape(last, shaped.layer) &&
        !material.is_cut_since(draft.cuts_before, shaped.layer.removed))
      return &draft;
  }
  return nullptr;
}

void Workshop::add_layer(Draft& draft, ShapedLevel shaped) {
  append(draft.shares.back().visits, shaped.layer.visits);
  draft.feature.layers.push_back(std::move(shaped.layer));
}

// Beside it, or all over it where nothing was left.
bool Workshop::belongs(const Layer& layer, const ShapedLevel& shaped) {
  if (std::fabs(layer.z - shaped.layer.z) > kSameZ_mm || layer.removed.is_empty()) return false;
  if (!shaped.layer.removed.is_empty())
    return shared_border(layer.removed, shaped.layer.removed) > kSamePoint_mm;
  const Region again = contour::intersect(layer.removed, shaped.level.sweep);
  return contour::area(again) > contour::area(shaped.level.sweep) / 2;
}

// What a later operation cuts beside what an earlier one has, to the same bottom, is the same
// feature's.
bool Workshop::join(ShapedLevel& shaped) {
  const Layer& its = shaped.layer;
  const Region& region = its.removed.is_empty() ? shaped.level.sweep : its.removed;
  Box box = contour::extents(region);
  if (box.is_empty()) return false;
  for (const std::size_t place : boxes_.at(box.grown(kSamePoint_mm))) {
    Draft& draft = drafts_[place];
    if (draft.feature.setup != shaped.level.setup) continue;
    if (draft.shares.front().operation == shaped.level.operation) continue;
    for (Layer& layer : draft.feature.layers) {
      if (!belongs(layer, shaped)) continue;
      join(draft, layer, shaped);
      boxes_.replace(place, box);
      return true;
    }
  }
  return false;
}

void Workshop::join(Draft& draft, Layer& layer, ShapedLevel& shaped) {
  Share* share = share_of(draft, shaped.level.operation);
  if (share == nullptr) {
    draft.shares.push_back({.operation = shaped.level.operation, .radius = shaped.level.radius});
    share = &draft.shares.back();
    for (const Contour& loop : layer.removed.loops) share->wall_mm += contour::length(loop);
  }
  append(share->visits, shaped.layer.visits);
  share->pieces += outline_count(shaped.layer.removed);
  share->beside_mm += shared_border(layer.removed, shaped.layer.removed);
  share->area += shaped.layer.area;
  append(layer.cuts, shaped.layer.cuts);
  append(layer.entries, shaped.layer.entries);
  append(layer.visits, shaped.layer.visits);
  if (shaped.layer.removed.is_empty()) return;
  layer.removed = contour::unite(layer.removed, shaped.layer.removed);
  layer.area += shaped.layer.area;
  tell_contours(recording_, materials_[shaped.level.setup], shaped.level.radius, layer);
}

Draft& Workshop::begin_feature(ShapedLevel shaped) {
  Draft draft{.first_row = shaped.level.first_row};
  draft.feature.setup = shaped.level.setup;
  draft.feature.tool = shaped.level.tool;
  draft.shares.push_back({.operation = shaped.level.operation, .visits = shaped.layer.visits});
  Box box = contour::extents(shaped.layer.contour);
  if (box.is_empty()) box = contour::extents(shaped.level.sweep);
  for (const LevelRun& run : shaped.level.runs) {
    if (box.is_empty()) box = contour::extents(path_of(recording_, run));
  }
  draft.middle = box.middle();
  draft.feature.layers.push_back(shaped.layer);
  shaped.level.sweep = {};
  draft.first = std::move(shaped);
  drafts_.push_back(std::move(draft));
  boxes_.add(box);
  return drafts_.back();
}

std::vector<Draft> Workshop::drafts() {
  std::stable_sort(drafts_.begin(), drafts_.end(),
                   [](const Draft& a, const Draft& b) { return a.first_row < b.first_row; });
  return std::move(drafts_);
}

}  // namespace kerf::features
