#include "job/internal/cut_end.hpp"

#include <fmt/format.h>

#include "job/run.hpp"
#include "motion/motion_end_sink.hpp"

namespace kerf::job {
namespace {

/// Waits for the motion that is under way at a time.
class TimeSearch final : public motion::MotionEndSink {
 public:
  explicit TimeSearch(double time_s) : time_s_(time_s) {}

  void motion_ends(std::uint64_t motion, double time_s) override {
    if (!end_ && time_s > time_s_)
      end_ = stock::CutEnd{motion, (time_s_ - last_s_) / (time_s - last_s_)};
    last_s_ = time_s;
  }
  [[nodiscard]] const std::optional<stock::CutEnd>& end() const { return end_; }

 private:
  double time_s_;
  double last_s_ = 0;
  std::optional<stock::CutEnd> end_;
};

/// Waits for a line to begin.
class LineSearch final : public motion::MotionSink {
 public:
  LineSearch(machine::BatchRun& run, std::uint32_t line) : run_(run), line_(line) {
    run.add_sink(*this);
    run.observe_blocks([this](base::FileId file, std::uint32_t begun) {
      if (!begun_ && is_line(file, begun)) begun_ = motions_;
    });
  }

  void take(const motion::Motion& motion) override {
    if (!made_ && is_line(motion.block.file, motion.block.line)) made_ = motions_;
    ++motions_;
  }
  [[nodiscard]] std::optional<stock::CutEnd> end() const {
    if (made_) return stock::CutEnd{*made_};
    return begun_ ? std::optional(stock::CutEnd{*begun_}) : std::nullopt;
  }

 private:
  [[nodiscard]] bool is_line(base::FileId file, std::uint32_t line) const {
    return line == line_ && file == run_.language().main_file();
  }

  machine::BatchRun& run_;
  std::uint32_t line_;
  std::uint64_t motions_ = 0;
  std::optional<std::uint64_t> begun_;  // motions before
  std::optional<std::uint64_t> made_;
};

}  // namespace

base::Outcome<FoundEnd> find_end(const StockJob& job) {
  auto run = Run::of(job.job);
  if (!run) return tl::unexpected(run.error());
  if (job.until->time_s) {
    TimeSearch search(*job.until->time_s);
    (*run)->machine().tell_ends(search);
    (*run)->go();
    if (search.end()) return FoundEnd{search.end()};
    return FoundEnd{
        .remark = fmt::format("the run ends before {} s: all of it is cut", *job.until->time_s)};
  }
  LineSearch search((*run)->machine(), job.until->line);
  (*run)->go();
  if (search.end()) return FoundEnd{search.end()};
  return FoundEnd{.remark =
                      fmt::format("line {} never begins: the whole run is cut", job.until->line)};
}

}  // namespace kerf::job
