#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/program_text.hpp"
#include "face/server/protocol/json.hpp"
#include "face/server/store/chunk_store.hpp"
#include "job/job.hpp"
#include "job/run.hpp"
#include "output/records/path_chunks.hpp"

namespace kerf::server {

/// What a preview runs: a program as the machine would run it that was asked, with its memory.
struct PreviewOrder {
  job::Job job;  ///< but for its program, which may have to wait for the disk:
  std::function<base::Outcome<base::ProgramText>()> program;
  std::uint32_t run = 0;
};

/// How far a preview is.
struct PreviewState {
  std::uint32_t run = 0;
  bool done = false;
  output::PathTotals totals;
  std::vector<std::string> files;  ///< by the file numbers of the chunks
  Json error;                      ///< a diagnostic, or null
  Json findings = Json::array();   ///< diagnostics: `error`, if it is an alarm, and those behind it
  Json stop = nullptr;             ///< `{motion, time_s}` where the control stops, or null
  bool has_read_inputs = false;    ///< other input signals may make another path of it
  bool is_cut_short = false;       ///< behind the stop not everything was looked at
};

/// A run of a program in the background, as fast as it goes, whose path becomes chunks. It goes on
/// behind alarms (machine::AlarmSearch): what comes behind the first one no machine would make.
///
/// run() belongs to a thread of its own and may take long. The first chunk comes after at most
/// kFirst_s of computing, the others every kNext_s. Whoever wants no more of it calls cancel().
class Preview {
 public:
  static constexpr double kFirst_s = 0.05;
  static constexpr double kNext_s = 0.25;
  static constexpr double kMostSeconds = 600;  ///< of computing

  /// Called on the thread of run() when there are new chunks, about each second, and at the end.
  using Observer = std::function<void(const PreviewState& state)>;

  Preview(PreviewOrder order, std::shared_ptr<ChunkStore> chunks)
      : order_(std::move(order)), chunks_(std::move(chunks)) {}

  void run(const Observer& observer);
  void cancel() { unwanted_.request_stop(); }
  [[nodiscard]] bool cancelled() const { return unwanted_.stop_requested(); }
  [[nodiscard]] const std::shared_ptr<ChunkStore>& chunks() const { return chunks_; }

 private:
  class Run;

  [[nodiscard]] base::Outcome<std::unique_ptr<job::Run>> make_run();

  PreviewOrder order_;
  std::shared_ptr<ChunkStore> chunks_;
  std::stop_source unwanted_;
};

}  // namespace kerf::server
