#pragma once

#include <optional>
#include <vector>

#include "stock/sweep/model.hpp"
#include "stock/turned/material.hpp"
#include "stock/turned/swept.hpp"
#include "stock/turned/thread_book.hpp"
#include "stock/turned/turned_tool.hpp"

namespace kerf::stock::turned {

/// Nearer to it than this, mm, a contour is on the axis: rounding leaves arcs so far below it.
inline constexpr double kOnAxis_mm = 1e-9;

/// What a sweep has met of a part, as a region: for whoever holds that part in another way, too.
struct TurnedCut {
  contour::Region region;
  std::optional<ToolPart> contact{};  ///< that should not have met it; none: edges cut it
  bool is_taken = true;               ///< else it is part of what edges cut
};

/// Stock of a lathe (stock.md §3, profile): all that turns about the axis of the spindle, Z, as a
/// region of lines and arcs in (u = Z, v = ρ >= 0). Tools move in the plane of Z and X, ways of
/// lines and arcs; what they cut is exact but for rounding, and each edge has the motion that cut
/// it for its owner, 0 where nothing has. Sweeps of threads leave the region as it is.
class TurnedPart final : public Model {
 public:
  /// What is at v < -kOnAxis_mm of the region is left out.
  explicit TurnedPart(const contour::Region& region);

  [[nodiscard]] BodyId add_body(const Body& body) override;
  /// The tip stays in the plane; a tool on the axis stands along +Z.
  [[nodiscard]] bool can_cut(const Sweep& sweep) const override;
  /// Contacts of an insert's back are ToolPart::flank, of its bar ToolPart::holder.
  void cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) override;
  /// One of them, and in `cuts` what it met, in the order in which that was taken; of a thread
  /// nothing is.
  void cut(const Sweep& sweep, Outcome& outcome, std::vector<TurnedCut>& cuts);
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const override;
  /// Of lines along Z.
  [[nodiscard]] Stretch material_on(const StraightWay& line) const override;

  [[nodiscard]] double left_mm3() const override;
  [[nodiscard]] double stock_mm3() const override { return stock_mm3_; }
  [[nodiscard]] double error_mm3() const override { return 0; }
  [[nodiscard]] Bounds extents() const override;
  [[nodiscard]] std::vector<Piece> pieces() const override;
  [[nodiscard]] std::size_t bytes() const override;

  [[nodiscard]] const contour::Region& region() const { return material_.region(); }
  [[nodiscard]] std::vector<TurnedThread> threads() const { return threads_.threads(); }

  /// What is left with its threads, to keep it and to bring it back.
  struct State {
    contour::Region region;
    ThreadBook threads;
  };
  [[nodiscard]] State state() const { return {region(), threads_}; }
  /// Precondition: state() of a part with the same tools.
  void restore(const State& state);
  /// How often it has changed; restoring counts as once.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

 private:
  struct Told {
    Outcome& outcome;
    std::vector<TurnedCut>& cuts;
  };

  void become(contour::Region region);
  void cut_with_edges(const TurnedTool& tool, const Pass& pass, BodyId body, const Told& told);
  void cut_thread(const TurnedTool& tool, const Pass& pass, const Sweep& sweep, const Told& told);
  void check_back(const TurnedTool& tool, const Pass& pass, const contour::Region& met,
                  const Told& told) const;
  void meet(const TurnedTool::Part& part, double touch_mm, const Pass& pass, BodyId body,
            const Told& told);
  [[nodiscard]] double groove_mm3(const TurnedTool& tool, const ThreadPass& pass) const;
  [[nodiscard]] contour::Region without_threads(contour::Region met, BodyId body) const;

  Material material_;
  double stock_mm3_;
  std::vector<TurnedTool> tools_;
  ThreadBook threads_;
  std::uint64_t changes_ = 0;
};

/// A bar or a tube about the axis: diameters, from < to. Precondition: diameter > inner >= 0.
[[nodiscard]] contour::Region bar(double diameter, double from, double to,
                                  double inner_diameter = 0);

}  // namespace kerf::stock::turned
