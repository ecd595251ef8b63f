#include "stock/tool/internal/tool_body.hpp"

#include <algorithm>
#include <optional>

#include "base/decimal.hpp"
#include "stock/tool/internal/angles.hpp"
#include "stock/tool/internal/cutting_shape.hpp"
#include "stock/tool/internal/outline.hpp"

namespace kerf::stock {
namespace {

using M = Measure;

// Files say heights with four digits or five: what is off by less has been rounded.
constexpr double kRounded_mm = 1e-3;

/// What stands on the cutting part, from below to above.
class BodyBuilder {
 public:
  BodyBuilder(const Tool& tool, CuttingShape shape)
      : tool_(tool),
        ends_(shape.ends),
        neck_(shape.neck_mm),
        stickout_(tool.said(M::stickout)),
        flutes_(tool.said(M::flute_length)),
        outline_(std::move(shape.edges)) {
    for (const ProfileEdge& each : outline_.edges())
      if (each.part == ToolPart::edge) widest_ = std::max({widest_, each.from.r, each.to.r});
  }

  Profile build() {
    if (!ends_) add_flutes();
    if (ends_ || flutes_) add_shank();
    if (!tool_.holder.empty()) add_stack(tool_.holder, ToolPart::holder, Profile::kEndless_mm);
    return Profile(outline_.take());
  }

 private:
  void add_flutes() {
    const double top = flutes_ ? *flutes_ : stickout_.value_or(Profile::kEndless_mm);
    outline_.up_to(std::max(top, outline_.at().z), ToolPart::edge);
  }

  void add_shank() {
    if (neck_) out_to(*neck_, body(*neck_));
    if (tool_.shank.empty()) return add_rest(Profile::kEndless_mm);
    outline_.up_to(std::max(outline_.at().z, flutes_.value_or(0)), body(outline_.at().r));
    add_stack(tool_.shank, ToolPart::shank, stickout_.value_or(Profile::kEndless_mm));
    add_rest(outline_.at().z);
  }

  // As wide as it is, up to the holder; without one as far as is known.
  void add_rest(double otherwise) {
    const bool is_known = ends_ ? neck_.has_value() : true;
    if (!stickout_ && !is_known) return;
    const double top = std::max(stickout_.value_or(otherwise), outline_.at().z);
    outline_.up_to(top, body(outline_.at().r));
  }

  void add_stack(const std::vector<Segment>& segments, ToolPart part, double most) {
    for (const Segment& each : segments) {
      const double z = outline_.at().z;
      if (z >= most) return;
      const double top = std::min(z + each.height, most);
      const double share = (top - z) / each.height;
      const double upper = (each.lower + share * (each.upper - each.lower)) / 2;
      out_to(each.lower / 2, part == ToolPart::holder ? part : body(each.lower / 2));
      part == ToolPart::holder ? outline_.to({upper, top}, part) : cone_to({upper, top});
    }
  }

  // What is wider than the edges is told apart from what is not.
  void cone_to(ProfilePoint point) {
    const ProfilePoint from = outline_.at();
    const bool crosses = (from.r - widest_) * (point.r - widest_) < 0;
    if (crosses) {
      const double share = (widest_ - from.r) / (point.r - from.r);
      outline_.to({widest_, from.z + share * (point.z - from.z)}, body(from.r));
    }
    outline_.to(point, body(std::max(outline_.at().r, point.r)));
  }

  // A shoulder outwards is the body's above it, one inwards that of what is below.
  void out_to(double r, ToolPart above) {
    const bool inwards = r < outline_.at().r && !outline_.edges().empty();
    outline_.out_to(r, inwards ? outline_.edges().back().part : above);
  }

  [[nodiscard]] ToolPart body(double r) const {
    return r <= widest_ + kAlmost_mm ? ToolPart::flank : ToolPart::shank;
  }

  const Tool& tool_;
  bool ends_;
  std::optional<double> neck_;
  std::optional<double> stickout_;
  std::optional<double> flutes_;
  Outline outline_;
  double widest_ = 0;
};

std::string objection_to_heights(const Tool& tool, const CuttingShape& shape) {
  const double top = shape.edges.empty() ? 0 : shape.edges.back().to.z;
  const auto flutes = tool.said(M::flute_length);
  const auto stickout = tool.said(M::stickout);
  if (flutes && !shape.ends && *flutes < top - kRounded_mm)
    return "flute_length, " + base::number_text(*flutes) +
           ", ends where the tool has not its diameter yet: that begins at " +
           base::rounded_text(top, 4);
  const double cutting = std::max(top, flutes.value_or(0));
  if (stickout && *stickout < cutting - kRounded_mm)
    return "stickout, " + base::number_text(*stickout) + ", is less than " +
           (flutes && *flutes >= top ? "flute_length, " : "the cutting part, ") +
           base::rounded_text(cutting, 4);
  return {};
}

std::string objection_to_stacks(const Tool& tool, const CuttingShape& shape) {
  if (!tool.holder.empty() && !tool.said(M::stickout))
    return "a holder needs stickout: where it begins";
  if (!tool.shank.empty() && !shape.ends && !tool.said(M::flute_length))
    return "a shank needs flute_length: where it begins";
  return {};
}

}  // namespace

std::string objection_to_body(const Tool& tool) {
  const ShapeOutcome shape = row_of(tool.kind).shape(tool);
  if (!shape) return shape.error();
  if (std::string wrong = objection_to_heights(tool, *shape); !wrong.empty()) return wrong;
  return objection_to_stacks(tool, *shape);
}

Profile profile_of(const Tool& tool) {
  ShapeOutcome shape = row_of(tool.kind).shape(tool);
  return shape ? BodyBuilder(tool, std::move(*shape)).build() : Profile();
}

}  // namespace kerf::stock
