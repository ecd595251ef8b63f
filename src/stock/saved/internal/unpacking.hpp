#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "stock/saved/part_file.hpp"

namespace kerf::stock::saved {

/// What keeps a file from being read: the end of a sentence that begins with its name. Thrown
/// inside this room only.
struct WrongPart {
  std::string what;
};
[[nodiscard]] WrongPart damaged(const std::string& how);

/// Unpacks one record, as much at a time as its reader asks for.
class Record {
 public:
  explicit Record(std::string packed);
  ~Record() { inflateEnd(&stream_); }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// The next `size` bytes; good until the next call.
  [[nodiscard]] std::string_view take(std::size_t size);
  /// Nothing is left.
  void finish();

 private:
  std::string packed_;
  std::string unpacked_;
  z_stream stream_{};
  bool has_ended_ = false;
};

/// Reads the frame of a file: its head, records, the sum at its end.
class PartUnpacker {
 public:
  PartUnpacker(const GiveBytes& give, std::size_t most_bytes)
      : give_(give), most_bytes_(most_bytes) {}

  /// The JSON.
  [[nodiscard]] std::string head();
  [[nodiscard]] std::uint32_t number();
  [[nodiscard]] Record record() { return Record(text(number())); }
  /// The sum fits, and nothing follows.
  void finish();

  /// What is read is going to hold so many bytes more.
  void hold(double bytes);

 private:
  void check_magic();
  void fill(std::span<char> bytes);
  [[nodiscard]] std::string text(std::size_t size);

  const GiveBytes& give_;
  std::size_t most_bytes_;
  double held_ = 0;
  std::uint32_t sum_ = 0;
};

}  // namespace kerf::stock::saved
