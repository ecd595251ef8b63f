#include "machine/panel/internal/variable_image.hpp"

#include <algorithm>
#include <cstring>

namespace kerf::machine {

std::shared_ptr<const VariableImage> VariableImage::of(
    std::span<const double> values, const std::shared_ptr<const VariableImage>& before) {
  if (before && before->shows(values)) return before;
  auto image = std::make_shared<VariableImage>();
  image->size_ = values.size();
  for (std::size_t at = 0; at < values.size(); at += kChunk) {
    const auto part = values.subspan(at, std::min(kChunk, values.size() - at));
    const std::size_t index = at / kChunk;
    // Bit by bit: a vacant variable is no number, and not equal to itself.
    if (before && index < before->chunks_.size() &&
        std::memcmp(before->chunks_[index]->data(), part.data(), part.size_bytes()) == 0) {
      image->chunks_.push_back(before->chunks_[index]);
      continue;
    }
    auto chunk = std::make_shared<Chunk>();
    std::copy(part.begin(), part.end(), chunk->begin());
    image->chunks_.push_back(std::move(chunk));
  }
  return image;
}

bool VariableImage::shows(std::span<const double> values) const {
  if (size_ != values.size()) return false;
  for (std::size_t at = 0; at < size_; at += kChunk) {
    const auto part = values.subspan(at, std::min(kChunk, size_ - at));
    if (std::memcmp(chunks_[at / kChunk]->data(), part.data(), part.size_bytes()) != 0)
      return false;
  }
  return true;
}

std::vector<double> VariableImage::values() const {
  std::vector<double> values;
  values.reserve(chunks_.size() * kChunk);
  for (const auto& chunk : chunks_) values.insert(values.end(), chunk->begin(), chunk->end());
  values.resize(size_);
  return values;
}

}  // namespace kerf::machine
