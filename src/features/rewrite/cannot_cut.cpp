#include "features/rewrite/cannot_cut.hpp"

#include "base/decimal.hpp"

namespace kerf::features {

using base::Code;

tl::unexpected<CannotCut> cannot_edit(std::string why) {
  return tl::unexpected(CannotCut{Code::edit_not_editable, std::move(why)});
}

tl::unexpected<CannotCut> does_not_fit(std::uint32_t tool) {
  return tl::unexpected(
      CannotCut{Code::edit_tool_too_big, "T" + std::to_string(tool) + " DOES NOT FIT"});
}

CannotCut left_uncut(double area_mm2, geometry::Vec2 at) {
  return {Code::edit_leaves_rest, base::rounded_text(area_mm2, 3) + " mm² STAY UNCUT AT X" +
                                      base::rounded_text(at.u, 3) + " Y" +
                                      base::rounded_text(at.v, 3)};
}

}  // namespace kerf::features
