#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/machine_store.hpp"
#include "server/worker.hpp"

namespace kerf::server {

/// Writes the memory of machines while they run, one write after the other. A disk that is behind
/// writes the newest memory of a machine once.
class MemorySaver {
 public:
  using Tell = std::function<void(const std::string&)>;

  /// What is told is why a memory could not be written; on the thread of `disk`.
  MemorySaver(const MachineStore& store, Worker& disk, Tell tell)
      : store_(store), disk_(disk), tell_(std::move(tell)) {}

  /// From any thread.
  void save(const std::string& machine, std::shared_ptr<const control::Memory> memory);

 private:
  const MachineStore& store_;
  Worker& disk_;
  Tell tell_;
  std::mutex guard_;
  std::map<std::string, std::shared_ptr<const control::Memory>> waiting_;  ///< for the disk
};

}  // namespace kerf::server
