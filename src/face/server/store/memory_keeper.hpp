#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "base/result.hpp"
#include "control/core/memory.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// Whether both keep the same: all but #100 to #199, which end with the power, and of the hours
/// that a machine runs each minute.
[[nodiscard]] bool keeps_the_same(const control::Memory& a, const control::Memory& b);

/// Writes the memory of machines, and is the only one who knows what of it is on the disk: what is
/// to be kept is compared with what was written last, whoever had it written.
///
/// A write that fails is tried again whenever the memory is offered again, first after kFirstPause,
/// later each kLongestPause; the trouble is told once, and once that it is over.
class MemoryKeeper {
 public:
  using Clock = std::chrono::steady_clock;
  using Memory = std::shared_ptr<const control::Memory>;
  using Write =
      std::function<base::Outcome<void>(const std::string& machine, const control::Memory&)>;
  /// Why the memory of a machine cannot be written; empty: it is written again.
  using Tell = std::function<void(const std::string& machine, const std::string& trouble)>;

  static constexpr std::chrono::seconds kFirstPause{1};
  static constexpr std::chrono::seconds kLongestPause{30};

  /// `write` and `tell` are called on the thread of `disk`.
  MemoryKeeper(Worker& disk, Write write, Tell tell)
      : disk_(disk), write_(std::move(write)), tell_(std::move(tell)) {}

  // From any thread:

  /// The machine is on the disk with this memory.
  void know(const std::string& machine, const control::Memory& on_disk);
  /// Its memory is not written any more.
  void forget(const std::string& machine);
  [[nodiscard]] bool is_on_disk(const std::string& machine, const control::Memory& memory) const;
  /// What is to be on the disk. Returns at once; a disk that is behind writes the newest one.
  void offer(const std::string& machine, Memory memory);

  // On the thread of the disk, or when nobody else is left:

  /// Is on the disk when this returns. Failure (output): it may or may not be; what was offered
  /// counts.
  [[nodiscard]] base::Outcome<void> write(const std::string& machine,
                                          const control::Memory& memory);

 private:
  struct Entry {
    Memory on_disk;  ///< null: not known
    Memory offered;
    bool posted = false;
    Clock::time_point not_before{};
    std::chrono::seconds pause{0};
    std::string trouble;
  };

  void write_offered(const std::string& machine);
  void note(const std::string& machine, const Memory& memory, const std::string& trouble);

  Worker& disk_;
  Write write_;
  Tell tell_;
  mutable std::mutex guard_;
  std::map<std::string, Entry> entries_;
};

}  // namespace kerf::server
