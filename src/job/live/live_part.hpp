#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "job/live/cutting.hpp"
#include "job/stock_job.hpp"
#include "job/stock_run.hpp"

namespace kerf::job {

/// How far a part is, told on the thread that cuts it. What it refers to is there meanwhile.
struct PartProgress {
  std::shared_ptr<Cutting> cutting{};                 ///< null: no pass has begun
  const base::SourceSet* sources = nullptr;           ///< of the findings; null: there are none
  std::vector<output::StockFacts::Told> findings{};   ///< the first kMostFindings of them
  std::size_t more_findings = 0;                      ///< besides them
  std::vector<output::StockFacts::Thread> threads{};  ///< known at the end
  std::vector<control::Assumption> assumed{};         ///< likewise
  std::vector<std::string> not_checked{};             ///< likewise
  bool is_done = false;
  std::string error{};  ///< why there is no more; empty: nothing is wrong
};

/// The part of a program, cut in the background as fast as it goes, for those who look at it while
/// and after that. cut() belongs to a thread of its own and may take long.
class LivePart final : private JobWatch {
 public:
  struct Order {
    /// Made on the thread that cuts, for it may wait for the disk.
    std::function<base::Outcome<StockJob>()> job;
    std::uint32_t first_run = 0;  ///< of kMostRuns that it may count
    std::size_t memory_bytes = std::size_t{256} << 20U;
  };
  static constexpr std::uint32_t kMostRuns = 16;
  static constexpr double kSeconds = 600;             ///< of computing
  static constexpr double kTell_s = 0.2;              ///< so often progress is told
  static constexpr std::size_t kMostFindings = 1000;  ///< that are told
  static constexpr int kMostAlong = 500;  ///< cells of the first level along the longest side

  using Observer = std::function<void(const PartProgress&)>;

  explicit LivePart(Order order) : order_(std::move(order)) {}

  void cut(const Observer& observer);
  void cancel();
  [[nodiscard]] bool is_cancelled() const { return is_cancelled_; }

  /// The newest pass; null: none has begun. From any thread.
  [[nodiscard]] std::shared_ptr<Cutting> cutting() const;

 private:
  class Teller;
  class ModelLook;
  class SheetLook;

  [[nodiscard]] std::unique_ptr<ModelWatch> begins(const ModelBegin& pass) override;
  [[nodiscard]] std::unique_ptr<SheetWatch> begins(const SheetBegin& pass) override;
  [[nodiscard]] std::uint32_t next_run() { return order_.first_run + runs_++ % kMostRuns; }
  void show(std::shared_ptr<Cutting> cutting);
  void prepare(StockJob& job);
  [[nodiscard]] std::string why_over(const StockResult& result) const;
  void compare(const StockJob& job, StockResult& result) const;
  void tell_end(StockResult& result) const;

  Order order_;
  std::uint32_t runs_ = 0;
  std::atomic<bool> is_cancelled_ = false;
  std::stop_source over_;  // cancelled, or the memory is full
  const Observer* observer_ = nullptr;
  mutable std::mutex mutex_;  // of what follows
  std::shared_ptr<Cutting> cutting_;
};

}  // namespace kerf::job
