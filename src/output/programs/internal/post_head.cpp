#include "output/programs/internal/post_head.hpp"

#include "base/decimal.hpp"
#include "output/programs/internal/block_text.hpp"

namespace kerf::output {
namespace {

std::string comment(const std::string& text) { return "(" + comment_text(text) + ")\n"; }

std::string machine_line(const machine::MachineDefinition& machine) {
  std::string text = "MACHINE: " + machine.name + ", AXES";
  for (const motion::AxisConfig& axis : machine.axes.axes) text += std::string(" ") + axis.letter;
  return comment(text);
}

std::string travel_lines(const PostFacts& facts) {
  std::string lines;
  const auto& axes = facts.machine.axes.axes;
  for (std::size_t i = 0; facts.travel && i < axes.size(); ++i) {
    const double count = axes[i].count_per_mm();
    lines += comment(std::string("TRAVEL: ") + axes[i].letter + " " +
                     post_number(post_rounded(facts.travel->low.values[i] * count)) + " TO " +
                     post_number(post_rounded(facts.travel->high.values[i] * count)));
  }
  return lines;
}

std::string lost_lines(const LostThings& lost) {
  std::string lines;
  for (const LostThings::Kind& kind : lost.kinds()) {
    lines += comment("LOST: " + kind.what + ", " + std::to_string(kind.count) +
                     "X, FIRST OF LINE " + std::to_string(kind.line));
  }
  return lines;
}

}  // namespace

std::string post_head(const PostFacts& facts) {
  const machine::LaserSettings& laser = facts.machine.drive.laser;
  std::string text = comment("KERF POST OF " + facts.program) + machine_line(facts.machine);
  text += comment("FOR CONTROLS OF PLAIN G-CODE: NO MACROS, NO CYCLES");
  text += comment("UNITS: MM, DEGREES, MM/MIN, SECONDS");
  text += comment("PATH OF THE TOOL CENTRE IN MACHINE COORDINATES");
  text += facts.has_lengths ? comment("TOOL LENGTHS ARE ADDED: RUN IT WITHOUT TOOL OFFSETS")
                            : comment("NO TOOL LENGTH IS ADDED");
  if (laser.fitted())
    text += comment("LASER: FULL POWER IS S" + base::number_text(laser.s_of_full_power));
  return text + travel_lines(facts) + lost_lines(facts.lost) + "G21 G90 G94 G17\nM5\n";
}

std::string lathe_head(const PostFacts& facts) {
  std::string text = comment("KERF POST OF " + facts.program) + machine_line(facts.machine);
  text += comment("FOR LATHES OF G-CODE SYSTEM A: NO MACROS, NO CYCLES");
  text += comment("UNITS: MM, X IS A DIAMETER, DEGREES, MM/MIN OR MM/REV");
  text += comment("PATH OF THE TIP IN MACHINE COORDINATES: NO WORK OFFSETS");
  text += comment("TOOL OFFSETS ARE THOSE OF THE CONTROL, BY T");
  return text + travel_lines(facts) + lost_lines(facts.lost) + "G21 G18 G40 G97 G98\nM5\n";
}

std::string lathe_positioning(const motion::AxisSetup& axes, const base::TipPoint& corner) {
  std::string text;
  const auto go = [&](base::Axis axis) {
    text += BlockText()
                .code("G0")
                .number(axes[axis].letter, post_rounded(corner[axis] * axes[axis].count_per_mm()))
                .text() +
            "\n";
  };
  const auto x = axes.find('X');
  if (x) go(*x);
  for (std::size_t i = 0; i < axes.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (axis != x) go(axis);
  }
  return text;
}

std::string positioning(const motion::AxisSetup& axes, const base::TipPoint& first,
                        double level_mm) {
  const auto z = axes.find('Z');
  std::string text;
  BlockText block;
  const auto end = [&] {
    if (!block.empty()) text += "G0 " + block.text() + "\n";
    block.clear();
  };
  if (z) block.number('Z', post_rounded(level_mm));
  end();
  for (const bool rotary : {true, false}) {
    for (std::size_t i = 0; i < axes.count(); ++i) {
      const motion::AxisConfig& axis = axes.axes[i];
      if (axis.rotary == rotary && axis.letter != 'Z')
        block.number(axis.letter, post_rounded(first.values[i]));
    }
    end();
  }
  if (z && post_rounded(first[*z]) != post_rounded(level_mm))
    block.number('Z', post_rounded(first[*z]));
  end();
  return text;
}

}  // namespace kerf::output
