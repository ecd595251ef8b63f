#pragma once

#include <array>
#include <map>
#include <optional>

#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/spindles.hpp"

namespace kerf::stock {

/// A tool of a lathe that turns itself.
struct DrivenTool {
  Vec3 axis{0, 0, 1};     ///< from its tip up, in the machine: ±Z in the face, ±X in the side
  bool is_axial = false;  ///< it is only ever fed along that
  /// Its moves may mean either direction: the first one that is straight along an axis has decided.
  bool is_guess = false;

  friend bool operator==(const DrivenTool&, const DrivenTool&) = default;
};

/// Which tools of a lathe turn themselves, and how they stand, by what a run does with them. A tool
/// is driven that is fed while its spindle turns, or while that of the work stands and C goes with
/// it; not one that is described as an insert.
///
/// Where it stands says the first of: its own `driven`; polar interpolation (the face) and
/// cylindrical interpolation (the side); the plane in force, G17 or G19; the axis along which alone
/// it is fed; the first straight feed along one of them.
class DrivenTools {
 public:
  /// Axes and rack must outlive this.
  /// `centre_mm`: X of the axis of the spindle in the machine.
  DrivenTools(const motion::AxisSetup& axes, ToolRack& rack, double centre_mm);

  /// `plane`: in force at this motion.
  void look(const motion::Motion& motion, std::optional<motion::Plane> plane);

  /// By number.
  [[nodiscard]] std::map<std::uint32_t, DrivenTool> tools() const;
  /// The first block in which one cuts.
  [[nodiscard]] const std::optional<base::BlockId>& first() const { return first_; }

 private:
  /// Where something has stood; one: always there.
  struct Seen {
    bool face = false;
    bool side = false;

    void add(Driven where) { (where == Driven::face ? face : side) = true; }
    [[nodiscard]] std::optional<Driven> one() const {
      if (face == side) return {};
      return face ? Driven::face : Driven::side;
    }
  };
  /// What moves at feed of one tool have shown.
  struct Signs {
    Seen surfaces;
    Seen planes;
    Seen ways;                      ///< straight ones, along Z or along X, with nothing else moved
    bool along_other = false;       ///< there were others
    std::optional<Driven> first{};  ///< of those straight ones
    double first_z = 0;             ///< way of the first along Z
    double x_sign = 0;              ///< on which side of the centre the first move began
    std::optional<Driven> said{};
  };

  [[nodiscard]] bool is_driven(const motion::Motion& motion, const base::TipPoint& to);
  void note(const motion::Motion& motion, const base::TipPoint& to,
            std::optional<motion::Plane> plane);
  void note_way(Signs& signs, const base::TipPoint& to) const;
  [[nodiscard]] bool turns_work(const base::TipPoint& to) const;
  [[nodiscard]] double way(const base::TipPoint& to, char letter) const;
  [[nodiscard]] static DrivenTool tool_of(const Signs& signs);

  const motion::AxisSetup& axes_;
  ToolRack& rack_;
  double centre_mm_;
  Spindles spindles_;
  base::TipPoint at_;
  std::uint32_t tool_ = 0;
  std::map<std::uint32_t, Signs> signs_;
  std::optional<base::BlockId> first_;
};

}  // namespace kerf::stock
