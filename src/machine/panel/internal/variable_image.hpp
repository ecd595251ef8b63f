#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace kerf::machine {

/// The values of all variables of a dialect at one moment (Dialect::read_variables()). Images of
/// moments that follow each other share what did not change between them.
class VariableImage {
 public:
  /// `before` itself where nothing has changed. It may be null.
  [[nodiscard]] static std::shared_ptr<const VariableImage> of(
      std::span<const double> values, const std::shared_ptr<const VariableImage>& before);

  [[nodiscard]] std::vector<double> values() const;
  /// Bit by bit: a vacant variable is no number.
  [[nodiscard]] bool shows(std::span<const double> values) const;

 private:
  static constexpr std::size_t kChunk = 64;
  using Chunk = std::array<double, kChunk>;

  std::vector<std::shared_ptr<const Chunk>> chunks_;  // the last one filled up with zeros
  std::size_t size_ = 0;
};

}  // namespace kerf::machine
