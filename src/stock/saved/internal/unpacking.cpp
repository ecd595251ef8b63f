#include "stock/saved/internal/unpacking.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stock/saved/internal/packing.hpp"
#include "stock/saved/internal/part_format.hpp"

namespace kerf::stock::saved {
namespace {

// A length that is a lie asks for no more memory than there are bytes.
constexpr std::size_t kAtOnce = 1 << 16;
constexpr double kMebibyte = 1 << 20;

}  // namespace

WrongPart damaged(const std::string& how) { return {"is damaged: " + how}; }

Record::Record(std::string packed) : packed_(std::move(packed)) {
  stream_.next_in = reinterpret_cast<Bytef*>(packed_.data());
  stream_.avail_in = static_cast<uInt>(packed_.size());
  if (inflateInit(&stream_) != Z_OK) throw WrongPart{"cannot be unpacked"};
}

std::string_view Record::take(std::size_t size) {
  unpacked_.resize(size);
  stream_.next_out = reinterpret_cast<Bytef*>(unpacked_.data());
  stream_.avail_out = static_cast<uInt>(size);
  while (stream_.avail_out > 0) {
    const int state = has_ended_ ? Z_BUF_ERROR : inflate(&stream_, Z_NO_FLUSH);
    has_ended_ = has_ended_ || state == Z_STREAM_END;
    if (state != Z_OK && !(state == Z_STREAM_END && stream_.avail_out == 0))
      throw damaged("a record holds less than it should");
  }
  return unpacked_;
}

void Record::finish() {
  std::array<Bytef, 1> more{};
  stream_.next_out = more.data();
  stream_.avail_out = 1;
  if (!has_ended_) has_ended_ = inflate(&stream_, Z_NO_FLUSH) == Z_STREAM_END;
  if (!has_ended_ || stream_.avail_out == 0 || stream_.avail_in > 0)
    throw damaged("a record holds more than it should");
}

void PartUnpacker::fill(std::span<char> bytes) {
  std::size_t have = 0;
  while (have < bytes.size()) {
    const std::size_t count = give_(bytes.subspan(have));
    if (count == 0) throw damaged("it is cut off");
    have += count;
  }
  sum_ = static_cast<std::uint32_t>(
      crc32(sum_, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string PartUnpacker::text(std::size_t size) {
  std::string text;
  while (text.size() < size) {
    const std::size_t have = text.size();
    text.resize(have + std::min(kAtOnce, size - have));
    fill(std::span(text).subspan(have));
  }
  return text;
}

std::uint32_t PartUnpacker::number() { return Unpacker(text(4)).word<std::uint32_t>(); }

// The version is a number of any length: what is not 1 is newer.
void PartUnpacker::check_magic() {
  std::string magic(kMagic.size(), '\0');
  std::size_t have = 0;
  while (have < magic.size()) {
    const std::size_t count = give_(std::span(magic).subspan(have));
    if (count == 0) break;
    have += count;
  }
  if (!std::string_view(magic).starts_with(kFamily)) throw WrongPart{"is no .kstock"};
  if (have < magic.size()) throw damaged("it is cut off");
  if (magic == kMagic) {
    sum_ = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(magic.data()), static_cast<uInt>(magic.size())));
    return;
  }
  const char version = magic[kFamily.size()];
  if (version < '0' || version > '9') throw WrongPart{"is no .kstock"};
  throw WrongPart{"was written by a newer Kerf: this one reads KSTOCK1"};
}

std::string PartUnpacker::head() {
  check_magic();
  const std::size_t size = number();
  if (size > kLargestHead) throw damaged("its head is too long");
  return text(size);
}

void PartUnpacker::hold(double bytes) {
  held_ += bytes;
  if (held_ <= static_cast<double>(most_bytes_)) return;
  throw WrongPart{"needs more than the " +
                  std::to_string(static_cast<std::size_t>(
                      std::floor(static_cast<double>(most_bytes_) / kMebibyte))) +
                  " MiB that there are for it"};
}

void PartUnpacker::finish() {
  const std::uint32_t sum = sum_;
  if (number() != sum) throw damaged("the sum over its bytes is wrong");
  std::array<char, 1> more{};
  if (give_(more) > 0) throw damaged("bytes follow its end");
}

}  // namespace kerf::stock::saved
