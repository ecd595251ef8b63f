#pragma once

#include <deque>
#include <memory>
#include <shared_mutex>
#include <span>
#include <vector>

#include "stock/replay/record.hpp"
#include "stock/sheet/sheet.hpp"

namespace kerf::stock::replay {

/// What a sheet is given while one thread cuts and burns it. That thread tells it; questions come
/// from any.
class SheetRecording {
 public:
  /// The sheet is untouched, and there until the recording is over.
  SheetRecording(sheet::Sheet& sheet, const Record::Settings& settings);

  /// These have been cut, each by the motion of its number, rising.
  void cut(std::span<const sheet::Trace> traces, std::span<const std::uint32_t> motions);
  /// A motion whose traces have been cut, with its time, s of the run; they come in their order.
  void tell(std::uint32_t motion, double start_s, double end_s);
  /// These have been burnt, each up to its time, s of the run, rising.
  void burn(std::span<const sheet::Burn> burns, std::span<const double> until_s);
  void finish(double time_s);

  [[nodiscard]] bool is_full() const { return cuts_.is_full() || burns_.is_full(); }
  [[nodiscard]] double reached_s() const;
  [[nodiscard]] const Record& cuts() const { return cuts_; }
  [[nodiscard]] const Record& burns() const { return burns_; }
  [[nodiscard]] std::vector<sheet::Trace> traces(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::vector<sheet::Burn> burnt(std::size_t from, std::size_t to) const;

 private:
  struct Cut {
    sheet::Trace trace;
    std::uint32_t motion;
  };

  std::unique_ptr<Tiles> coverage_;
  std::unique_ptr<Tiles> energy_;
  Record cuts_;
  Record burns_;
  mutable std::shared_mutex mutex_;  // of what follows
  std::deque<Cut> traces_;
  std::deque<sheet::Burn> burnt_;
  std::size_t told_ = 0;  // traces whose times are known
  double burnt_until_s_ = 0;
};

}  // namespace kerf::stock::replay
