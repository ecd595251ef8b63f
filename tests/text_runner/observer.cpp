#include "observer.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include "base/decimal.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::test {
namespace {

using namespace motion;

constexpr double kTolerance = 6e-4;  // half an increment and a little

std::string number(double value) { return base::number_text(value); }

const char* plane_name(Plane plane) {
  return plane == Plane::xy ? "XY" : plane == Plane::zx ? "ZX" : "YZ";
}

std::string plane_name(const Surface& surface, const AxisSetup& axes) {
  return {axes[surface.first].letter, axes[surface.rotary].letter};
}

// As people count it.
std::array<double, 2> centre_of(const Arc& arc, const AxisSetup& axes) {
  const auto plane = plane_axes(arc.plane, axes);
  return {arc.center[0] * axes[plane->first].count_per_mm(),
          arc.center[1] * axes[plane->second].count_per_mm()};
}
std::array<double, 2> centre_of(const SurfaceMove& move, const AxisSetup& axes) {
  return {move.about[0] * axes[move.surface.first].count_per_mm(), move.about[1]};
}

struct Describe {
  const AxisSetup& axes;

  std::string target(const base::TipPoint& to) const {
    std::string text;
    for (std::size_t i = 0; i < axes.count(); ++i)
      text += std::string(" ") + axes.axes[i].letter +
              number(to.values[i] * axes.axes[i].count_per_mm());
    return text;
  }
  std::string centre(const Arc& a) const {
    const auto at = centre_of(a, axes);
    return number(at[0]) + "," + number(at[1]);
  }
  std::string operator()(const Rapid& a) const { return "rapid" + target(a.to); }
  std::string operator()(const Line& a) const {
    return "line" + target(a.to) + " F" + number(a.feed.value);
  }
  std::string operator()(const Arc& a) const {
    return (a.direction == Direction::clockwise ? "cw" : "ccw") + target(a.to) + " @" + centre(a) +
           " " + plane_name(a.plane) + " F" + number(a.feed.value);
  }
  std::string operator()(const SurfaceMove& a) const {
    if (!a.is_arc) return "line" + target(a.to) + " F" + number(a.feed.value);
    const auto centre = centre_of(a, axes);
    return (a.direction == Direction::clockwise ? "cw" : "ccw") + target(a.to) + " @" +
           number(centre[0]) + "," + number(centre[1]) + " " + plane_name(a.surface, axes) + " F" +
           number(a.feed.value);
  }
  std::string operator()(const SpaceArc& a) const {
    return "space-arc" + target(a.to) + " via" + target(a.via) + " F" + number(a.feed.value);
  }
  std::string operator()(const Probe& a) const {
    return "probe" + target(a.to) + " F" + number(a.feed.value);
  }
  std::string operator()(const Thread& a) const {
    return "thread" + target(a.to) + " F" + number(a.lead);
  }
  std::string operator()(const Dwell& a) const { return "dwell " + number(a.seconds); }
  std::string operator()(const ToolChange& a) const { return "tool " + std::to_string(a.tool); }
  std::string operator()(const Spindle& a) const {
    const std::string name =
        a.name == SpindleName::main ? "spindle" : std::string(name_of(a.name)) + " spindle";
    switch (a.turning) {
      case Spindle::Turning::clockwise: return name + " cw " + number(a.speed);
      case Spindle::Turning::counterclockwise: return name + " ccw " + number(a.speed);
      case Spindle::Turning::stopped: return name + " stop";
      case Spindle::Turning::oriented: return name + " orient";
    }
    return name;
  }
  std::string operator()(const Coolant& a) const {
    return a.state == Coolant::State::off    ? "coolant off"
           : a.state == Coolant::State::mist ? "coolant mist"
                                             : "coolant flood";
  }
  std::string operator()(const Power& a) const {
    return "power " + number(a.percent) +
           (a.frequency_hz > 0 ? " at " + number(a.frequency_hz) + " Hz" : "");
  }
  std::string operator()(const AuxiliaryCode& a) const { return "mcode " + std::to_string(a.code); }
  std::string operator()(const Stop&) const { return "stop"; }
  std::string operator()(const Message& a) const { return "message " + std::string(a.text.view()); }
  std::string operator()(const End&) const { return "end"; }
};

bool near(double a, double b) { return std::fabs(a - b) <= kTolerance; }

double value_of(const std::string& word, std::size_t from) {
  return std::strtod(word.c_str() + from, nullptr);
}

std::string check_centre(const std::string& word, const Motion& motion, const AxisSetup& axes) {
  const auto* const arc = std::get_if<Arc>(&motion.action);
  const auto* const on_surface = std::get_if<SurfaceMove>(&motion.action);
  const std::size_t comma = word.find(',');
  const bool is_arc = arc != nullptr || (on_surface != nullptr && on_surface->is_arc);
  if (!is_arc || comma == std::string::npos) return "it is no arc";
  const auto at = arc != nullptr ? centre_of(*arc, axes) : centre_of(*on_surface, axes);
  if (near(at[0], value_of(word, 1)) && near(at[1], value_of(word, comma + 1))) return {};
  return "its centre differs";
}

bool is_rapid(const Motion& motion, bool linear) {
  const auto* const rapid = std::get_if<Rapid>(&motion.action);
  return rapid != nullptr && rapid->linear == linear;
}

// How a move is made, in a word each.
struct Manner {
  const char* word;
  bool (*holds)(const Motion&);
};
constexpr Manner kManners[] = {
    {"stop", [](const Motion& motion) { return motion.exact_stop; }},
    {"pass", [](const Motion& motion) { return !motion.exact_stop; }},
    {"fixed", [](const Motion& motion) { return motion.fixed_override; }},
    {"free", [](const Motion& motion) { return !motion.fixed_override; }},
    {"linear", [](const Motion& motion) { return is_rapid(motion, true); }},
    {"nonlinear", [](const Motion& motion) { return is_rapid(motion, false); }},
};

std::string manner_of(const Motion& motion) {
  return std::string(motion.exact_stop ? " stop" : "") + (motion.fixed_override ? " fixed" : "") +
         (is_rapid(motion, false) ? " nonlinear" : "");
}

std::string check_word(const std::string& word, const Motion& motion, const AxisSetup& axes) {
  for (const Manner& manner : kManners) {
    if (word == manner.word) return manner.holds(motion) ? "" : "it is not " + word;
  }
  if (word[0] == '@') return check_centre(word, motion, axes);
  if (word.size() == 2 && std::isalpha(static_cast<unsigned char>(word[1])) != 0) {
    const auto* const arc = std::get_if<Arc>(&motion.action);
    const auto* const on_surface = std::get_if<SurfaceMove>(&motion.action);
    const std::string plane = arc != nullptr          ? plane_name(arc->plane)
                              : on_surface != nullptr ? plane_name(on_surface->surface, axes)
                                                      : "";
    return word == plane ? "" : "its plane differs";
  }
  if (word[0] == 'F') {
    double feed = -1;
    std::visit(
        [&](const auto& action) {
          if constexpr (requires { action.feed; }) feed = action.feed.value;
          if constexpr (requires { action.lead; }) feed = action.lead;
        },
        motion.action);
    return near(feed, value_of(word, 1)) ? "" : "its feed differs";
  }
  const auto axis = axes.find(word[0]);
  const base::TipPoint* const to = target_of(motion);
  if (!axis || to == nullptr) return "there is no axis " + word.substr(0, 1);
  const double counted = (*to)[*axis] * axes[*axis].count_per_mm();
  return near(counted, value_of(word, 1)) ? "" : word.substr(0, 1) + " differs";
}

}  // namespace

void Recorder::take(const Motion& motion) {
  observed_.push_back({motion.block.line, target_of(motion) != nullptr,
                       std::visit(Describe{axes_}, motion.action) + manner_of(motion), motion});
}

std::string difference(const std::string& wanted, const Observed& observed, const AxisSetup& axes) {
  std::istringstream words(wanted);
  std::string kind;
  words >> kind;
  if (observed.text.substr(0, observed.text.find(' ')) != kind) return "it is no " + kind;
  for (std::string word; words >> word;) {
    const std::string wrong = check_word(word, observed.motion, axes);
    if (!wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace kerf::test
