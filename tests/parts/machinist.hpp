#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mill_cam.hpp"
#include "random_part.hpp"
#include "seeded_random.hpp"

namespace kerf::parts {

using features::FeatureType;
using features::RelationKind;
using Parent = std::optional<std::pair<std::size_t, RelationKind>>;

inline constexpr int kDrill = 9;

/// What may be machined where: a disc about a middle, from a height.
struct Room {
  Vec2 middle{};
  double radius = 40;
  double top = 0;
  Parent parent{};
};

/// Who machines a part: his dice, his tools, and how he writes.
class Machinist {
 protected:
  explicit Machinist(std::uint64_t seed)
      : random_(static_cast<unsigned>(seed)), posted_(style_of_text()) {
    part_.zero = style_.zero;
    for (int i = 0; i < 3; ++i) add_tool(i + 1, stock::ToolKind::flat, random_.in(4, 12));
    add_tool(kDrill, stock::ToolKind::drill, random_.in(3, 9));
  }

  TextStyle style_of_text() {
    style_.has_numbers = random_.coin();
    style_.has_blanks = random_.coin();
    style_.repeats_g = random_.coin();
    style_.is_incremental = random_.count(0, 3) == 0;
    style_.has_radius = random_.count(0, 3) == 0;
    style_.is_inch = random_.count(0, 3) == 0;
    if (random_.coin())
      style_.zero = {std::round(random_.in(5, 90)), std::round(random_.in(5, 90))};
    return style_;
  }

  void add_tool(int number, stock::ToolKind kind, double diameter) {
    stock::Tool tool;
    tool.number = number;
    tool.kind = kind;
    tool.source = stock::ToolSource::file;
    tool.measures.set(stock::Measure::diameter, std::round(diameter * 100) / 100);
    tool.measures.set(stock::Measure::flute_length, 60);
    part_.tools.push_back(tool);
  }

  double radius_of(int number) const {
    for (const stock::Tool& tool : part_.tools) {
      if (tool.number == number) return tool.value(stock::Measure::diameter).value_or(0) / 2;
    }
    return 0;
  }

  void use(int number) {
    if (number == tool_) return;
    tool_ = number;
    posted_.tool(number, 3000);
  }
  // The largest mill at hand that is no larger.
  bool use_mill(double most_radius) {
    std::vector<int> fitting;
    for (int number = 1; number <= 3; ++number) {
      if (radius_of(number) <= most_radius) fitting.push_back(number);
    }
    if (fitting.empty()) return false;
    const bool stays = std::find(fitting.begin(), fitting.end(), tool_) != fitting.end();
    if (!stays || random_.count(0, 2) == 0)
      use(fitting[static_cast<std::size_t>(
          random_.count(0, static_cast<int>(fitting.size()) - 1))]);
    return true;
  }
  double radius() const { return radius_of(tool_); }

  Way random_way() {
    Way way;
    way.is_inside_out = random_.coin();
    way.climbs = random_.coin();
    way.retracts = random_.count(0, 3) == 0;
    way.step = random_.in(0.5, 0.9) * radius();
    return way;
  }

  std::vector<double> random_layers(double top, double most = 3) {
    std::vector<double> layers;
    const double step = std::round(random_.in(1, most) * 100) / 100;
    for (int i = random_.count(1, 3); i > 0; --i) layers.push_back(top -= step);
    return layers;
  }

  void note(const std::string& what) { part_.made_of += what + "; "; }

  // What has been machined there is the parent of what comes into it.
  std::size_t want(WantedFeature feature, const Room& room) {
    feature.top = room.top;
    feature.parent = room.parent;
    part_.features.push_back(std::move(feature));
    return part_.features.size() - 1;
  }

  RandomPart part_{};
  test::SeededRandom random_;
  TextStyle style_{};
  Posted posted_;
  int tool_ = 0;
};

}  // namespace kerf::parts
