#include "job/drawing/drawn_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include "job/drawing/drawing_files.hpp"
#include "job/drawing/drawn_texts.hpp"
#include "job/drawing/image_sizes.hpp"
#include "process/materials.hpp"
#include "process/plan_reader.hpp"

namespace kerf::job {
namespace {

using base::Outcome;

/// The motions of a plan without what only texts tell.
class PlanStream final : public control::MotionStream {
 public:
  PlanStream(const process::Plan& plan, const drawing::Drawing& drawing) : reader_(plan, drawing) {}

  bool next(std::vector<motion::Motion>& motions) override {
    const std::size_t before = motions.size();
    while (motions.size() == before) {
      steps_.clear();
      if (!reader_.next(steps_)) return false;
      for (const process::Step& step : steps_)
        if (const auto* motion = std::get_if<motion::Motion>(&step)) motions.push_back(*motion);
    }
    return true;
  }

 private:
  process::PlanReader reader_;
  std::vector<process::Step> steps_;
};

/// Pictures of layers are placed with everything else.
drawing::CleaningRules rules_of(const process::Recipe& recipe) {
  return {recipe.same, recipe.join};
}

bool has_error(const std::vector<drawing::Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const drawing::Finding& finding) {
    return finding.diagnostic.severity == base::Severity::error;
  });
}

}  // namespace

process::MachineFacts facts_of(const machine::MachineDefinition& definition) {
  process::MachineFacts facts;
  facts.name = definition.name;
  facts.axes = definition.axes;
  facts.has_beam = definition.drive.laser.fitted();
  facts.makes_patterns = definition.dialect == "pattern";
  facts.max_power_w = definition.drive.laser.max_power_w;
  facts.frequency_hz = definition.drive.laser.pwm_frequency_hz;
  facts.kerf_mm = definition.drive.laser.width_of_cut();
  facts.focus_mm = definition.drive.laser.focus_mm;
  facts.gas = definition.drive.laser.gas;
  facts.z_first = definition.tip.z_first;
  facts.fastest_feed = std::numeric_limits<double>::infinity();
  for (const char letter : {'X', 'Y'}) {
    if (const auto axis = facts.axes.find(letter))
      facts.fastest_feed = std::min(facts.fastest_feed, facts.axes[*axis].rapid_per_min);
  }
  return facts;
}

std::vector<drawing::ContourLayer> layers_of(const DrawnPlan& plan) {
  std::vector<drawing::ContourLayer> layers;
  std::map<drawing::Name, std::size_t> places;
  const auto layer_of = [&](drawing::EntityId id) -> drawing::ContourLayer& {
    const drawing::Entity& entity = plan.drawing().entities[id];
    const auto [place, is_new] = places.try_emplace(entity.layer, layers.size());
    if (is_new)
      layers.push_back({std::string(plan.drawing().names[entity.layer]), entity.colour, {}});
    return layers[place->second];
  };
  for (const drawing::Chain& chain : plan.cleaned().chains)
    layer_of(chain.entity).contours.push_back(chain.path);
  for (const drawing::Point& point : plan.cleaned().points)
    layer_of(point.entity).contours.push_back({{{point.at, 0, point.entity}}, false});
  return layers;
}

DrawnPlan::DrawnPlan(const DrawOrder& order) : order_(order) {}

Outcome<std::shared_ptr<const DrawnPlan>> DrawnPlan::of(const DrawOrder& order) {
  const std::shared_ptr<DrawnPlan> made(new DrawnPlan(order));
  if (auto done = made->make(); !done) return tl::unexpected(done.error());
  return std::shared_ptr<const DrawnPlan>(made);
}

Outcome<void> DrawnPlan::make() {
  order_.reading.tolerance_mm = order_.recipe.tolerance;
  order_.reading.same_mm = order_.recipe.same;
  if (!order_.recipe.lens_side.empty()) order_.reading.lens_side = order_.recipe.lens_side[0];
  drawing::Canvas canvas(order_.reading, drawing_);
  const auto read = read_drawings(order_.drawings, order_.max_seconds, sources_, canvas);
  if (!read) return tl::unexpected(read.error());
  size_images(order_.recipe.image, drawing_);
  auto said = draw_texts(order_, drawing_, canvas);
  if (!said) return tl::unexpected(said.error());
  texts_ = std::move(*said);
  cleaned_ = clean(drawing_, rules_of(order_.recipe), canvas);
  if (cleaned_.chains.empty() && cleaned_.points.empty() && drawing_.images.empty())
    canvas.find(base::Severity::error, base::Code::draw_empty, {}, "");
  std::vector<contour::Contour> paths;
  for (const drawing::Chain& chain : cleaned_.chains) paths.push_back(chain.path);
  nests_ = drawing::nests_of(paths);
  contour::Box box = process::extents_of(cleaned_);
  for (const drawing::Image& image : drawing_.images)
    for (const geometry::Vec2 corner :
         {geometry::Vec2{0, 0}, geometry::Vec2{1, 0}, geometry::Vec2{0, 1}, geometry::Vec2{1, 1}})
      box.take(image.to_mm(corner));
  const drawing::Affine map = process::placement(order_.recipe.place, box);
  sheet_ = process::placed(drawing_, cleaned_, map, order_.recipe.tolerance);
  const process::MachineFacts machine = facts_of(order_.definition);
  const process::Diagnostics filled = process::fill_in(order_.recipe, order_.materials, machine);
  plan_ = process::plan_of(drawing_, sheet_, order_.recipe, machine);
  job_findings_ = filled;
  return {};
}

std::unique_ptr<control::MotionStream> DrawnPlan::stream() const {
  return std::make_unique<PlanStream>(plan_, drawing_);
}

std::string DrawnPlan::name() const {
  if (order_.drawings.empty()) return "drawing";
  return std::filesystem::path(order_.drawings.front()).filename().string();
}

std::vector<std::string> DrawnPlan::file_names() const { return order_.drawings; }

std::vector<drawing::Finding> DrawnPlan::findings() const {
  std::vector<drawing::Finding> all = drawing_.findings;
  all.insert(all.end(), plan_.findings.begin(), plan_.findings.end());
  return all;
}

bool DrawnPlan::is_wrong() const {
  return has_error(drawing_.findings) || has_error(plan_.findings);
}

}  // namespace kerf::job
