#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace kerf::server {

/// The chunks of one run in the order in which they were made: on disk, in a file without a name
/// that goes with the last one who knows it. In memory there are 16 bytes a chunk. From any thread.
class ChunkStore {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

  /// Failure (output).
  [[nodiscard]] static base::Outcome<std::shared_ptr<ChunkStore>> create(const std::string& folder);
  ~ChunkStore();
  ChunkStore(const ChunkStore&) = delete;
  ChunkStore& operator=(const ChunkStore&) = delete;

  /// Failure (output): the disk is full, or the store holds kMostBytes; the chunk is not kept then.
  [[nodiscard]] base::Outcome<void> add(const std::string& chunk);
  [[nodiscard]] std::size_t count() const;
  /// Nothing: there is no such chunk, or the disk does not give it back.
  [[nodiscard]] std::optional<std::string> read(std::size_t number) const;

 private:
  struct Extent {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
  };

  explicit ChunkStore(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
  mutable std::mutex guard_;
  std::vector<Extent> extents_;
  std::uint64_t end_ = 0;
};

}  // namespace kerf::server
