#include "process/internal/recipe_check.hpp"

#include <algorithm>
#include <set>

#include "process/keys.hpp"

namespace kerf::process {
namespace {

constexpr std::size_t kMostCopies = 100'000;

/// Tells what does not go together, each at the key that says it.
class RecipeCheck {
 public:
  RecipeCheck(const Recipe& recipe, const KeyPlace& place) : recipe_(recipe), place_(place) {}

  Diagnostics made() {
    check_place();
    check_image_size();
    check_array();
    check_texts();
    check_wrap();
    for (std::size_t i = 0; i < recipe_.operations.size(); ++i) {
      at_ = "operation." + std::to_string(i);
      check_operation(recipe_.operations[i]);
    }
    return std::move(found_);
  }

 private:
  void require(bool holds, const std::string& path, const std::string& sentence) {
    if (!holds) found_.push_back(make_error(base::Code::job_value, place_(path), sentence));
  }
  void of_operation(bool holds, std::string_view key, const std::string& sentence) {
    if (!holds) require(false, at_ + '.' + std::string(key), title_ + ": " + sentence);
  }

  void check_place() {
    const bool is_scaled = recipe_.place.scale != std::array{1.0, 1.0};
    require(!recipe_.place.fit || !is_scaled, "place.fit",
            "[place] has scale or fit: fit says how large it becomes");
  }

  void check_image_size() {
    const ImageWords& image = recipe_.image;
    require(!image.dpi || (!image.width && !image.height), "image.dpi",
            "[image] has width and height, or dpi");
  }

  void check_array() {
    const Array& array = recipe_.array;
    require(array.count == 0 || (array.columns == 1 && array.rows == 1), "array.count",
            "[array] has columns and rows, or count");
    require(array.copies() <= kMostCopies, "array",
            "[array] makes " + std::to_string(array.copies()) + " copies; 100000 are the most");
  }

  void check_texts() {
    for (std::size_t i = 0; i < recipe_.text.lines.size(); ++i) {
      require(!recipe_.text.lines[i].words.empty(), "text.line." + std::to_string(i),
              "[[text.line]] needs its text");
    }
  }

  void check_wrap() {
    const Wrap& wrap = recipe_.wrap;
    const bool is_round = wrap.shape == Wrap::Shape::cylinder || wrap.shape == Wrap::Shape::sphere;
    require(!is_round || wrap.radius > 0, "wrap", "[wrap] needs its radius");
    require(wrap.shape != Wrap::Shape::cone || wrap.half_angle_deg > 0, "wrap",
            "[wrap] needs the half_angle of its cone");
  }

  void check_operation(const Operation& operation) {
    title_ = "operation " + operation.name;
    of_operation(names_.insert(operation.name).second, "name",
                 "another one has that name; --job-set could not tell them apart");
    check_power(operation);
    check_ways(operation);
    check_drill(operation);
    check_curves(operation);
  }

  void check_power(const Operation& operation) {
    of_operation(operation.ton_ms.has_value() == operation.toff_ms.has_value(),
                 operation.ton_ms ? "ton_ms" : "toff_ms", "ton_ms and toff_ms are said together");
    of_operation(!operation.ton_ms || !operation.power_percent, "ton_ms",
                 "power, or ton_ms and toff_ms, not both");
    of_operation(!operation.ton_ms || !operation.frequency_hz, "ton_ms",
                 "frequency_hz, or ton_ms and toff_ms, not both");
    of_operation(!operation.feed || !operation.ms_per_mm, "ms_per_mm",
                 "feed or ms_per_mm, not both");
  }

  void check_lead(const Lead& lead, std::string_view key) {
    of_operation(lead.kind != Lead::Kind::line || lead.length_mm > 0, key,
                 std::string(key) + " of a line needs its length");
    of_operation(lead.kind != Lead::Kind::arc || lead.radius_mm > 0, key,
                 std::string(key) + " of an arc needs its radius");
  }

  void check_ways(const Operation& operation) {
    check_lead(operation.lead_in, "lead_in");
    check_lead(operation.lead_out, "lead_out");
    const Tabs& tabs = operation.tabs;
    of_operation(!tabs.count || !tabs.spacing_mm, "tabs", "tabs have count or spacing, not both");
    of_operation(tabs.are_asked_for() || tabs.width_mm == 0, "tabs", "tabs need count or spacing");
    const Weave& weave = operation.weave;
    of_operation(weave.shape == Weave::Shape::none || (weave.width_mm > 0 && weave.pitch_mm > 0),
                 "weave", "weave needs width and pitch");
  }

  void check_drill(const Operation& operation) {
    of_operation(!operation.pulses || !operation.dwell_s, "pulses", "pulses or dwell_s, not both");
    of_operation(!operation.pulses || operation.ton_ms, "pulses", "pulses need ton_ms and toff_ms");
  }

  void check_curves(const Operation& operation) {
    const auto goes_back = [](const auto& a, const auto& b) { return a.first >= b.first; };
    const auto ascends = [&](const auto& list) {
      return std::adjacent_find(list.begin(), list.end(), goes_back) == list.end();
    };
    const auto is_share = [](const auto& point) {
      return point.first >= 0 && point.first <= 1 && point.second >= 0 && point.second <= 1;
    };
    const auto& curve = operation.curve;
    of_operation(
        !curve.empty() && ascends(curve) && std::all_of(curve.begin(), curve.end(), is_share),
        "curve", "curve has pairs from 0 to 1, the first of each ascending");
    of_operation(ascends(operation.scan_offset), "scan_offset", "the feeds of scan_offset ascend");
  }

  const Recipe& recipe_;
  const KeyPlace& place_;
  Diagnostics found_;
  std::set<std::string> names_;
  std::string at_;
  std::string title_;
};

}  // namespace

Diagnostics check_recipe(const Recipe& recipe, const KeyPlace& place) {
  return RecipeCheck(recipe, place).made();
}

}  // namespace kerf::process
