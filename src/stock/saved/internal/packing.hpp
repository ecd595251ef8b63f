#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "stock/saved/part_file.hpp"

namespace kerf::stock::saved {

// Little-endian numbers, whatever the computer is.

template <typename Word>
void put_word(std::string& out, Word word) {
  for (std::size_t i = 0; i < sizeof word; ++i)
    out += static_cast<char>(static_cast<std::uint64_t>(word) >> (8 * i) & 0xFFU);
}
inline void put(std::string& out, float value) {
  put_word(out, std::bit_cast<std::uint32_t>(value));
}
inline void put(std::string& out, double value) {
  put_word(out, std::bit_cast<std::uint64_t>(value));
}

/// Numbers one after the other; whoever reads knows how many there are.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <typename Word>
  [[nodiscard]] Word word() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      value |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * i);
    at_ += sizeof(Word);
    return static_cast<Word>(value);
  }
  [[nodiscard]] float single() { return std::bit_cast<float>(word<std::uint32_t>()); }
  [[nodiscard]] double number() { return std::bit_cast<double>(word<std::uint64_t>()); }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// Writes the frame of a file: its head, records, the sum at its end.
class PartPacker {
 public:
  explicit PartPacker(const TakeBytes& take) : take_(take) {}

  void head(const std::string& json);
  void number(std::uint32_t value);
  /// Bytes as they are unpacked.
  void record(std::string_view bytes);
  void finish();

 private:
  void put_out(std::string_view bytes);

  const TakeBytes& take_;
  std::uint32_t sum_ = 0;
  std::string packed_;
};

}  // namespace kerf::stock::saved
