#pragma once

#include <cstdint>

#include "features/path/recorder.hpp"

namespace kerf::test {

/// Makes recordings of a mill by saying where its tool goes: a block of its own for each word, its
/// line counted from 1.
class FeaturePath : public features::ModeSource {
 public:
  FeaturePath() : axes_(mill()), recorder_(axes_, *this) {}

  [[nodiscard]] const features::Modes& modes() override { return now; }
  features::Modes now;

  FeaturePath& tool(std::uint32_t number, double diameter,
                    stock::ToolKind kind = stock::ToolKind::flat) {
    stock::Tool tool;
    tool.number = static_cast<int>(number);
    tool.kind = kind;
    tool.measures.set(stock::Measure::diameter, diameter);
    recorder_.recording().tools.emplace(number, tool);
    return act(motion::ToolChange{number});
  }
  FeaturePath& spindle(double rpm) {
    motion::Spindle spindle;
    spindle.turning = motion::Spindle::Turning::clockwise;
    spindle.speed = rpm;
    return act(spindle);
  }
  FeaturePath& rapid(double x, double y, double z) { return act(motion::Rapid{at(x, y, z)}); }
  FeaturePath& line(double x, double y, double z) {
    return act(motion::Line{at(x, y, z), motion::Feed{feed_, motion::FeedMode::per_minute}});
  }
  FeaturePath& arc(double x, double y, double z, double centre_x, double centre_y,
                   motion::Direction direction) {
    motion::Arc arc{};
    arc.to = at(x, y, z);
    arc.center = {centre_x, centre_y};
    arc.feed = motion::Feed{feed_, motion::FeedMode::per_minute};
    arc.direction = direction;
    return act(arc);
  }
  FeaturePath& feed(double feed) {
    feed_ = feed;
    return *this;
  }
  [[nodiscard]] const features::Recording& recording() const { return recorder_.recording(); }
  [[nodiscard]] features::Recording& recording() { return recorder_.recording(); }

 private:
  static motion::AxisSetup mill() {
    motion::AxisSetup setup;
    for (const char letter : {'X', 'Y', 'Z'}) {
      motion::AxisConfig axis;
      axis.letter = letter;
      axis.rapid_per_min = 1;
      setup.axes.push_back(axis);
    }
    return setup;
  }
  static base::TipPoint at(double x, double y, double z) { return base::TipPoint{x, y, z}; }

  template <typename Action>
  FeaturePath& act(const Action& action) {
    motion::Motion motion;
    motion.action = action;
    motion.block.line = ++line_;
    motion.block.file = base::FileId{0};
    recorder_.take(motion);
    return *this;
  }

  motion::AxisSetup axes_;
  features::Recorder recorder_;
  std::uint32_t line_ = 0;
  double feed_ = 300;
};

}  // namespace kerf::test
