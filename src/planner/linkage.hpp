#pragma once

#include <optional>

#include "base/axes.hpp"
#include "base/interface.hpp"
#include "base/path_jet.hpp"

namespace kerf::planner {

/// How the driven axes follow the tip, for machines whose axes are not those of the program. Who
/// hands over motions has asked before whether they can be driven.
class Linkage : public base::Interface {
 public:
  /// Number of driven axes.
  [[nodiscard]] virtual std::size_t size() const = 0;

  /// Where the driven axes stand at power-on, when the tip is at the start of the program's axes.
  [[nodiscard]] virtual base::JointPoint start() const = 0;

  /// Where the driven axes stand for a tip, continuing from where they stood; `previous` again
  /// where nothing holds the tip.
  [[nodiscard]] virtual base::JointPoint joints(const base::TipPoint& tip,
                                                const base::JointPoint& previous) const = 0;

  /// Their derivatives by the path parameter, from those of the tip, where they stand at `joints`.
  /// Nothing where they are not determined.
  [[nodiscard]] virtual std::optional<base::JointJet> along(
      const base::TipJet& tip, const base::JointPoint& joints) const = 0;

  /// How far the tip goes, mm in X Y Z, when the driven axes go by a little `way` from `joints`;
  /// the same of their derivatives. A norm of `way` where the linkage is not singular.
  [[nodiscard]] virtual double tip_way_mm(const base::JointPoint& joints,
                                          const base::AxisVector& way) const = 0;

  /// Upper bound of the second derivative of the tip, mm, while the driven axes go on at constant
  /// `rates`; its root is a norm of them.
  [[nodiscard]] virtual double swing_mm(const base::JointPoint& joints,
                                        const base::AxisVector& rates) const = 0;
};

}  // namespace kerf::planner
