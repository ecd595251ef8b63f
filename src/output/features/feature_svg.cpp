#include "output/features/feature_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "features/tree/words.hpp"
#include "output/features/feature_text.hpp"
#include "output/features/internal/lines.hpp"
#include "output/features/internal/svg_path.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

using contour::Box;
using contour::Contour;
using contour::Vec2;
using features::Feature;
using features::Hole;
using features::Layer;
using features::Span;

constexpr double kMargin_mm = 5;
constexpr double kBetween_mm = 20;

constexpr std::string_view kStyle =
    "path{fill:none;stroke-linejoin:round;stroke-linecap:round}"
    ".layer{fill:#8fb4d9;fill-opacity:.35;fill-rule:evenodd;stroke:none}"
    ".nominal{stroke:#1f3a5f;stroke-width:.4}"
    ".tool{stroke:#c05020;stroke-width:.15}"
    ".outside-profile .layer,.inside-profile .layer,.boss .layer{fill:#d9b48f}"
    ".slot .layer,.groove .layer{fill:#9fd98f}"
    ".face .layer,.step .layer{fill:#d9d58f}"
    ".hole .layer{fill:#b98fd9}"
    ".chamfer .layer,.engraving .layer{fill:#d98fb0}";

// Of edges their extents, because a region of arcs reaches beyond its vertices.
void take(Box& box, const std::vector<Contour>& contours) {
  for (const Contour& contour : contours) {
    if (!contour.vertices.empty()) box.take(contour::extents(contour));
  }
}

/// The way of the tool along rows, an open contour wherever it goes on.
std::vector<Contour> ways_of(const features::Recording& recording, const std::vector<Span>& spans) {
  std::vector<Contour> ways;
  for (const Span& span : spans) {
    std::vector<contour::Edge> edges;
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      if (recording.moves[row].cuts()) recording.append_edges(row, edges);
    }
    Contour way{{}, false};
    for (const contour::Edge& edge : edges) way.vertices.push_back({edge.from, edge.bulge});
    if (!edges.empty()) way.vertices.push_back({edges.back().to});
    if (!edges.empty()) ways.push_back(std::move(way));
  }
  return ways;
}

std::vector<Contour> region_of(const Layer& layer) {
  if (!layer.removed.loops.empty()) return layer.removed.loops;
  if (layer.contour.vertices.empty()) return {};
  return {layer.contour};
}

/// What a drawing would say, or the open contours of what has none round it.
std::vector<Contour> nominal_of(const Feature& feature) {
  if (feature.turned) return {feature.turned->contour};
  if (feature.layers.empty()) return {};
  const Layer& top = feature.layers.front();
  std::vector<Contour> contours = top.nominal_islands;
  contours.insert(contours.begin(), top.nominal);
  return contours;
}

class Picture {
 public:
  explicit Picture(const FeatureFacts& facts) : facts_(facts), tree_(*facts.tree) {
    boxes_.resize(facts.recording->setups.size());
    shifts_.resize(boxes_.size());
    for (const Feature& feature : tree_.features) measure(feature);
    for (const Hole& hole : tree_.holes)
      take(boxes_[hole.setup], contour::disc(hole.at, widest(hole) / 2).loops);
    lay_side_by_side();
  }

  [[nodiscard]] std::string drawn() const {
    std::string body;
    for (std::size_t i = 0; i < tree_.features.size(); ++i) body += feature(i);
    for (std::size_t i = 0; i < tree_.holes.size(); ++i) body += hole(i);
    return head() + "<style>" + std::string(kStyle) + "</style>\n<g id=\"part\" transform=\"" +
           "scale(1,-1)\">\n" + body + "</g>\n</svg>\n";
  }

 private:
  static double widest(const Hole& hole) {
    double widest = hole.diameter;
    for (const features::HoleStep& step : hole.steps) widest = std::max(widest, step.diameter);
    return widest;
  }

  void measure(const Feature& feature) {
    Box& box = boxes_[feature.setup];
    take(box, nominal_of(feature));
    if (feature.turned) take(box, feature.turned->removed.loops);
    for (const Layer& layer : feature.layers) {
      take(box, region_of(layer));
      take(box, ways_of(*facts_.recording, layer.cuts));
    }
  }

