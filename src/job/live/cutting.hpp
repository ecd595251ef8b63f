#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "job/live/owner_table.hpp"
#include "job/live/picture.hpp"
#include "job/pass_watch.hpp"

namespace kerf::job {

/// How fine a part is seen: columns of a level, where it has any.
struct PartGrid {
  std::array<double, 2> first{};  ///< middle of the first column, frame of the stock
  std::array<double, 2> cell_mm{};
  std::array<int, 2> cells{};
};
struct PartLevel {
  double cell_mm = 0;  ///< the largest; 0: it is exact
  std::optional<PartGrid> grid{};
};

/// One pass over a program that is cut in the background: what it was given is recorded, so that
/// its part can be seen at any time up to where it has come. One thread cuts; one looks.
class Cutting : public base::Interface {
 public:
  // From any thread

  [[nodiscard]] std::uint32_t run() const { return run_; }
  /// As reports call it.
  [[nodiscard]] const std::string& model() const { return facts_.kind; }
  [[nodiscard]] const std::string& reason() const { return facts_.reason; }
  [[nodiscard]] stock::Vec3 origin() const { return origin_; }
  [[nodiscard]] const stock::Bounds& box() const { return box_; }
  /// The coarse one first.
  [[nodiscard]] const std::vector<PartLevel>& levels() const { return levels_; }
  [[nodiscard]] const OwnerTable& owners() const { return owners_; }
  /// Null: there is none.
  [[nodiscard]] const DesignInSight* design() const { return design_ ? &*design_ : nullptr; }
  /// Up to here it can be seen, s of the run.
  [[nodiscard]] virtual double reached_s() const = 0;
  /// What is behind needs more memory than it may have.
  [[nodiscard]] virtual bool is_full() const = 0;

  // On the thread that cuts

  /// A motion that has been cut, with its times.
  virtual void take(const stock::TimedCut& cut) = 0;
  virtual void finish(double time_s) = 0;

  // On the thread that looks

  /// The part at a time, or as late as it is known, seen at a level; made when it is asked for.
  /// Null: `unwanted` came first.
  [[nodiscard]] virtual const Picture* at(double time_s, std::uint32_t level,
                                          const std::stop_token& unwanted) = 0;

 protected:
  Cutting(const PassBegin& pass, std::uint32_t run)
      : run_(run), origin_(pass.origin), box_(stock::bounds(pass.shape)), facts_(pass.facts) {}

  void see_against(const std::optional<DesignInSight>& design) { design_ = design; }
  void add_level(const PartLevel& level) { levels_.push_back(level); }
  [[nodiscard]] OwnerTable& table() { return owners_; }

 private:
  std::uint32_t run_;
  stock::Vec3 origin_;
  stock::Bounds box_;
  output::StockFacts::Model facts_;
  std::vector<PartLevel> levels_;
  OwnerTable owners_;
  std::optional<DesignInSight> design_;
};

}  // namespace kerf::job
