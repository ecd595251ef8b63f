#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace kerf::server {

/// What all stores of a server hold together. It outlives them.
struct ChunkBudget {
  static constexpr std::uint64_t kMostBytes = std::uint64_t{8} << 30U;
  std::atomic<std::uint64_t> bytes{0};
};

/// The chunks of one run in the order in which they were made: on disk, in a file without a name
/// that goes with the last one who knows it. In memory there are 16 bytes a chunk. From any thread.
class ChunkStore {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

  /// The file is made in `folder` by whoever adds the first chunk.
  ChunkStore(std::string folder, std::shared_ptr<ChunkBudget> budget)
      : folder_(std::move(folder)), budget_(std::move(budget)) {}
  ~ChunkStore();
  ChunkStore(const ChunkStore&) = delete;
  ChunkStore& operator=(const ChunkStore&) = delete;

  /// Failure (output): there is no file to be had, the disk is full, or the store or all of them
  /// hold what they may; the chunk is not kept then.
  [[nodiscard]] base::Outcome<void> add(const std::string& chunk);
  [[nodiscard]] std::size_t count() const;
  /// Nothing: there is no such chunk, or the disk does not give it back.
  [[nodiscard]] std::optional<std::string> read(std::size_t number) const;

 private:
  struct Extent {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
  };

  [[nodiscard]] base::Outcome<void> open();

  std::string folder_;
  std::shared_ptr<ChunkBudget> budget_;
  int descriptor_ = -1;
  mutable std::mutex guard_;
  std::vector<Extent> extents_;
  std::uint64_t end_ = 0;
};

}  // namespace kerf::server
