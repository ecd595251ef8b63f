#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "drawing/drawing.hpp"
#include "geometry/contour/contour.hpp"
#include "process/grey_image.hpp"
#include "process/order.hpp"
#include "process/recipe.hpp"
#include "process/scan.hpp"
#include "process/settled.hpp"

namespace kerf::process {

inline constexpr std::uint32_t kNoContour = std::numeric_limits<std::uint32_t>::max();

/// A line or an arc of the tool at feed; `power` is the share of the operation's power, 0: no beam.
struct Leg {
  Vec2 to;
  double bulge = 0;
  double power = 1;
};

/// A way that is made without letting off.
struct Way {
  Vec2 begin;
  std::vector<Leg> legs;
  double pierce_s = 0;  ///< burns on the spot before it goes

  [[nodiscard]] Vec2 end() const { return legs.empty() ? begin : legs.back().to; }
};

/// What is done along contours of an operation besides going along them.
struct AlongRules {
  Lead lead_in;
  Lead lead_out;
  bool leads_open = false;  ///< open contours have leads, too
  double overcut = 0;
  double pierce_s = 0;
  Tabs tabs;
  double kerf = 0;
  double ramp_in = 0;  ///< mm from no power to all of it
  double ramp_out = 0;
  Weave weave;
};

/// A way into a contour or out of it, as shortened where it would have touched another one.
struct LeadShare {
  double in = 1;
  double out = 1;
};

/// Along a contour: a closed one in its direction from any of `starts` (mm along it), an open one
/// from either end.
struct Along {
  contour::Contour path;
  std::vector<double> starts;
  std::vector<LeadShare> leads;  ///< of each start; empty: whole
  bool scrap_is_left = false;    ///< leads are on that side
};

/// Scan lines one after the other, each with run-up and run-out at feed and without beam.
struct Scan {
  std::vector<ScanLine> lines;
  double run_up = 0;  ///< mm
};

/// A picture, whose scan lines are made while they are burnt.
struct Picture {
  std::shared_ptr<const GreyImage> image;
  Operation operation;
  Settled settled;
  Vec2 size_mm;
  drawing::Affine placed;  ///< from the picture's own plane to the machine; lengths stay
  double run_up = 0;
  Entry entry;  ///< where the first scan begins and the last one ends
};

/// A hole that is burnt where the tool stands.
struct Spot {
  Vec2 at;
};

/// One thing that an operation makes at once.
struct Pass {
  std::uint32_t contour = kNoContour;
  drawing::EntityId entity = 0;
  std::vector<std::uint32_t> before;  ///< passes of the operation that must be made earlier
  std::variant<Along, Scan, Picture, Spot> what;
};

}  // namespace kerf::process
