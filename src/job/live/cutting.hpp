#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "job/live/owner_table.hpp"
#include "job/live/picture.hpp"
#include "job/pass_watch.hpp"
#include "stock/replay/player.hpp"
#include "stock/replay/recording.hpp"

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
class Cutting final : public stock::CutWatch, public stock::TimedCutSink {
 public:
  Cutting(const PassBegin& pass, std::uint32_t run, std::size_t memory_bytes);

  // On the thread that cuts

  void added(const stock::Body& body) override { recording_.added(body); }
  void cut(std::span<const stock::Sweep> sweeps) override { recording_.cut(sweeps); }
  void take(const stock::TimedCut& cut) override;
  void finish(double time_s) { recording_.finish(time_s); }
  [[nodiscard]] bool is_full() const { return recording_.is_full(); }

  // From any thread

  [[nodiscard]] std::uint32_t run() const { return run_; }
  [[nodiscard]] const std::string& model() const { return facts_.kind; }
  [[nodiscard]] const std::string& reason() const { return facts_.reason; }
  [[nodiscard]] stock::Vec3 origin() const { return origin_; }
  [[nodiscard]] const stock::Bounds& box() const { return box_; }
  [[nodiscard]] const std::vector<PartLevel>& levels() const { return levels_; }
  [[nodiscard]] const OwnerTable& owners() const { return owners_; }
  [[nodiscard]] double reached_s() const { return recording_.reached_s(); }

  // On the thread that looks

  /// The part at a time, or as late as it is known, seen at a level; made when it is asked for.
  /// Null: `unwanted` came first.
  [[nodiscard]] const Picture* at(double time_s, std::uint32_t level,
                                  const std::stop_token& unwanted);

 private:
  /// A level that somebody has looked at.
  struct Seen {
    Seen(std::unique_ptr<stock::Model> model, const stock::replay::Player::Settings& settings,
         const OwnerTable& owners)
        : player(std::move(model), settings),
          picture(picture_of(player.model(), player.tiles(), owners)) {}

    stock::replay::Player player;
    std::unique_ptr<Picture> picture;
  };
  static constexpr std::size_t kFineMemory_bytes = std::size_t{64} << 20U;

  std::uint32_t run_;
  stock::Vec3 origin_;
  stock::Bounds box_;
  output::StockFacts::Model facts_;
  std::function<std::unique_ptr<stock::Model>(double)> like_;
  std::vector<PartLevel> levels_;
  OwnerTable owners_;
  stock::replay::Recording recording_;
  std::array<std::unique_ptr<Seen>, 2> seen_;  // of the levels
};

}  // namespace kerf::job
