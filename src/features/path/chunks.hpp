#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace kerf::features {

/// A list that only grows, and never moves what it has: a million rows cost their bytes once.
template <typename T>
class Chunks {
 public:
  void push_back(const T& item) {
    if (size_ % kChunk == 0) chunks_.push_back(std::make_unique<Chunk>());
    ++size_;
    back() = item;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T& operator[](std::size_t i) const {
    return (*chunks_[i / kChunk])[i % kChunk];
  }
  [[nodiscard]] T& operator[](std::size_t i) { return (*chunks_[i / kChunk])[i % kChunk]; }
  [[nodiscard]] Chunks copy() const {
    Chunks made;
    for (const auto& chunk : chunks_) made.chunks_.push_back(std::make_unique<Chunk>(*chunk));
    made.size_ = size_;
    return made;
  }
  [[nodiscard]] T& back() { return (*chunks_[(size_ - 1) / kChunk])[(size_ - 1) % kChunk]; }

 private:
  static constexpr std::size_t kChunk = 2048;
  using Chunk = std::array<T, kChunk>;

  std::vector<std::unique_ptr<Chunk>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace kerf::features
