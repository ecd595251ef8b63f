#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "machine/definition/tools/internal/json_text.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"
#include "machine/definition/tools/internal/zip_archive.hpp"
#include "machine/definition/tools/tool_words.hpp"

namespace kerf::machine {
namespace {

using Json = nlohmann::json;
using stock::Measure;
using stock::Tool;
using stock::ToolKind;

struct Type {
  std::string_view name;
  std::string_view type;
};
constexpr std::array<Type, 19> kTypes = {{{"flat end mill", "flat"},
                                          {"ball end mill", "ball"},
                                          {"bull nose end mill", "bull"},
                                          {"chamfer mill", "chamfer"},
                                          {"tapered mill", "taper"},
                                          {"drill", "drill"},
                                          {"spot drill", "spot"},
                                          {"center drill", "spot"},
                                          {"countersink", "countersink"},
                                          {"counter bore", "flat"},
                                          {"reamer", "reamer"},
                                          {"tap right hand", "tap"},
                                          {"tap left hand", "tap"},
                                          {"face mill", "face"},
                                          {"slot mill", "t-slot"},
                                          {"dovetail mill", "dovetail"},
                                          {"lollipop mill", "lollipop"},
                                          {"thread mill", "thread-mill"},
                                          {"probe", "probe"}}};

const Json* member(const Json& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string text_at(const Json& object, std::string_view key) {
  const Json* const value = member(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

/// A length is scaled, an angle is not.
std::optional<double> number_at(const Json& object, std::string_view key, double scale = 1) {
  const Json* const value = member(object, key);
  if (value == nullptr || !value->is_number()) return {};
  return value->get<double>() * scale;
}

std::vector<stock::Segment> segments_of(const Json* holder, double scale) {
  std::vector<stock::Segment> stack;
  const Json* const list = holder != nullptr ? member(*holder, "segments") : nullptr;
  if (list == nullptr || !list->is_array() || list->size() > 1000) return stack;
  for (const Json& each : *list) {
    const stock::Segment segment{number_at(each, "height", scale).value_or(0),
                                 number_at(each, "lower-diameter", scale).value_or(0),
                                 number_at(each, "upper-diameter", scale).value_or(0)};
    const bool is_body = segment.height > 0 && segment.lower > 0 && segment.upper > 0;
    if (is_body) stack.push_back(segment);
  }
  return stack;
}

/// One tool of a library: what its fields say, in mm.
class FusionTool {
 public:
  FusionTool(const Json& data, const Json& geometry, double scale)
      : data_(data), geometry_(geometry), scale_(scale) {}

  Tool read(std::string_view type, int number) {
    tool_.number = number;
    tool_.name = text_at(data_, "description").substr(0, 200);
    set_type(tool_, type);
    set_sizes();
    set_angles();
    set_necks();
    set_bodies();
    const Json* const hand = member(geometry_, "HAND");
    const bool is_left = hand != nullptr && hand->is_boolean() && !hand->get<bool>();
    if (is_left || text_at(data_, "type") == "tap left hand") tool_.hand = stock::Hand::left;
    return tool_;
  }

 private:
  [[nodiscard]] std::optional<double> length(std::string_view key) const {
    return number_at(geometry_, key, scale_);
  }
  void set(Measure measure, std::optional<double> value) { set_where_fit(tool_, measure, value); }

  void set_sizes() {
    set(Measure::diameter, length("DC"));
    set(Measure::flute_length, length("LCF"));
    set(Measure::stickout, length("LB"));
    set(Measure::length, length("assemblyGaugeLength"));
    set(Measure::flutes, number_at(geometry_, "NOF"));
    set(Measure::corner_radius, length("RE"));
    set(Measure::tip_radius, length("RE"));
    set(Measure::pitch, length("TP"));
    // A corner makes the ball of a tapered mill.
    if (!tool_.said(Measure::tip_radius)) set(Measure::tip_diameter, length("tip-diameter"));
  }

  // TA is from the axis to the side.
  void set_angles() {
    const auto whole = number_at(geometry_, "SIG");
    const auto side = number_at(geometry_, "TA");
    const bool has_side = side && *side > 0;
    if (tool_.kind == ToolKind::dovetail || tool_.kind == ToolKind::face) {
      const Measure measure =
          tool_.kind == ToolKind::face ? Measure::entering_angle : Measure::angle;
      if (has_side) set(measure, 90 - *side);
      return;
    }
    if (has_side) set(Measure::angle, 2 * *side);
    set(Measure::angle, whole);
  }

  void set_necks() {
    const auto shoulder = length("shoulder-diameter");
    set(Measure::neck_diameter, shoulder && *shoulder > 0 ? shoulder : length("SFDM"));
    if (tool_.kind == ToolKind::t_slot) set(Measure::width, length("LCF"));
    if (tool_.kind == ToolKind::dovetail) set(Measure::height, length("LCF"));
    if (tool_.kind == ToolKind::face) set(Measure::ap_max, length("LCF"));
  }

  // Shoulder, shaft and shank stand on the flutes, the holder where the body ends.
  void set_bodies() {
    const auto flutes = tool_.said(Measure::flute_length);
    const auto stickout = tool_.said(Measure::stickout);
    if (flutes) add_shank(*flutes, stickout.value_or(0));
    if (stickout) tool_.holder = segments_of(member(data_, "holder"), scale_);
  }

  void add_shank(double from, double stickout) {
    const double shoulder = length("shoulder-length").value_or(0);
    const double neck = length("shoulder-diameter").value_or(0);
    double top = from;
    if (shoulder > from && neck > 0) {
      tool_.shank.push_back({shoulder - from, neck, neck});
      top = shoulder;
    }
    for (const stock::Segment& each : segments_of(member(data_, "shaft"), scale_)) {
      tool_.shank.push_back(each);
      top += each.height;
    }
    const double shank = length("SFDM").value_or(0);
    if (stickout > top && shank > 0) tool_.shank.push_back({stickout - top, shank, shank});
  }

  const Json& data_;
  const Json& geometry_;
  double scale_;
  Tool tool_;
};

int number_of(const Json& data) {
  const Json* const post = member(data, "post-process");
  const auto number = post != nullptr ? number_at(*post, "number") : std::nullopt;
  const bool fits = number && *number >= 1 && *number <= 99999999;
  return fits ? static_cast<int>(*number) : 0;
}

void add_tool(const Json& data, LibraryBuilder& builder) {
  const std::string name = text_at(data, "type");
  if (name == "holder") return;
  const int number = number_of(data);
  const auto* const type = std::find_if(kTypes.begin(), kTypes.end(),
                                        [&](const Type& each) { return each.name == name; });
  if (type == kTypes.end())
    return builder.remark(number, "type \"" + name.substr(0, 40) + "\" is not understood");
  const Json* const geometry = member(data, "geometry");
  if (geometry == nullptr) return builder.remark(number, "it has no geometry");
  const std::string unit = text_at(data, "unit");
  if (unit != "millimeters" && unit != "inches")
    return builder.remark(number, "unit \"" + unit.substr(0, 40) + "\" is not understood");
  builder.add(
      FusionTool(data, *geometry, unit == "inches" ? kMmPerInch : 1).read(type->type, number));
}

}  // namespace

base::Outcome<ToolLibrary> read_fusion(const std::string& text, const std::string& path) {
  if (is_zip(text)) {
    auto inner = json_in_zip(text, kLargestToolFile);
    if (!inner) return unreadable(path, inner.error());
    return is_zip(*inner) ? unreadable(path, "its JSON is none") : read_fusion(*inner, path);
  }
  const Json library = parse_library(text);
  const Json* const data = member(library, "data");
  if (data == nullptr || !data->is_array()) return unreadable(path, "this is no library of tools");
  LibraryBuilder builder;
  for (const Json& each : *data) {
    if (builder.is_full()) return unreadable(path, "there are too many tools");
    add_tool(each, builder);
  }
  return builder.take();
}

}  // namespace kerf::machine
