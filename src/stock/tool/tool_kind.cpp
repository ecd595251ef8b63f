#include "stock/tool/tool_kind.hpp"

#include <algorithm>
#include <array>

#include "stock/tool/internal/cutting_shape.hpp"

namespace kerf::stock {
namespace {

using M = Measure;
using Names = std::span<const std::string_view>;
using Keys = std::vector<KindKey>;
using Centre = CentreCutting;

constexpr KindKey needs(M measure) { return {measure, true}; }
constexpr KindKey may_have(M measure) { return {measure}; }
constexpr KindKey has(M measure, double otherwise) { return {measure, false, otherwise}; }

template <std::size_t N>
using Words = std::array<std::string_view, N>;

constexpr Words<2> kFlat = {"flat", "slot"};
constexpr Words<1> kBall = {"ball"};
constexpr Words<1> kBull = {"bull"};
constexpr Words<4> kChamfer = {"chamfer", "v", "countersink", "spot"};
constexpr Words<2> kEngrave = {"engrave", "taper"};
constexpr Words<1> kDrill = {"drill"};
constexpr Words<1> kCentreDrill = {"centre-drill"};
constexpr Words<1> kReamer = {"reamer"};
constexpr Words<1> kTap = {"tap"};
constexpr Words<1> kFace = {"face"};
constexpr Words<2> kTSlot = {"t-slot", "saw"};
constexpr Words<1> kDovetail = {"dovetail"};
constexpr Words<1> kLollipop = {"lollipop"};
constexpr Words<1> kThreadMill = {"thread-mill"};
constexpr Words<1> kBoring = {"boring"};
constexpr Words<1> kForm = {"form"};
constexpr Words<1> kProbe = {"probe"};
constexpr Words<1> kTurning = {"turning"};
constexpr Words<1> kBoringBar = {"boring-bar"};
constexpr Words<1> kGrooving = {"grooving"};
constexpr Words<1> kParting = {"parting"};
constexpr Words<1> kFaceGrooving = {"face-grooving"};
constexpr Words<1> kThreading = {"threading"};

const KindKey kDiameter = needs(M::diameter);

KindRow mill(ToolKind kind, Names names, CentreCutting centre, decltype(KindRow::shape) shape,
             Keys keys) {
  keys.insert(keys.begin(), {kDiameter, may_have(M::core_diameter)});
  return {kind, names, centre, false, shape, std::move(keys)};
}

KindRow drilling(ToolKind kind, Names names, decltype(KindRow::shape) shape, Keys keys) {
  keys.insert(keys.begin(), kDiameter);
  return {kind, names, Centre::yes, true, shape, std::move(keys)};
}

// Nose, shape and place of an insert; what is not said is the commonest one.
KindRow insert(ToolKind kind, Names names, int tip, Keys keys) {
  keys.push_back(has(M::tip, tip));
  return {kind, names, Centre::never, false, nullptr, std::move(keys)};
}

std::vector<KindRow> rotating_kinds() {
  using Kind = ToolKind;
  const Keys cone = {has(M::angle, 90), has(M::tip_diameter, 0)};
  return {
      mill(Kind::flat, kFlat, Centre::yes, flat_shape, {has(M::corner_radius, 0)}),
      mill(Kind::ball, kBall, Centre::yes, ball_shape, {}),
      mill(Kind::bull, kBull, Centre::yes, flat_shape, {needs(M::corner_radius)}),
      mill(Kind::chamfer, kChamfer, Centre::yes, cone_shape, cone),
      mill(Kind::engrave, kEngrave, Centre::yes, cone_shape,
           {cone[0], cone[1], has(M::tip_radius, 0)}),
      drilling(Kind::drill, kDrill, drill_shape, {has(M::angle, 118)}),
      drilling(Kind::centre_drill, kCentreDrill, centre_drill_shape,
               {needs(M::pilot_diameter), needs(M::pilot_length), has(M::angle, 60)}),
      drilling(Kind::reamer, kReamer, reamer_shape, {has(M::lead, 0.5)}),
      drilling(Kind::tap, kTap, tap_shape, {may_have(M::pitch)}),
      mill(Kind::face, kFace, Centre::no, face_shape,
           {has(M::entering_angle, 90), has(M::ap_max, 5), may_have(M::body_diameter)}),
      mill(Kind::t_slot, kTSlot, Centre::no, disc_shape,
           {needs(M::width), needs(M::neck_diameter)}),
      mill(Kind::dovetail, kDovetail, Centre::no, dovetail_shape,
           {needs(M::angle), needs(M::height), needs(M::neck_diameter)}),
      mill(Kind::lollipop, kLollipop, Centre::yes, lollipop_shape, {needs(M::neck_diameter)}),
      mill(Kind::thread_mill, kThreadMill, Centre::no, thread_mill_shape,
           {needs(M::pitch), has(M::profile_angle, 60), has(M::teeth, 1),
            may_have(M::neck_diameter)}),
      mill(Kind::boring, kBoring, Centre::no, flat_shape, {has(M::width, 1)}),
      {Kind::form,
       kForm,
       Centre::said,
       false,
       form_shape,
       {may_have(M::diameter), may_have(M::core_diameter)}},
      {Kind::probe,
       kProbe,
       Centre::never,
       false,
       probe_shape,
       {kDiameter, may_have(M::neck_diameter)}},
  };
}

std::vector<KindRow> turning_kinds() {
  using Kind = ToolKind;
  const Keys nosed = {has(M::nose_radius, 0.4), has(M::tip_angle, 80), has(M::ic, 12.7),
                      has(M::kapr, 95)};
  Keys barred = nosed;
  for (const M measure : {M::minimum_bore, M::overhang, M::holder_width})
    barred.push_back(may_have(measure));
  const Keys straight = {needs(M::width), has(M::corner_radius, 0)};
  return {
      insert(Kind::turning, kTurning, 3, nosed),
      insert(Kind::boring_bar, kBoringBar, 2, barred),
      insert(Kind::grooving, kGrooving, 3, straight),
      insert(Kind::parting, kParting, 3, straight),
      insert(Kind::face_grooving, kFaceGrooving, 3, straight),
      insert(Kind::threading, kThreading, 8,
             {has(M::profile_angle, 60), may_have(M::pitch), has(M::nose_radius, 0),
              has(M::ic, 9.525)}),
  };
}

std::vector<KindRow> all_kinds() {
  std::vector<KindRow> rows = rotating_kinds();
  for (KindRow& row : turning_kinds()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace

const KindKey* KindRow::key(Measure measure) const {
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [&](const KindKey& key) { return key.measure == measure; });
  return found == keys.end() ? nullptr : &*found;
}

bool is_common(Measure measure) {
  // Nose and tip are those of its offset, too, whatever it is.
  constexpr std::array<M, 6> kCommon = {M::length, M::flute_length, M::stickout,
                                        M::flutes, M::nose_radius,  M::tip};
  return std::find(kCommon.begin(), kCommon.end(), measure) != kCommon.end();
}

std::span<const KindRow> kind_rows() {
  static const std::vector<KindRow> kRows = all_kinds();
  return kRows;
}

const KindRow& row_of(ToolKind kind) { return kind_rows()[static_cast<std::size_t>(kind)]; }

NamedKind kind_named(std::string_view name) {
  for (const KindRow& row : kind_rows()) {
    for (const std::string_view each : row.names) {
      if (each == name) return {&row, each};
    }
  }
  return {};
}

}  // namespace kerf::stock
