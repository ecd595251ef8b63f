#include "job/features_run.hpp"

#include "features/origins.hpp"
#include "features/path/recorder.hpp"
#include "geometry/contour/boolean.hpp"
#include "job/internal/block_texts.hpp"
#include "job/internal/control_modes.hpp"
#include "job/internal/run_rack.hpp"
#include "job/internal/stock_shape.hpp"
#include "job/internal/survey_pass.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::job {
namespace {

base::Outcome<void> suits(const machine::MachineDefinition& machine) {
  if (!machine.axes.linked && !machine.axes.beam) return {};
  return base::usage(machine.name + ": features are recognised on mills and lathes");
}

/// The tools as the stock of a run has them, for as many as have moved.
void add_tools(const StockJob& job, const SurveyPass& pass, FeaturesResult& result) {
  RunRack::AxialTools axial;
  for (const auto& [number, cut] : pass.survey().tools()) axial[number] = cut.axial;
  const machine::BatchRun& machine = result.run->machine();
  const bool turns = machine.definition().turns();
  RunRack rack(job, machine, std::move(axial));
  for (const features::State& state : result.recording.states)
    result.recording.tools.try_emplace(state.tool, rack.tool(state.tool).tool);
  const SurveyedTools tools(pass.survey(), rack, pass.origin());
  if (auto shape = shape_of(job.shape, turns, tools, result.assumed)) result.shape = *shape;
  result.assumed.insert(result.assumed.begin(), rack.assumed().begin(), rack.assumed().end());
}

/// Says of what was found where its blocks come from.
void tell_origins(const FeaturesResult& result, features::Tree& tree) {
  const machine::BatchRun& machine = result.run->machine();
  const machine::DialectRow* const dialect = machine::find_dialect(machine.definition().dialect);
  const bool is_gcode = dialect != nullptr && dialect->kind == machine::DialectRow::Kind::gcode;
  BlockTexts texts(machine.sources(), machine.control(), is_gcode ? dialect->language : nullptr,
                   result.recording.turns ? BlockTexts::Shapes::some : BlockTexts::Shapes::none);
  features::find_origins(result.recording, texts, tree);
}

/// What was said of the table and has no effect here is told.
void add_notes(const StockJob& job, FeaturesResult& result) {
  for (const std::string& note : job.notes) result.assumed.push_back({0, note});
  for (const StockJob::NamedShape& fixture : job.fixtures) {
    result.assumed.push_back(
        {0, "fixture " + fixture.name + " has no effect: features are told by what is cut"});
  }
}

/// The bar in (z, radius), machine coordinates; of what is not round about the spindle its box.
features::Blank bar_of(const FeaturesResult& result) {
  features::Blank blank{.is_known = result.knows_stock};
  const stock::Bounds box = stock::bounds(*result.shape);
  const auto* const round = std::get_if<stock::CylinderShape>(&*result.shape);
  const double inner = round != nullptr && round->along == 2 ? round->inner_diameter / 2 : 0;
  blank.top = box.high.z + result.origin.z;
  blank.bottom = box.low.z + result.origin.z;
  blank.outline = {{{{{{blank.bottom, inner}},
                      {{blank.top, inner}},
                      {{blank.top, box.high.x}},
                      {{blank.bottom, box.high.x}}},
                     true}}};
  return blank;
}

/// The table's piece as its outline from above; of what is neither box nor upright its box.
features::Blank blank_of(const FeaturesResult& result) {
  if (!result.shape) return {};
  if (result.recording.turns) return bar_of(result);
  const stock::Bounds box = stock::bounds(*result.shape);
  const contour::Vec2 zero{result.origin.x, result.origin.y};
  features::Blank blank{.is_known = result.knows_stock};
  blank.top = box.high.z + result.origin.z;
  blank.bottom = box.low.z + result.origin.z;
  const auto* const round = std::get_if<stock::CylinderShape>(&*result.shape);
  if (round != nullptr && round->along == 2) {
    const contour::Vec2 middle = zero + contour::Vec2{round->u, round->v};
    blank.outline = contour::disc(middle, round->diameter / 2);
    if (round->inner_diameter > 0) {
      blank.outline =
          contour::subtract(blank.outline, contour::disc(middle, round->inner_diameter / 2));
    }
    return blank;
  }
  const contour::Vec2 low = zero + contour::Vec2{box.low.x, box.low.y};
  const contour::Vec2 high = zero + contour::Vec2{box.high.x, box.high.y};
  blank.outline = {{{{{low}, {{high.u, low.v}}, {high}, {{low.u, high.v}}}, true}}};
  return blank;
}

}  // namespace

base::Outcome<FeaturesResult> record_features(const StockJob& job, const LookOn& look_on) {
  if (auto suited = suits(job.job.definition); !suited) return tl::unexpected(suited.error());
  auto run = Run::of(job.job);
  if (!run) return tl::unexpected(run.error());
  FeaturesResult result;
  SurveyPass pass(job, **run);
  ControlModes modes((*run)->machine());
  features::Recorder recorder((*run)->machine().definition().axes, modes);
  (*run)->machine().add_sink(recorder);
  if (look_on) look_on((*run)->machine());
  result.status = (*run)->go();
  result.run = std::move(*run);
  result.recording = std::move(recorder.recording());
  result.zero = pass.zero();
  result.origin = pass.origin();
  result.knows_stock = job.knows_stock;
  add_tools(job, pass, result);
  add_notes(job, result);
  return result;
}

features::Tree recognised(const FeaturesResult& result, features::Method method) {
  features::Tree tree = features::recognise(result.recording, blank_of(result), method);
  tell_origins(result, tree);
  return tree;
}

base::Outcome<FeaturesResult> recognise_features(const StockJob& job, features::Method method) {
  auto result = record_features(job);
  if (result) result->tree = recognised(*result, method);
  return result;
}

}  // namespace kerf::job