  // Each set-up has its own zero: nothing says how they lie to each other on the part.
  void lay_side_by_side() {
    double right = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i].is_empty()) continue;
      if (!all_.is_empty()) shifts_[i] = {right + kBetween_mm - boxes_[i].low.u, 0};
      all_.take(boxes_[i].low + shifts_[i]);
      all_.take(boxes_[i].high + shifts_[i]);
      right = all_.high.u;
    }
  }

  [[nodiscard]] std::string head() const {
    const Box box = (all_.is_empty() ? Box{{0, 0}, {0, 0}} : all_).grown(kMargin_mm);
    const auto n = [](double value) { return base::rounded_text(value, 3); };
    const std::string width = n(box.high.u - box.low.u);
    const std::string height = n(box.high.v - box.low.v);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "mm\" height=\"" +
           height + "mm\" viewBox=\"" + n(box.low.u) + " " + n(-box.high.v) + " " + width + " " +
           height + "\">\n<title>" + xml_text(printable(facts_.run.title)) + "</title>\n";
  }

  [[nodiscard]] static std::string path(std::string_view words,
                                        const std::vector<Contour>& contours, Vec2 by) {
    const std::string data = svg_path(contours, by);
    return data.empty() ? "" : fmt::format("<path class={} d=\"{}\"/>\n", words, data);
  }

  [[nodiscard]] std::string group(const std::string& id, std::string_view word,
                                  const std::string& key, const std::vector<Span>& visits,
                                  const std::string& title) const {
    const LineRange lines = first_lines_of(*facts_.recording, visits);
    return fmt::format(
        "<g id=\"{}\" class=\"{}\" data-key=\"{}\" data-lines=\"{}-{}\">\n<title>{}</title>\n", id,
        word, key, lines.first, lines.last, xml_text(title));
  }

  [[nodiscard]] std::string feature(std::size_t place) const {
    const Feature& feature = tree_.features[place];
    std::vector<Span> visits;
    for (const features::Cut& cut : feature.cuts)
      visits.insert(visits.end(), cut.visits.begin(), cut.visits.end());
    const Vec2 by = shifts_[feature.setup];
    std::string text = group(fmt::format("F{}", place + 1), word_of(feature.type), feature.key,
                             visits, feature_title(facts_, place));
    if (feature.turned)
      text += path("\"layer\" data-layer=\"1\"", feature.turned->removed.loops, by);
    for (std::size_t i = 0; i < feature.layers.size(); ++i) {
      text +=
          path(fmt::format("\"layer\" data-layer=\"{}\"", i + 1), region_of(feature.layers[i]), by);
    }
    text += path("\"nominal\"", nominal_of(feature), by);
    for (const Layer& layer : feature.layers)
      text += path("\"tool\"", ways_of(*facts_.recording, layer.cuts), by);
    if (feature.turned) text += path("\"tool\"", ways_of(*facts_.recording, visits), by);
    return text + "</g>\n";
  }

  [[nodiscard]] std::string hole(std::size_t place) const {
    const Hole& hole = tree_.holes[place];
    std::vector<Span> visits;
    for (const features::HoleStep& step : hole.steps)
      visits.insert(visits.end(), step.visits.begin(), step.visits.end());
    const Vec2 by = shifts_[hole.setup];
    std::string text =
        group(fmt::format("H{}", place + 1), "hole", hole.key, visits, hole_title(facts_, place));
    for (std::size_t i = 0; i < hole.steps.size(); ++i) {
      text += path(fmt::format("\"layer\" data-layer=\"{}\"", i + 1),
                   contour::disc(hole.at, hole.steps[i].diameter / 2).loops, by);
    }
    text += path("\"nominal\"", contour::disc(hole.at, hole.diameter / 2).loops, by);
    return text + "</g>\n";
  }

  const FeatureFacts& facts_;
  const features::Tree& tree_;
  std::vector<Box> boxes_;    // of the set-ups
  std::vector<Vec2> shifts_;  // likewise
  Box all_;
};

}  // namespace

std::string features_svg(const FeatureFacts& facts) { return Picture(facts).drawn(); }

}  // namespace kerf::output
