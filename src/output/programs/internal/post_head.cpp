#include "output/programs/internal/post_head.hpp"

#include <algorithm>
#include <cctype>

#include "base/decimal.hpp"
#include "output/programs/internal/block_text.hpp"
#include "output/programs/internal/post_body.hpp"

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

bool is_number(std::string_view name) {
  return name.size() > 1 && name[0] == 'O' &&
         std::all_of(name.begin() + 1, name.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Of a tape; nothing where the flavour has none.
std::string tape_lines(const PostFacts& facts) {
  if (!facts.flavour.is_framed) return {};
  const std::string number = is_number(facts.program) ? facts.program : "O0001";
  return "%\n" + number + " (" + comment_text(facts.program) + ")\n";
}

std::string length_line(const PostFacts& facts) {
  if (!facts.has_lengths) return comment("NO TOOL LENGTH IS ADDED");
  switch (facts.flavour.lengths) {
    case PostFlavour::Lengths::added:
      return comment("TOOL LENGTHS ARE ADDED: RUN IT WITHOUT TOOL OFFSETS");
    case PostFlavour::Lengths::dynamic:
      return comment("TOOL LENGTHS BY G43.1, AGAINST THAT OF THE FIRST TOOL");
    case PostFlavour::Lengths::of_table:
      return comment("TOOL LENGTHS ARE THOSE OF THE TABLE, BY H");
  }
  return {};
}

std::string mode_lines(const PostFacts& facts, std::string_view modes) {
  std::string block(modes);
  const double tolerance_mm = post_rounded(facts.machine.interpolator.tolerance_mm);
  if (facts.flavour.has_tolerance)
    block += tolerance_mm > 0 ? " G64 P" + post_number(tolerance_mm) : " G61";
  return spelled(facts.flavour, block) + "\n" + spelled(facts.flavour, "M5") + "\n";
}

}  // namespace

std::string post_head(const PostFacts& facts) {
  const machine::LaserSettings& laser = facts.machine.drive.laser;
  std::string text = tape_lines(facts) + comment("KERF POST OF " + facts.program);
  text += machine_line(facts.machine) + comment("FOR " + std::string(facts.flavour.controls));
  text += comment("UNITS: MM, DEGREES, MM/MIN, SECONDS");
  text += comment("PATH OF THE TOOL CENTRE IN MACHINE COORDINATES");
  text += length_line(facts);
  if (laser.fitted())
    text += comment("LASER: FULL POWER IS S" + base::number_text(laser.s_of_full_power));
  return text + travel_lines(facts) + lost_lines(facts.lost) +
         mode_lines(facts, facts.flavour.modes);
}

std::string lathe_head(const PostFacts& facts) {
  std::string text = tape_lines(facts) + comment("KERF POST OF " + facts.program);
  text += machine_line(facts.machine);
  text += comment("FOR LATHES OF G-CODE SYSTEM A: NO MACROS, NO CYCLES");
  text += comment("UNITS: MM, X IS A DIAMETER, DEGREES, MM/MIN OR MM/REV");
  text += comment("PATH OF THE TIP IN MACHINE COORDINATES: NO WORK OFFSETS");
  text += comment("TOOL OFFSETS ARE THOSE OF THE CONTROL, BY T");
  return text + travel_lines(facts) + lost_lines(facts.lost) +
         mode_lines(facts, facts.flavour.lathe_modes);
}

std::string lathe_positioning(const motion::AxisSetup& axes, const PostFlavour& flavour,
                              const base::TipPoint& corner) {
  std::string text;
  const auto go = [&](base::Axis axis) {
    const double value = post_rounded(corner[axis] * axes[axis].count_per_mm());
    text += spelled(flavour, BlockText().code("G0").number(axes[axis].letter, value).text()) + "\n";
  };
  const auto x = axes.find('X');
  if (x) go(*x);
  for (std::size_t i = 0; i < axes.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (axis != x) go(axis);
  }
  return text;
}

std::string positioning(const Beginning& beginning) {
  const motion::AxisSetup& axes = beginning.axes;
  const PostFlavour& flavour = beginning.flavour;
  const auto z = axes.find('Z');
  std::string text;
  BlockText block;
  const auto end = [&] {
    if (!block.empty()) text += spelled(flavour, "G0 " + block.text()) + "\n";
    block.clear();
  };
  if (!beginning.length_words.empty() && flavour.length_with_move) {
    block.code(beginning.length_words);
  } else if (!beginning.length_words.empty()) {
    text += beginning.length_words + "\n";
  }
  if (z) block.number('Z', post_rounded(beginning.level_mm));
  end();
  for (const bool rotary : {true, false}) {
    for (std::size_t i = 0; i < axes.count(); ++i) {
      const motion::AxisConfig& axis = axes.axes[i];
      const bool is_said = base::contains(beginning.said, base::Axis{static_cast<std::uint8_t>(i)});
      if (is_said && axis.rotary == rotary && axis.letter != 'Z')
        block.number(axis.letter, post_rounded(beginning.first.values[i]));
    }
    end();
  }
  if (z && post_rounded(beginning.first[*z]) != post_rounded(beginning.level_mm))
    block.number('Z', post_rounded(beginning.first[*z]));
  end();
  return text;
}

}  // namespace kerf::output
