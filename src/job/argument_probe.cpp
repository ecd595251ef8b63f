#include "job/argument_probe.hpp"

#include <algorithm>
#include <cmath>

#include "features/merge/text_style.hpp"
#include "features/path/tolerance.hpp"
#include "job/text_changes.hpp"

namespace kerf::job {
namespace {

using features::Feature;
using features::Hole;
using features::Tree;

constexpr double kSameFeed = 1e-9;
constexpr double kShare = 0.01;
constexpr double kLeast = 0.1;

/// What is changed: by as little as shows.
double other_value(const features::Argument& argument) {
  const bool is_whole = argument.text.find('.') == std::string::npos;
  return *argument.value + (is_whole ? 1 : std::max(kLeast, kShare * std::fabs(*argument.value)));
}

bool is_near(double a, double b) { return std::fabs(a - b) <= features::kSamePoint_mm; }
bool is_near(contour::Vec2 a, contour::Vec2 b) { return is_near(a.u, b.u) && is_near(a.v, b.v); }

contour::Vec2 centre_of(const contour::Contour& contour) {
  const contour::Box box = contour::extents(contour);
  return 0.5 * (box.low + box.high);
}

/// The first layer's, or what is turned.
const contour::Contour& contour_of(const Feature& feature) {
  static const contour::Contour kNone;
  if (feature.turned) return feature.turned->contour;
  return feature.layers.empty() ? kNone : feature.layers.front().contour;
}

/// Of two recognitions of as many things.
class TreeComparison {
 public:
  TreeComparison(const Tree& before, const Tree& after) : before_(before), after_(after) {}

  [[nodiscard]] std::vector<std::string> reached() {
    if (before_.features.size() != after_.features.size() ||
        before_.holes.size() != after_.holes.size())
      return {"count"};
    for (std::size_t i = 0; i < before_.features.size(); ++i)
      compare(before_.features[i], after_.features[i]);
    for (std::size_t i = 0; i < before_.holes.size(); ++i)
      compare(before_.holes[i], after_.holes[i]);
    compare_feeds();
    std::vector<std::string> words;
    const auto add = [&](bool is_it, const char* word) {
      if (is_it) words.emplace_back(word);
    };
    add(moves_, "position");
    add(reshapes_, "contour");
    add(deepens_, "depth");
    add(feeds_, "feed");
    add(layers_, "count");
    if (words.empty()) words.emplace_back("nothing");
    return words;
  }

 private:
  void compare(const Feature& a, const Feature& b) {
    const contour::Contour& one = contour_of(a);
    const contour::Contour& other = contour_of(b);
    layers_ = layers_ || a.layers.size() != b.layers.size();
    deepens_ = deepens_ || !is_near(a.bottom, b.bottom) || !is_near(a.top, b.top);
    reshapes_ = reshapes_ || a.type != b.type || one.vertices.size() != other.vertices.size();
    if (one.vertices.empty() || one.vertices.size() != other.vertices.size()) return;
    const contour::Vec2 by = centre_of(other) - centre_of(one);
    moves_ = moves_ || !is_near(by, {});
    for (std::size_t i = 0; i < one.vertices.size(); ++i) {
      const bool is_there = is_near(one.vertices[i].point + by, other.vertices[i].point) &&
                            is_near(one.vertices[i].bulge, other.vertices[i].bulge);
      reshapes_ = reshapes_ || !is_there;
    }
  }
  void compare(const Hole& a, const Hole& b) {
    moves_ = moves_ || !is_near(a.at, b.at);
    deepens_ = deepens_ || !is_near(a.bottom, b.bottom) || !is_near(a.top, b.top);
    reshapes_ = reshapes_ || !is_near(a.diameter, b.diameter);
    layers_ = layers_ || a.steps.size() != b.steps.size();
  }
  void compare_feeds() {
    const auto is_same = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double one, double other) {
        return std::fabs(one - other) <= kSameFeed * std::max(1.0, std::fabs(one));
      });
    };
    const std::size_t count = std::min(before_.operations.size(), after_.operations.size());
    for (std::size_t i = 0; i < count; ++i) {
      const features::OperationFacts& a = before_.operations[i];
      const features::OperationFacts& b = after_.operations[i];
      feeds_ =
          feeds_ || !is_same(a.cut_feeds, b.cut_feeds) || !is_same(a.entry_feeds, b.entry_feeds);
    }
  }

  const Tree& before_;
  const Tree& after_;
  bool moves_ = false;
  bool reshapes_ = false;
  bool deepens_ = false;
  bool feeds_ = false;
  bool layers_ = false;
};

std::string with_value(const std::string& text, const features::Call& call,
                       const features::Argument& argument) {
  const features::TextStyle style;
  std::string changed = text;
  return changed.replace(start_of_line(text, call.line) + argument.column, argument.text.size(),
                         style.number_like(argument.text, other_value(argument)));
}

}  // namespace

void probe_arguments(const StockJob& job, features::Method method, FeaturesResult& result) {
  const base::SourceSet& sources = result.run->machine().sources();
  for (features::Call& call : result.tree.calls) {
    const base::FileId file = call.block.file;
    if (!sources.contains(file) || sources[file].name() != job.job.program.name) continue;
    std::string text(sources[file].size(), '\0');
    text.resize(sources[file].read(0, text));
    for (features::Argument& argument : call.words.arguments) {
      if (!argument.value) continue;
      StockJob again = job;
      again.job.program =
          base::ProgramText::of(job.job.program.name, with_value(text, call, argument));
      const auto other = recognise_features(again, method);
      if (other && other->status == result.status)
        argument.affects = TreeComparison(result.tree, other->tree).reached();
    }
  }
}

}  // namespace kerf::job
